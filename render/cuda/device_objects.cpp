#include "render/cuda/device_objects.h"

#include <vector>

#include "render/mesh_trees.h"

namespace enfilade::render::cuda {
namespace {

const accel::OctreeView* copy_octrees(DeviceArrays& arrays, const std::vector<accel::LinkedOctree>& trees) {
    const auto copy = [&](const auto* values, std::size_t count) { return arrays.copy(values, count); };
    std::vector<accel::OctreeView> views;
    for (const accel::LinkedOctree& tree : trees) views.push_back(tree.copied(copy));
    return arrays.copy(views.data(), views.size());
}

const BvhView* copy_bvhs(DeviceArrays& arrays, const std::vector<PlainBvh>& trees, const accel::SceneView& scene,
                         const accel::SceneView& of_device) {
    const auto copy = [&](const auto* values, std::size_t count) { return arrays.copy(values, count); };
    std::vector<BvhView> views;
    for (std::size_t m = 0; m < trees.size(); ++m) {
        const accel::ObjectMesh& mesh = scene.meshes[m];
        const auto* places = reinterpret_cast<const float*>(of_device.mesh_vertices.data() + mesh.first_vertex);
        views.push_back(trees[m].copied(copy, places, of_device.mesh_triangles.data() + mesh.first_triangle));
    }
    return arrays.copy(views.data(), views.size());
}

}  // namespace

DeviceObjects::DeviceObjects(DeviceArrays& arrays, const accel::SceneView& scene, const accel::SceneView& copy,
                             InsideKind kind, const accel::OctreeOptions& options, const accel::Executor& executor)
    : kind_(kind) {
    const std::size_t before = arrays.bytes();
    const std::vector<bool> used = used_meshes(scene);
    if (kind == InsideKind::Octree) octrees_ = copy_octrees(arrays, build_octrees(scene, used, options, executor));
    else bvhs_ = copy_bvhs(arrays, build_plain_bvhs(scene, used, executor), scene, copy);
    bytes_ = arrays.bytes() - before;
}

}  // namespace enfilade::render::cuda
