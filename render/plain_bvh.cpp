#include "render/plain_bvh.h"

#include <algorithm>
#include <utility>

#include "render/mesh_soundness.h"
#include "render/sah_tree.h"

namespace enfilade::render {
namespace {

std::vector<SahEntry> entries_of(const accel::SceneView& scene, const accel::ObjectMesh& mesh) {
    std::vector<SahEntry> entries;
    entries.reserve(mesh.triangle_count);
    for (std::uint32_t t = 0; t < mesh.triangle_count; ++t) {
        if (!can_be_hit(scene, mesh, t)) continue;
        SahBox box = SahBox::none();
        for (const std::uint32_t corner : scene.mesh_triangles[mesh.first_triangle + t].corners)
            box.add(scene.mesh_vertices[mesh.first_vertex + corner]);
        entries.push_back({box, t});
    }
    return entries;
}

}  // namespace

PlainBvh::PlainBvh(const accel::SceneView& scene, accel::MeshId id, const accel::Executor& executor) {
    const accel::ObjectMesh& mesh = scene.meshes[index(id)];
    places_ = reinterpret_cast<const float*>(scene.mesh_vertices.data() + mesh.first_vertex);
    triangles_ = scene.mesh_triangles.data() + mesh.first_triangle;
    SahTree tree = build_sah_tree(entries_of(scene, mesh), executor);
    if (tree.nodes.empty()) return;
    nodes_ = std::move(tree.nodes);
    order_ = std::move(tree.order);
    std::ranges::copy(tree.box.low, low_);
    std::ranges::copy(tree.box.high, high_);
}

BvhView PlainBvh::view() const {
    return {nodes_.empty() ? nullptr : nodes_.data(),
            order_.data(),
            places_,
            triangles_,
            {low_[0], low_[1], low_[2]},
            {high_[0], high_[1], high_[2]}};
}

}  // namespace enfilade::render
