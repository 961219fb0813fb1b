#pragma once
// Furniture in the model group of a scene file (docs/scene-format.md, m.objects).

#include <string>

#include "accel/scene.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// The objects as JSON, without their meshes: the trace group has those.
[[nodiscard]] std::string furnishing_text(const Furnishing& furnishing);

/// What was written, with meshes taken back from the scene: materials that no triangle uses are gone, otherwise a
/// building with it exports the same bytes again. \throws InputError (F20) where text and scene do not fit together
[[nodiscard]] Furnishing read_furnishing(const std::string& text, const accel::SceneView& scene,
                                         const std::vector<Space>& spaces);

}  // namespace enfilade::modeler
