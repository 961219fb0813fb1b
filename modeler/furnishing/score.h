#pragma once
// How good a place is for a piece.

#include "modeler/furnishing/candidates.h"

namespace enfilade::modeler {

/// The sum of the parts of rules.h, each in [0, 1], by their weights.
[[nodiscard]] double score(const Occupancy& occupancy, const Candidate& candidate, PieceSize size,
                           const ObjectRule& rule);

}  // namespace enfilade::modeler
