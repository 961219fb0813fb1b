#include <vector>

#include "render/mesh_trees.h"
#include "render/object_rays.h"
#include "render/object_tracer.h"
#include "render/octree_objects.h"
#if defined(ENFILADE_HAS_EMBREE)
#include "render/embree_objects.h"
#endif

namespace enfilade::render {
namespace {

void nearest(const void* state, accel::MeshId mesh, ObjectRay& ray) {
    bvh_walk<false>(static_cast<const BvhView*>(state)[static_cast<std::uint32_t>(mesh)], ray);
}

bool blocked(const void* state, accel::MeshId mesh, const ObjectRay& ray) {
    ObjectRay asked = ray;
    return bvh_walk<true>(static_cast<const BvhView*>(state)[static_cast<std::uint32_t>(mesh)], asked);
}

void nearest16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const BvhView& bvh = static_cast<const BvhView*>(state)[static_cast<std::uint32_t>(mesh)];
    one_by_one(valid, rays, [&](ObjectRay& ray) { return bvh_walk<false>(bvh, ray); });
}

std::uint32_t blocked16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const BvhView& bvh = static_cast<const BvhView*>(state)[static_cast<std::uint32_t>(mesh)];
    return blocked_one_by_one(valid, rays, [&](ObjectRay& ray) { return bvh_walk<true>(bvh, ray); });
}

class PlainObjects final : public ObjectAccel {
public:
    PlainObjects(const accel::SceneView& scene, const std::vector<bool>& used, const accel::Executor& executor)
        : trees_(build_plain_bvhs(scene, used, executor)) {
        for (const PlainBvh& tree : trees_) views_.push_back(tree.view());
    }

    [[nodiscard]] ObjectTracer tracer() const override {
        return {views_.data(), &nearest, &nearest16, &nearest16, &blocked, &blocked16};
    }
    [[nodiscard]] std::string_view name() const override { return "plain"; }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = views_.size() * (sizeof(BvhView) + sizeof(PlainBvh));
        for (const PlainBvh& tree : trees_) sum += tree.bytes();
        return sum;
    }

private:
    std::vector<PlainBvh> trees_;
    std::vector<BvhView> views_;
};

}  // namespace

std::unique_ptr<ObjectAccel> build_object_accel(const accel::SceneView& scene, ObjectAccelKind kind,
                                                const accel::Executor& executor, const accel::OctreeOptions& octrees) {
    const std::vector<bool> used = used_meshes(scene);
#if defined(ENFILADE_HAS_EMBREE)
    if (kind == ObjectAccelKind::Automatic) kind = ObjectAccelKind::Bvh;
    if (kind == ObjectAccelKind::Bvh) return detail::build_embree_objects(scene, used, executor);
#else
    if (kind == ObjectAccelKind::Automatic) kind = ObjectAccelKind::Octree;
#endif
    if (kind == ObjectAccelKind::Octree) return detail::build_octree_objects(scene, used, octrees, executor);
    return std::make_unique<PlainObjects>(scene, used, executor);
}

}  // namespace enfilade::render
