#include "render/octree_objects.h"

#include "accel/octree/linked_octree.h"
#include "render/mesh_soundness.h"
#include "render/object_rays.h"
#include "render/octree_walk.h"

namespace enfilade::render::detail {
namespace {

constexpr std::uint32_t large_mesh = 1 << 16;  ///< triangles: cores share the work on one

const accel::OctreeView& tree_of(const void* state, accel::MeshId mesh) {
    return static_cast<const accel::OctreeView*>(state)[static_cast<std::uint32_t>(mesh)];
}

void nearest(const void* state, accel::MeshId mesh, ObjectRay& ray) {
    NoOctreeEvents events;
    octree_walk<false>(tree_of(state, mesh), ray, events);
}

bool blocked(const void* state, accel::MeshId mesh, const ObjectRay& ray) {
    NoOctreeEvents events;
    ObjectRay asked = ray;
    return octree_walk<true>(tree_of(state, mesh), asked, events);
}

void nearest16(const void* state, accel::MeshId mesh, const std::int32_t* valid, ObjectRays& rays) {
    const accel::OctreeView& tree = tree_of(state, mesh);
    one_by_one(valid, rays, [&](ObjectRay& ray) {
        NoOctreeEvents events;
        return octree_walk<false>(tree, ray, events);
    });
}

class OctreeObjects final : public ObjectAccel {
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
    }

    [[nodiscard]] ObjectTracer tracer() const override {
        return {views_.data(), &nearest, &nearest16, &nearest16, &blocked};
    }
    [[nodiscard]] std::string_view name() const override { return "octree"; }
    [[nodiscard]] std::size_t bytes() const override {
        std::size_t sum = views_.size() * (sizeof(accel::OctreeView) + sizeof(accel::LinkedOctree));
        for (const accel::LinkedOctree& tree : trees_) sum += tree.bytes();
        return sum;
    }

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
};

}  // namespace

std::unique_ptr<ObjectAccel> build_octree_objects(const accel::SceneView& scene, const std::vector<bool>& used,
                                                  const accel::OctreeOptions& options,
                                                  const accel::Executor& executor) {
    return std::make_unique<OctreeObjects>(scene, used, options, executor);
}

}  // namespace enfilade::render::detail
