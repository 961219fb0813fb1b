#include "render/rope_objects.h"

#include "accel/octree/octree_stats.h"
#include "accel/octree/rope_octree.h"
#include "render/mesh_trees.h"
#include "render/object_rays.h"
#include "render/octree_counter.h"
#include "render/rope_walk.h"

namespace enfilade::render::detail {
namespace {

const accel::RopeView& tree_of(const void* state, accel::MeshId mesh) {
    return static_cast<const accel::RopeView*>(state)[static_cast<std::uint32_t>(mesh)];
}

template <class T>
void nearest(const void* state, accel::MeshId mesh, ObjectRay& ray) {
    NoRopeEvents events;
    rope_walk<T, false>(tree_of(state, mesh), ray, events);
}

template <class T>
bool blocked(const void* state, accel::MeshId mesh, const ObjectRay& ray) {
    NoRopeEvents events;
    ObjectRay asked = ray;
    return rope_walk<T, true>(tree_of(state, mesh), asked, events);
}

template <class T>
void nearest16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    NoRopeEvents events;
    one_by_one(valid, rays, [&](ObjectRay& ray) { return rope_walk<T, false>(tree_of(state, mesh), ray, events); });
}

template <class T>
std::uint32_t blocked16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    NoRopeEvents events;
    return blocked_one_by_one(valid, rays,
                              [&](ObjectRay& ray) { return rope_walk<T, true>(tree_of(state, mesh), ray, events); });
}

/// The walk's events: leaves and blocks, without what befell it.
struct CountedRopes : NoRopeEvents {
    OctreeWork& work;
    explicit CountedRopes(OctreeWork& counted) : work(counted) {}
    void entered_leaf(std::uint32_t leaf, std::uint32_t triangles) { work.entered_leaf(leaf, triangles); }
};

class RopeObjects final : public ObjectAccel, public OctreeCounter {
public:
    RopeObjects(const accel::SceneView& scene, const std::vector<bool>& used, const accel::OctreeOptions& options,
                const accel::Executor& executor)
        : trees_(scene.meshes.size()), figures_(scene.meshes.size()), walks_in_double_(options.walks_in_double) {
        build_for_used(scene, used, executor, [&](std::size_t m, const accel::Executor& cores) {
            const accel::ObjectMesh& mesh = scene.meshes[m];
            const std::vector<std::uint32_t> sound = sound_triangles(scene, mesh);
            const accel::MeshPart part = mesh_part(scene, mesh, sound);
            const accel::Octree tree = accel::build_octree(part, options, cores);
            figures_[m].add(accel::octree_stats(tree));
            trees_[m] = {tree, part, {options.is_balanced, options.has_stored_boxes}, cores};
        });
        for (const accel::RopeOctree& tree : trees_) views_.push_back(tree.view());
    }

    [[nodiscard]] ObjectTracer tracer() const override {
        return walks_in_double_ ? tracer_in<double>() : tracer_in<float>();
    }
    [[nodiscard]] std::string_view name() const override { return "ropes"; }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = views_.size() * (sizeof(accel::RopeView) + sizeof(accel::RopeOctree));
        for (const accel::RopeOctree& tree : trees_) sum += tree.bytes().total();
        return sum;
    }
    [[nodiscard]] const OctreeCounter* octrees() const override { return this; }
    void nearest_counted(accel::MeshId mesh, ObjectRay& ray, OctreeWork& work) const override {
        CountedRopes events{work};
        if (walks_in_double_) rope_walk<double, false>(tree_of(views_.data(), mesh), ray, events);
        else rope_walk<float, false>(tree_of(views_.data(), mesh), ray, events);
    }
    [[nodiscard]] accel::OctreeFigures figures() const override {
        accel::OctreeFigures sum;
        for (const accel::OctreeFigures& figures : figures_) sum.add(figures);
        return sum;
    }

private:
    template <class T>
    [[nodiscard]] ObjectTracer tracer_in() const {
        return {views_.data(), &nearest<T>, &nearest16<T>, &nearest16<T>, &blocked<T>, &blocked16<T>};
    }

    std::vector<accel::RopeOctree> trees_;
    std::vector<accel::RopeView> views_;
    std::vector<accel::OctreeFigures> figures_;  ///< [mesh]
    bool walks_in_double_;
};

}  // namespace

std::unique_ptr<ObjectAccel> build_rope_objects(const accel::SceneView& scene, const std::vector<bool>& used,
                                                const accel::OctreeOptions& options, const accel::Executor& executor) {
    return std::make_unique<RopeObjects>(scene, used, options, executor);
}

}  // namespace enfilade::render::detail
