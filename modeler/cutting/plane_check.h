#pragma once
// Whether rounding left the pieces of a polygon apart.

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// Whether the sides of all pieces meet only in common ends, and every piece has a positive area and visits no point
/// twice: then, as cuts are run once in each direction, the pieces are discs that cover the polygon once. Exact. Only
/// cuts, and sides on which new points lie, are compared with all others. `points`: given and new ones.
[[nodiscard]] bool is_plane(std::span<const plans::GridPoint> points, std::uint32_t given_point_count,
                            const Partition& partition);

}  // namespace enfilade::modeler
