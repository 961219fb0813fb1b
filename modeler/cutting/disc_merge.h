#pragma once
// Pieces put together again as far as they stay discs.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// Takes cuts out of a partition, the longest first, while the pieces beside them are a disc together. New points at
/// which no cut is left vanish from the rings. `points`: those of the polygon.
[[nodiscard]] Partition merge_to_discs(std::span<const plans::GridPoint> points, Partition pieces);

}  // namespace enfilade::modeler
