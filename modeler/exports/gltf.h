#pragma once
// A scene as binary glTF 2.0, which most 3D programs open.

#include <string>

#include "accel/scene.h"

namespace enfilade::modeler {

/// The bytes of a .glb file: one node a storey, under it one node a room (door, window, ...) with its name, its label
/// and its area; one mesh a node, one primitive a material. Metres, y up as glTF asks; the sky is left out. Throws
/// InputError where it would be larger than 4 GiB.
[[nodiscard]] std::string to_glb(const accel::SceneView& scene);

}  // namespace enfilade::modeler
