#pragma once
// Inside of accel: what bounds a lamp's light behind a portal.

#include <array>
#include <vector>

#include "accel/beam_step.h"
#include "accel/lights/light_trees.h"

namespace enfilade::accel::detail {

/// Adds the planes through `lamp` (metres, scene frame) and the edges of the portal by which the step came to its cell.
/// Inner sides are those of the light that passes. \pre step.depth > 0
void add_portal_planes(const SceneView& view, const std::array<double, 3>& lamp, const BeamStep& step,
                       std::int64_t margin, std::vector<BeamPlane>& planes);

}  // namespace enfilade::accel::detail
