#pragma once
// A scene as binary glTF 2.0, which most 3D programs open.

#include <string>

#include "accel/scene.h"
#include "modeler/exports/fittings.h"

namespace enfilade::modeler {

/// The bytes of a .glb file: one node a storey, under it one node a room (door, window, ...) with its name, its label
/// and its area; one mesh a node, one primitive a material. The scene's lamps are point lights (KHR_lights_punctual,
/// candela); objects of the scene are nodes of the meshes that they share, under their room, or, where it has none, the
/// plan's furniture is boxes that share one mesh a model and colour. Metres, y up as glTF asks; the sky is left
/// out. About 130 bytes a triangle and 400 a room. Throws InputError where it would be larger than 4 GiB.
/// `fittings`: fittings(read_model(scene)); a stripped scene has none.
[[nodiscard]] std::string to_glb(const accel::SceneView& scene, const Fittings& fittings = {});

}  // namespace enfilade::modeler
