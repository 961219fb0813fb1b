#include "render/mesh_trees.h"

namespace enfilade::render {

std::vector<bool> used_meshes(const accel::SceneView& scene) {
    std::vector<bool> used(scene.meshes.size(), false);
    for (const accel::ObjectId object : scene.cell_objects) used[index(scene.objects[index(object)].mesh)] = true;
    return used;
}

std::vector<accel::LinkedOctree> build_octrees(const accel::SceneView& scene, const std::vector<bool>& used,
                                               const accel::OctreeOptions& options, const accel::Executor& executor) {
    std::vector<accel::LinkedOctree> trees(scene.meshes.size());
    build_for_used(scene, used, executor, [&](std::size_t m, const accel::Executor& cores) {
        const std::vector<std::uint32_t> sound = sound_triangles(scene, scene.meshes[m]);
        const accel::MeshPart part = mesh_part(scene, scene.meshes[m], sound);
        trees[m] = {accel::build_octree(part, options, cores), part, cores};
    });
    return trees;
}

std::vector<PlainBvh> build_plain_bvhs(const accel::SceneView& scene, const std::vector<bool>& used,
                                       const accel::Executor& executor) {
    std::vector<PlainBvh> trees(scene.meshes.size());
    build_for_used(scene, used, executor, [&](std::size_t m, const accel::Executor& cores) {
        trees[m] = PlainBvh(scene, static_cast<accel::MeshId>(m), cores);
    });
    return trees;
}

}  // namespace enfilade::render
