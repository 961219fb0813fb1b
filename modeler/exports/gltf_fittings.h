#pragma once
// The plan's furniture as nodes of a glTF file.

#include <cstddef>
#include <vector>

#include "modeler/exports/fittings.h"
#include "modeler/exports/gltf_file.h"

namespace enfilade::modeler {

/// A node for each piece of furniture: a box by translation, rotation and scale of a mesh that all pieces of one model
/// and colour share. `storey_nodes`: the node
/// under which those of each storey hang, with its `children`.
void add_fittings(const Fittings& fittings, const std::vector<std::size_t>& storey_nodes, GltfFile& file);

}  // namespace enfilade::modeler
