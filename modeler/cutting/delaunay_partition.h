#pragma once
// Cutting a polygon with holes along diagonals of its constrained Delaunay triangulation.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

enum class PartitionGoal {
    Disc,    ///< simply connected, no point visited twice
    Convex,  ///< no reflex corner (`reflex_corner`)
};

/// Cuts the polygon bounded by `sides` along diagonals of its constrained Delaunay triangulation, taking diagonals out
/// again, first those within two grid units of a corner, then the longest, while the pieces keep the goal (Hertel and
/// Mehlhorn 1983 for convex pieces: at most four times the least number of them). No new points. A polygon that meets
/// the goal comes back whole. \pre sides form closed loops and do not cross. Cost: n log n.
[[nodiscard]] Partition delaunay_partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                                           PartitionGoal goal);

}  // namespace enfilade::modeler
