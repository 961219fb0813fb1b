#include "render/octree_objects.h"

#include "render/mesh_trees.h"
#include "render/octree_counter.h"
#include "render/octree_kernels.h"
#include "render/octree_walk.h"
#include "render/rope_objects.h"

namespace enfilade::render::detail {
namespace {

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

std::uint32_t blocked16(const void* given, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const auto& state = *static_cast<const State*>(given);
    return state.kernels->blocked16(tree_of(state, mesh), valid, rays);
}

class OctreeObjects final : public ObjectAccel, public OctreeCounter {
public:
    OctreeObjects(const accel::SceneView& scene, const std::vector<bool>& used, const accel::OctreeOptions& options,
                  const accel::Executor& executor)
        : trees_(build_octrees(scene, used, options, executor)) {
        for (const accel::LinkedOctree& tree : trees_) views_.push_back(tree.view());
        const OctreeKernels* lanes = octree_lane_kernels();
        state_ = {lanes != nullptr ? lanes : &octree_kernels(), views_.data()};
    }

    [[nodiscard]] ObjectTracer tracer() const override {
        return {&state_, &nearest, &nearest16, &nearest16_apart, &blocked, &blocked16};
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
