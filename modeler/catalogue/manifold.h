#pragma once
// Whether triangles are one surface wherever they meet.

#include <string>

#include "modeler/catalogue/object_mesh.h"

namespace enfilade::modeler {

/// Why the mesh is no oriented manifold, with or without rim, or empty where it is: a triangle with two corners at one
/// vertex, an edge that two triangles run along the same way (or three share), a vertex where sheets meet that share no
/// edge there. Vertices count as they are numbered.
[[nodiscard]] std::string why_no_manifold(const ObjectMesh& mesh);

}  // namespace enfilade::modeler
