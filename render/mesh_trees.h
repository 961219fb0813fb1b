#pragma once
// Building a structure for each mesh that objects use.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/mesh_soundness.h"
#include "render/plain_bvh.h"

namespace enfilade::render {

/// Triangles of a mesh that can be hit, ascending.
inline std::vector<std::uint32_t> sound_triangles(const accel::SceneView& scene, const accel::ObjectMesh& mesh) {
    std::vector<std::uint32_t> sound;
    sound.reserve(mesh.triangle_count);
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t)
        if (can_be_hit(scene, mesh, t)) sound.push_back(t);
    return sound;
}

/// A mesh as builders of octrees see it. sound: sound_triangles of it, which must outlive the part
inline accel::MeshPart mesh_part(const accel::SceneView& scene, const accel::ObjectMesh& mesh,
                                 const std::vector<std::uint32_t>& sound) {
    return {scene.mesh_vertices.data() + mesh.first_vertex, scene.mesh_triangles.data() + mesh.first_triangle, sound};
}

/// Calls build(mesh number, executor for it) for each mesh that is used: small ones side by side, each on one core,
/// then large ones, each on all of them. used: [mesh count]
template <class Build>
void build_for_used(const accel::SceneView& scene, const std::vector<bool>& used, const accel::Executor& executor,
                    const Build& build) {
    constexpr std::uint32_t large_mesh = 1 << 16;
    const auto is_large = [&](std::size_t mesh) { return scene.meshes[mesh].triangle_count >= large_mesh; };
    executor.run(used.size(), [&](std::size_t mesh) {
        if (used[mesh] && !is_large(mesh)) build(mesh, accel::SerialExecutor());
    });
    for (std::size_t mesh = 0; mesh < used.size(); ++mesh)
        if (used[mesh] && is_large(mesh)) build(mesh, executor);
}

/// [mesh] whether an object uses it that some cell lists: others are never asked.
[[nodiscard]] std::vector<bool> used_meshes(const accel::SceneView& scene);

/// An octree for each mesh that is used; the others are empty. used: [mesh count]
[[nodiscard]] std::vector<accel::LinkedOctree> build_octrees(const accel::SceneView& scene,
                                                             const std::vector<bool>& used,
                                                             const accel::OctreeOptions& options,
                                                             const accel::Executor& executor);

/// A tree of boxes for each mesh that is used. The scene's memory must outlive them.
[[nodiscard]] std::vector<PlainBvh> build_plain_bvhs(const accel::SceneView& scene, const std::vector<bool>& used,
                                                     const accel::Executor& executor);

}  // namespace enfilade::render
