#pragma once
// Meshes of fewer triangles.

#include <cstdint>

#include "modeler/catalogue/catalogue.h"

namespace enfilade::modeler {

/// Brings the mesh down to `triangles` by collapsing edges (quadric errors, OpenMesh), if OpenMesh takes every triangle
/// of it but those with two corners at one vertex, which nobody can see: none twice, no edge of three, no vertex where
/// two sheets meet. Vertices stay where they are, materials stay on their triangles and their borders in place; normals
/// turn by less than 90 degrees. Textures go: their mean colours show.
/// `error` is `surface_distance`. Where the mesh is refused, or cannot be brought down so
/// far, `refused` says why, and what was reached is what there is. 0 triangles: nothing is done.
[[nodiscard]] LoadedMesh decimated(ObjectMesh mesh, std::uint32_t triangles);

}  // namespace enfilade::modeler
