#pragma once
// Furniture of a scene as nodes of a glTF file.

#include <cstddef>
#include <vector>

#include "accel/scene.h"
#include "modeler/exports/gltf_file.h"

namespace enfilade::modeler {

/// A node for each object, named and placed, under the node of its space (`space_nodes`, [space], with `children`).
/// Objects of one mesh and colour share a mesh of the file; one whose placement shears (a tilted piece may) has a mesh
/// of its own, for nodes of glTF can not. Objects without triangles are nodes without a mesh.
void add_objects(const accel::SceneView& scene, const std::vector<std::size_t>& space_nodes, GltfFile& file);

}  // namespace enfilade::modeler
