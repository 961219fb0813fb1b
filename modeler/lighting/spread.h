#pragma once
// Lamps evenly over a room, whatever its shape.

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "plans/vector2.h"

namespace enfilade::modeler {

/// What lamps are spread over. Metres.
struct SpreadRegion {
    std::vector<std::array<plans::Point, 2>> sides;  ///< of the outline and of holes
    double area = 0;
    std::function<bool(plans::Point, double)> is_free;  ///< whether a lamp may hang there, so far from all else
};

/// `count` places: a grid along the walls where the region is a rectangle that such a grid suits, as far from its walls
/// as half of their distance from each other; else the means of as many parts of it that are equally near to them
/// (Lloyd 1982), which for a corridor lie along its middle line. All are free, as far from walls as 0.3 m where there
/// is room for that. Fewer where the region has no such many; nearest to the origin of its longest walls first.
/// is_exact: grids of another number than `count` do not suit. Deterministic. Cost: count^2, or count * log from 200 on
[[nodiscard]] std::vector<plans::Point> spread(const SpreadRegion& region, std::size_t count, bool is_exact);

}  // namespace enfilade::modeler
