#pragma once
// Lamps of a scene as nodes of a glTF file.

#include <cstddef>
#include <functional>
#include <string>

#include "accel/scene.h"
#include "modeler/exports/gltf_file.h"

namespace enfilade::modeler {

/// A node with a point light (KHR_lights_punctual, candela) for each lamp of the scene, from the plan or by rule:
/// colour times intensity is the lamp's intensity by linear RGB. `storey_node`: the node under which those of a storey
/// hang, with its `children`; lamps of the site and those in solids hang from the root.
void add_lights(const accel::SceneView& scene, const std::function<std::size_t(const std::string&)>& storey_node,
                GltfFile& file);

}  // namespace enfilade::modeler
