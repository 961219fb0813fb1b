#pragma once
// Inside of accel/octree: the paper's constraint, that neighbours across faces differ by one level at most.

#include "accel/octree/lattice_triangles.h"

namespace enfilade::accel::detail {

/// Splits leaves until it holds, no more than it takes; the triangles of a split leaf are clipped to its octants.
/// `tree` has places in MeshPart::used for references. Leaves stand in Morton order before and after. False: it would
/// take more than `budget` leaves and references, or as much memory; the tree is worth nothing then.
[[nodiscard]] bool balance_octree(Octree& tree, const LatticeTriangles& triangles, std::uint64_t budget);

}  // namespace enfilade::accel::detail
