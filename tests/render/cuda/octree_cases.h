#pragma once
// Meshes, octrees and rays that kernels of single meshes are tried with.

#include <string>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "accel/octree/rope_octree.h"
#include "render/cuda/octree_rays.h"
#include "tests/support/object_scenes.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {

struct NamedMesh {
    std::string name;
    accel::InputMesh mesh;
};

inline accel::InputMesh moved_mesh(accel::InputMesh mesh, float scale, float offset) {
    for (auto& v : mesh.vertices)
        for (float& each : v) each = scale * each + offset;
    return mesh;
}

/// Compact, flat, scattered; huge and tiny; with one triangle and with none that can be hit.
inline std::vector<NamedMesh> octree_case_meshes() {
    return {{"ball", ball_mesh(14, 1)},
            {"flat", box_mesh({-1, -0.5f, -0.001f}, {1, 0.5f, 0.001f})},
            {"a plane", soup({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}}})},
            {"soup", random_soup(400, 0.1f, 1)},
            {"huge", moved_mesh(ball_mesh(6, 1), 1e15f, 3e15f)},
            {"tiny", moved_mesh(ball_mesh(6, 1), 1e-15f, 1e-15f)},
            {"one triangle", soup({{{{0, 0, 0}, {1, 0, 0.5f}, {0, 1, 0.25f}}}})},
            {"no triangle", soup({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}})}};
}

/// By cost, one leaf, shallow and deep; deeper than ten levels, where places take 64 bits.
inline std::vector<accel::OctreeOptions> octree_case_options() {
    return {{}, {.depth = 0}, {.depth = 6, .leaf_size = 2}, {.depth = 11, .leaf_size = 1}};
}

inline render::cuda::OctreeRay device_ray(const render::ObjectRay& ray) {
    return {{ray.origin_x, ray.origin_y, ray.origin_z},
            ray.near,
            {ray.direction_x, ray.direction_y, ray.direction_z},
            ray.far};
}

/// So many of each family.
inline std::vector<render::ObjectRay> octree_case_rays(const TriedMesh& mesh, const accel::OctreeFrame& frame,
                                                       int each) {
    std::vector<render::ObjectRay> rays;
    if (mesh.used().empty()) {
        for (int i = 0; i < each; ++i) rays.push_back(object_ray({0, 0, -1}, {0.1 * i, 0, 1}, 0, 100));
        return rays;
    }
    OctreeRays drawn(mesh, frame, 11);
    for (const NamedOctreeRays& family : octree_ray_families)
        for (int i = 0; i < each; ++i) rays.push_back(drawn.take(family.family));
    return rays;
}

}  // namespace enfilade::test
