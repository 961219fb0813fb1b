#pragma once
// Where wall ends meet, and how each end is shaped there. Internal to `outlines`.

#include <array>
#include <cstdint>
#include <vector>

#include "plans/outline.h"

namespace enfilade::plans {

/// The shape of one wall end, seen by who leaves the joint along the wall.
struct EndShape {
    Point left;                  ///< where the left face begins
    Point right;                 ///< where the right face begins
    std::vector<Point> between;  ///< from left to right: what the end covers of its neighbour's outer corner, the joint
};

struct Joints {
    std::vector<std::array<EndShape, 2>> ends;  ///< [wall]: start, end
    std::vector<FreeEnd> free_ends;
    std::vector<Continuation> continuations;
};

/// Moves ends that lie within `join` of each other to one place. `starts`, `finishes`: [wall], relative to the
/// origin; walls that `skip` names take no part.
void gather_ends(std::vector<Point>& starts, std::vector<Point>& finishes, const std::vector<bool>& skip, double join);

/// Shapes all ends. \pre equal places are equal points (`gather_ends`)
[[nodiscard]] Joints shape_ends(const std::vector<WallOutline>& walls, const std::vector<std::string>& ids,
                                double join);

}  // namespace enfilade::plans
