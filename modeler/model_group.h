#pragma once
// The building inside a scene file: typed arrays that `accel` carries without looking at them.

#include <vector>

#include "accel/scene.h"
#include "accel/scene_input.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// The plan as canonical JSON, alpha arrays, cell ids, integer points, labels, parents (1-architecture, decision 7;
/// arrays and their columns: docs/scene-format.md).
[[nodiscard]] std::vector<accel::InputModelArray> model_group(const Building& building);

/// The building that was written, but for its stack: it can be checked and exported again, not cut anew.
/// Throws InputError for a stripped scene, and for one whose model arrays do not fit together.
[[nodiscard]] Building read_model(const accel::Scene& scene);

}  // namespace enfilade::modeler
