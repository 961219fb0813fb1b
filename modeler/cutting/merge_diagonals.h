#pragma once
// Taking out the diagonals of a partition that its pieces can do without.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// The merging process of Fernandez, Canovas, Pelegrin 2000 ("Algorithms for the decomposition of a polygon into convex
/// polygons", EJOR 121): the diagonals, those within `least_gap` of another corner first and then in the
/// order of their lines, are taken out where the two pieces beside one make a convex piece together. Cut lines of the
/// result count from `first_cut_line` without a gap. \pre pieces of one disc; every cut is a whole diagonal with a line
/// of its own. \post pieces have no new `reflex_corner`. Cost: linear, but for walks along straight runs.
[[nodiscard]] Partition merge_diagonals(std::span<const plans::GridPoint> points, Partition pieces);

}  // namespace enfilade::modeler
