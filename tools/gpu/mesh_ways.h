#pragma once
// The ways by which a device meets single meshes: everybody who takes part stands in one table (mesh_ways.cpp), a line
// each.

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "accel/octree/linked_octree.h"
#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/cuda/octree_rays.h"

namespace enfilade::tools::gpu {

/// Octrees that are measured.
enum class MeshTree {
    Ours,          ///< as deep as pays on a device
    OursOfHost,    ///< as deep as pays on a processor
    PaperFree,     ///< Portalez and Duguet's depth and leaves
    PaperBalanced  ///< the same with neighbours of one level's difference, as they have it
};

/// The first mesh of a scene on the host, and its octrees, built when they are first asked for. The scene's memory must
/// outlive it.
class MeshOnHost {
public:
    MeshOnHost(const accel::SceneView& scene, const accel::Executor& executor);
    MeshOnHost(const MeshOnHost&) = delete;
    MeshOnHost& operator=(const MeshOnHost&) = delete;

    [[nodiscard]] const accel::SceneView& scene() const { return scene_; }
    [[nodiscard]] const accel::ObjectMesh& mesh() const { return scene_.meshes[0]; }
    [[nodiscard]] const accel::MeshPart& part() const { return part_; }
    [[nodiscard]] const accel::Executor& executor() const { return executor_; }
    [[nodiscard]] const accel::Octree& tree(MeshTree kind) const;
    [[nodiscard]] const accel::LinkedOctree& linked(MeshTree kind) const;
    /// Its arrays on a device, ours with the table of leaves that pays there.
    [[nodiscard]] render::cuda::OctreeArrays uploaded(render::cuda::Device& device, MeshTree kind) const;

private:
    accel::SceneView scene_;
    const accel::Executor& executor_;
    std::vector<std::uint32_t> sound_;
    accel::MeshPart part_;
    mutable std::map<MeshTree, accel::Octree> trees_;
    mutable std::map<MeshTree, accel::LinkedOctree> linked_;
};

/// Rays of the mesh's own space on a device, and room for the answers of those who have none of their own.
struct MeshRays {
    /// normals: whether diffuse rays will go on from there
    MeshRays(render::cuda::Device& device, std::size_t count, bool has_normals) : batch(device, count, has_normals) {}
    /// The same rays for who does not read `batch`. Call it once they are made.
    void copy(render::cuda::Device& device);

    render::cuda::OctreeRays batch;
    render::cuda::Buffer<render::cuda::OctreeRay> rays;
    render::cuda::Buffer<render::cuda::OctreeAnswer> answers;
};

/// A mesh on a device, ready for rays.
class MeshMaker {
public:
    virtual ~MeshMaker() = default;
    virtual void nearest(MeshRays& rays) = 0;
    /// What nearest answered last.
    [[nodiscard]] virtual std::vector<render::cuda::OctreeAnswer> answers(const MeshRays& rays) const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

struct MeshWay {
    std::string name;
    bool is_ours;   ///< else a baseline
    bool is_exact;  ///< the scalar walk's formulas in their order: on the host the same bits
    MeshTree tree;  ///< that the scalar walk has, too
    std::function<std::unique_ptr<MeshMaker>(render::cuda::Device& device, const MeshOnHost& mesh)> open;
};

[[nodiscard]] const std::vector<MeshWay>& mesh_ways();

}  // namespace enfilade::tools::gpu
