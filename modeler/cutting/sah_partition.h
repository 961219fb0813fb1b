#pragma once
// Cutting a polygon with holes into few convex pieces that rays walk through at least cost.

#include "modeler/cutting/cut_cost.h"
#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

struct SahOptions {
    CutCost cost;
    double unit = 1.0 / 8192;  ///< metres per grid unit
    double height = 2.5;       ///< metres, of the room: weighs its floor against its walls
};

/// Cuts from each reflex corner: prolonging one of its sides, to a corner in sight, square to a wall, along the box of
/// a curved wall; the one that saves most of the cuts still to come goes first (README.md of this folder). Cuts may end
/// in the middle of sides and of other cuts, at a new point rounded to the grid. \pre sides form closed loops and do
/// not cross. \post pieces sum to the polygon; `reflex_corner` finds none in a piece if the goal is Convex. Cost: n log
/// n.
[[nodiscard]] Partition sah_partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                                      PartitionGoal goal, const SahOptions& options);

}  // namespace enfilade::modeler
