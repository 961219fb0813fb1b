#include "render/cuda/bvh_forest.h"

#include <algorithm>
#include <utility>

namespace enfilade::render::cuda {
namespace {

/// In triangles: to enter an object takes some nodes more.
constexpr float instance_cost = 8;

constexpr std::uint32_t large_mesh = 1 << 16;  ///< triangles: built by all cores together

std::vector<bool> used_by(const TriangleScene& scene) {
    std::vector<bool> used(scene.meshes.size(), false);
    for (const std::uint32_t mesh : scene.mesh_of) used[mesh] = true;
    return used;
}

}  // namespace

BvhForest build_forest(const TriangleScene& scene, const BvhForestOptions& options, const accel::Executor& executor) {
    SahOptions sah;
    sah.largest_leaf = options.largest_leaf;
    sah.node_cost = options.node_cost;
    BvhForest forest;
    forest.meshes.resize(scene.meshes.size());
    const std::vector<bool> used = used_by(scene);
    const auto build = [&](std::size_t mesh, const accel::Executor& builders) {
        forest.meshes[mesh] = build_sah_tree(
            triangle_entries(scene, scene.mesh_first[mesh], scene.mesh_first[mesh + 1], options.mesh_split_share),
            builders, sah);
    };
    const auto is_large = [&](std::size_t mesh) {
        return scene.mesh_first[mesh + 1] - scene.mesh_first[mesh] >= large_mesh;
    };
    executor.run(used.size(), [&](std::size_t mesh) {
        if (used[mesh] && !is_large(mesh)) build(mesh, accel::SerialExecutor());
    });
    for (std::size_t mesh = 0; mesh < used.size(); ++mesh)
        if (used[mesh] && is_large(mesh)) build(mesh, executor);

    std::vector<SahEntry> entries = triangle_entries(scene, 0, scene.face_triangles, options.split_share);
    for (std::uint32_t k = 0; k < scene.instances.size(); ++k)
        if (!forest.meshes[scene.mesh_of[k]].nodes.empty())
            entries.push_back({scene.instance_boxes[k], instance_bit | k});
    sah.first_alone = instance_bit;
    sah.alone_cost = instance_cost;
    forest.top = build_sah_tree(std::move(entries), executor, sah);
    return forest;
}

TriangleRecord record_of(const TriangleScene& scene, std::uint32_t item, TriangleTest test) {
    TriangleRecord record = {};
    record.item = item;
    if ((item & instance_bit) != 0) return record;
    const SceneTriangle& t = scene.triangles[item];
    const float a[3] = {t.a.x, t.a.y, t.a.z}, b[3] = {t.b.x, t.b.y, t.b.z}, c[3] = {t.c.x, t.c.y, t.c.z};
    for (int k = 0; k < 3; ++k) {
        record.a[k] = a[k];
        record.b[k] = test == TriangleTest::Fast ? a[k] - b[k] : b[k];
        record.c[k] = test == TriangleTest::Fast ? c[k] - a[k] : c[k];
    }
    return record;
}

std::vector<BvhExtent> extents_of(const TriangleScene& scene, const BvhForest& forest) {
    const auto extent_of = [](const SahBox& box) {
        BvhExtent extent;
        std::ranges::copy(box.low, extent.low);
        std::ranges::copy(box.high, extent.high);
        return extent;
    };
    std::vector<BvhExtent> extents;
    for (const std::uint32_t mesh : scene.mesh_of) extents.push_back(extent_of(forest.meshes[mesh].box));
    extents.push_back(extent_of(forest.top.box));
    return extents;
}

}  // namespace enfilade::render::cuda
