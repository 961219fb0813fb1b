#pragma once
// Whether a closed ring of points of a plane is simple.

#include <cstdint>
#include <span>
#include <vector>

#include "plans/grid.h"

namespace enfilade::modeler {

/// Two edges of a ring; edge k runs from corner k to corner k + 1.
struct RingCrossing {
    std::uint32_t first = 0;
    std::uint32_t second = 0;  ///< above `first`
    friend bool operator==(const RingCrossing&, const RingCrossing&) = default;
    friend auto operator<=>(const RingCrossing&, const RingCrossing&) = default;
};

/// Whether two closed segments have a point in common.
[[nodiscard]] bool segments_meet(plans::GridPoint a, plans::GridPoint b, plans::GridPoint c, plans::GridPoint d);

/// The edges that cross or touch otherwise than neighbours do in their common corner, sorted, at most `most` of them:
/// none where the ring is simple, and bounds a disc. Exact. Cost: n log n and the pairs of edges whose boxes touch;
/// linear for convex rings.
[[nodiscard]] std::vector<RingCrossing> ring_crossings(std::span<const plans::GridPoint> ring, std::size_t most = 64);

}  // namespace enfilade::modeler
