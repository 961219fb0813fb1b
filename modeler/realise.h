#pragma once
// From stacked regions to volumes, faces and the generalized map.

#include "modeler/building.h"
#include "modeler/cutting/cut.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

/// Makes the volumes over the regions of `stack`: cuts them, brings all bands onto one planar graph by a second snap
/// rounding (cuts of one band cross edges of another), and extrudes that into a closed map:
/// a side face over an edge is cut at every level of both its sides, the vertical edge over a point at the levels of
/// all its side faces, and a horizontal face is a face of the overlay of the bands below and above it.
/// The building's `findings` receive what vanished on the grid (P5xx) and what the map builder refused (T codes).
[[nodiscard]] Building realise(Stack stack, const CutOptions& options,
                               const accel::Executor& executor = accel::SerialExecutor());

/// The same from regions that have been cut already. \pre cuts: one for each region of the stack, by these options
[[nodiscard]] Building realise(Stack stack, const CutOptions& options, std::vector<RegionCut> cuts);

}  // namespace enfilade::modeler
