#pragma once
// What a partition costs the rays that walk through it.

#include <span>

#include "modeler/cutting/cut_options.h"
#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// Sum over the pieces of surface (m2; walls over `height`, floor and ceiling) times cost, over the polygon's own
/// surface: the expected cost of a ray, in visits. `unit`: metres per grid unit.
[[nodiscard]] double sah_sum(std::span<const plans::GridPoint> points, const Partition& partition, double unit,
                             double height, const CutCost& cost);

}  // namespace enfilade::modeler
