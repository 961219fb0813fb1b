#pragma once
// Rooms into convex cells.

#include "accel/parallel_for.h"
#include "modeler/building.h"
#include "modeler/cutting/cut_options.h"

namespace enfilade::modeler {

struct ConvexifyOptions {
    Convexifier convexifier = Convexifier::Sah;
    CutCost cost = {};  ///< what `Sah` minimises
};

/// The building with every volume that carries light cut into convex pieces: pieces keep the space and the parent of
/// the volume that they are cut from. The same on any number of cores. \pre the building comes from `build` (it holds
/// its stack).
/// \post no corner of a cell's floor is reflex between different lines (constraint G8)
[[nodiscard]] Building convexify(const Building& building, const ConvexifyOptions& options = {},
                                 const accel::Executor& executor = accel::SerialExecutor());

}  // namespace enfilade::modeler
