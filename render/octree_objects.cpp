#include "render/octree_objects.h"

#include "accel/octree/linked_octree.h"
#include "render/mesh_soundness.h"
#include "render/octree_counter.h"
#include "render/octree_kernels.h"
#include "render/octree_walk.h"
#include "render/rope_objects.h"

namespace enfilade::render::detail {
namespace {

constexpr std::uint32_t large_mesh = 1 << 16;  ///< triangles: cores share the work on one

/// What the functions below are given.
struct State {
    const OctreeKernels* kernels;
    const accel::OctreeView* trees;  ///< [mesh]
};

const accel::OctreeView& tree_of(const State& state, accel::MeshId mesh) {
    return state.trees[static_cast<std::uint32_t>(mesh)];
}

void nearest(const void* given, accel::MeshId mesh, ObjectRay& ray) {
    const auto& state = *static_cast<const State*>(given);
    state.kernels->nearest(tree_of(state, mesh), ray);
}

bool blocked(const void* given, accel::MeshId mesh, const ObjectRay& ray) {
    const auto& state = *static_cast<const State*>(given);
    return state.kernels->blocked(tree_of(state, mesh), ray);
}

void nearest16(const void* given, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const auto& state = *static_cast<const State*>(given);
    state.kernels->nearest16(tree_of(state, mesh), valid, rays);
}

void nearest16_apart(const void* given, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const auto& state = *static_cast<const State*>(given);
    state.kernels->nearest16_apart(tree_of(state, mesh), valid, rays);
}

class OctreeObjects final : public ObjectAccel, public OctreeCounter {
public:
    OctreeObjects(const accel::SceneView& scene, const std::vector<bool>& used, const accel::OctreeOptions& options,
                  const accel::Executor& executor)
        : trees_(scene.meshes.size()) {
        const auto is_large = [&](std::size_t mesh) { return scene.meshes[mesh].triangle_count >= large_mesh; };
        executor.run(trees_.size(), [&](std::size_t mesh) {
            if (used[mesh] && !is_large(mesh)) trees_[mesh] = tree_for(scene, mesh, options, accel::SerialExecutor());
        });
        for (std::size_t mesh = 0; mesh < trees_.size(); ++mesh)
            if (used[mesh] && is_large(mesh)) trees_[mesh] = tree_for(scene, mesh, options, executor);
        for (const accel::LinkedOctree& tree : trees_) views_.push_back(tree.view());
        const OctreeKernels* lanes = octree_lane_kernels();
        state_ = {lanes != nullptr ? lanes : &octree_kernels(), views_.data()};
    }

    [[nodiscard]] ObjectTracer tracer() const override {
        return {&state_, &nearest, &nearest16, &nearest16_apart, &blocked};
    }
    [[nodiscard]] std::string_view name() const override { return "octree"; }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = views_.size() * (sizeof(accel::OctreeView) + sizeof(accel::LinkedOctree));
        for (const accel::LinkedOctree& tree : trees_) sum += tree.bytes();
        return sum;
    }
    [[nodiscard]] const OctreeCounter* octrees() const override { return this; }
    void nearest_counted(accel::MeshId mesh, ObjectRay& ray, OctreeWork& work) const override {
        octree_walk<false>(views_[static_cast<std::uint32_t>(mesh)], ray, work);
    }
    [[nodiscard]] accel::OctreeFigures figures() const override { return accel::octree_figures(views_); }

private:
    static accel::LinkedOctree tree_for(const accel::SceneView& scene, std::size_t m,
                                        const accel::OctreeOptions& options, const accel::Executor& executor) {
        const accel::ObjectMesh& mesh = scene.meshes[m];
        std::vector<std::uint32_t> used;
        used.reserve(mesh.triangle_count);
        for (std::uint32_t t = 0; t < mesh.triangle_count; ++t)
            if (can_be_hit(scene, mesh, t)) used.push_back(t);
        const accel::MeshPart part = {scene.mesh_vertices.data() + mesh.first_vertex,
                                      scene.mesh_triangles.data() + mesh.first_triangle, used};
        return {accel::build_octree(part, options, executor), part, executor};
    }

    std::vector<accel::LinkedOctree> trees_;
    std::vector<accel::OctreeView> views_;
    State state_;
};

}  // namespace

std::unique_ptr<ObjectAccel> build_octree_objects(const accel::SceneView& scene, const std::vector<bool>& used,
                                                  const accel::OctreeOptions& options,
                                                  const accel::Executor& executor) {
    if (options.layout == accel::OctreeLayout::Ropes) return build_rope_objects(scene, used, options, executor);
    return std::make_unique<OctreeObjects>(scene, used, options, executor);
}

}  // namespace enfilade::render::detail
