#pragma once
// Cutting a simple polygon into convex pieces by diagonals, one piece after the other along its boundary.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// Fernandez, Toth, Canovas, Pelegrin 2008 ("A practical algorithm for decomposing polygonal domains into convex
/// polygons by diagonals", TOP 16; the comparator of Maria, Horna, Aveneau 2013, section 6.2.1). A piece starts at a
/// notch (reflex corner) and grows along the boundary, forwards or else backwards, while its corners stay convex, also
/// where the closing diagonal meets its ends; notches of the rest that lie in it or on its border make it shrink from
/// its last corner; it is cut off by the closing diagonal, and so on with the rest; then the merging process takes out
/// the diagonals that are not essential (merge_diagonals.h). Beyond the paper: sides of one line count as straight
/// however rounding bent them, and diagonals keep `least_gap` from other corners wherever some piece allows it. What
/// has no piece to cut off is cut by `delaunay_partition` and counted in `fallen_back`.
///
/// No new points; every choice is deterministic; a cut has a line of its own. \pre `sides` form one ring that visits no
/// point twice. \post pieces sum to the polygon; `reflex_corner` finds none in a piece. Cost: n^2 at most in practice:
/// rests that would take longer are cut by `delaunay_partition` too.
[[nodiscard]] Partition diagonal_partition(std::span<const plans::GridPoint> points,
                                           std::span<const PolygonSide> sides);

}  // namespace enfilade::modeler
