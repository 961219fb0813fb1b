#pragma once
// Cutting a simple polygon into convex pieces by diagonals, one piece after the other along its boundary.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// Fernandez, Toth, Canovas, Pelegrin 2008 ("A practical algorithm for decomposing polygonal domains into convex
/// polygons by diagonals", TOP 16; the comparator of Maria, Horna, Aveneau 2013, section 6.2.1): a piece grows along
/// the boundary from a corner while it stays convex and holds no other corner, is cut off by a diagonal, and so on with
/// the rest; then diagonals that are not needed are taken out again. No new points; every choice is deterministic. \pre
/// `sides` form one ring that visits no point twice. Cost: n^2 at most.
[[nodiscard]] Partition diagonal_partition(std::span<const plans::GridPoint> points,
                                           std::span<const PolygonSide> sides);

}  // namespace enfilade::modeler
