#pragma once
// Which triangles of a mesh can be seen at all.

#include <cstdint>

#include "accel/scene.h"
#include "render/ray.h"

namespace enfilade::render {

/// False for triangles without area and for those whose corners are no places (NaN, infinite, beyond any scene): no
/// ray ever hits them.
inline bool can_be_hit(const accel::SceneView& scene, const accel::ObjectMesh& mesh, std::uint32_t triangle) {
    Vec3d p[3];
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = scene.mesh_triangles[mesh.first_triangle + triangle].corners[k];
        const accel::Vertex& v = scene.mesh_vertices[mesh.first_vertex + corner];
        if (!is_place(Vec3f{v.x, v.y, v.z})) return false;
        p[k] = {v.x, v.y, v.z};
    }
    const Vec3d normal = cross(p[1] - p[0], p[2] - p[0]);
    return normal.x != 0 || normal.y != 0 || normal.z != 0;
}

}  // namespace enfilade::render
