#pragma once
// The textures of a scene, as they were given to it.

#include <memory>
#include <vector>

#include "accel/scene.h"
#include "accel/scene_input.h"

namespace enfilade::modeler {

/// By their numbers in the scene. \pre the scene is valid
[[nodiscard]] std::vector<std::shared_ptr<const accel::InputTexture>> scene_textures(const accel::SceneView& scene);

}  // namespace enfilade::modeler
