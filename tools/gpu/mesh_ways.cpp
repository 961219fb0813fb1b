#include "tools/gpu/mesh_ways.h"

#include "accel/octree/rope_figures.h"
#include "accel/octree/rope_octree.h"
#include "render/mesh_trees.h"
#include "tools/gpu/baselines.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;
using render::cuda::DeviceOctree;
using render::cuda::DeviceOctreeLayout;
using render::cuda::OctreeAnswer;
using render::cuda::OctreeSchedule;
using render::cuda::TriangleLayout;

accel::OctreeOptions options_of(MeshTree kind, std::size_t triangles) {
    if (kind == MeshTree::Ours) return render::cuda::device_octree_options();
    if (kind == MeshTree::OursOfHost) return {};
    accel::OctreeOptions options = accel::paper_options(triangles);
    options.is_balanced = kind == MeshTree::PaperBalanced;
    return options;
}

/// An octree on a device, ours or the paper's.
class Octrees : public MeshMaker {
public:
    Octrees(std::unique_ptr<DeviceOctree> tree, const OctreeSchedule& schedule)
        : tree_(std::move(tree)), schedule_(schedule) {}

    void nearest(MeshRays& rays) override { rays.batch.nearest(*tree_, schedule_); }
    std::vector<OctreeAnswer> answers(const MeshRays& rays) const override { return rays.batch.answers(); }
    std::size_t bytes() const override { return tree_->bytes(); }

private:
    std::unique_ptr<DeviceOctree> tree_;
    OctreeSchedule schedule_;
};

MeshWay ours(const std::string& name, MeshTree kind, const DeviceOctreeLayout& layout, const OctreeSchedule& schedule) {
    const auto open = [=](Device& device, const MeshOnHost& mesh) -> std::unique_ptr<MeshMaker> {
        std::unique_ptr<render::cuda::MeshOnDevice> corners;
        if (layout.triangles == TriangleLayout::Indexed)
            corners = std::make_unique<render::cuda::MeshOnDevice>(device, mesh.part(), mesh.mesh().vertex_count,
                                                                   mesh.mesh().triangle_count);
        auto tree =
            std::make_unique<DeviceOctree>(device, upload_octree(device, mesh.linked(kind)), layout, corners.get());
        return std::make_unique<Octrees>(std::move(tree), schedule);
    };
    return {name, true, true, kind, open};
}

MeshWay papers(const std::string& name, MeshTree kind, bool has_stored_boxes, bool walks_in_double) {
    const auto open = [=](Device& device, const MeshOnHost& mesh) -> std::unique_ptr<MeshMaker> {
        const accel::RopeOctree ropes(mesh.tree(kind), mesh.part(), {kind == MeshTree::PaperBalanced, has_stored_boxes},
                                      mesh.executor());
        return std::make_unique<Octrees>(std::make_unique<DeviceOctree>(device, ropes, walks_in_double),
                                         OctreeSchedule{});
    };
    return {name, true, false, kind, open};
}

/// A tree of boxes over the mesh's own triangles.
class Baseline : public MeshMaker {
public:
    Baseline(Device& device, const MeshOnHost& mesh, const render::cuda::BvhBaselineOptions& options)
        : bvh_(device, mesh.scene(), options, mesh.executor()) {}

    void nearest(MeshRays& rays) override { bvh_.nearest(rays.rays.data(), rays.answers.data(), rays.rays.size()); }
    std::vector<OctreeAnswer> answers(const MeshRays& rays) const override { return rays.answers.read(); }
    std::size_t bytes() const override { return bvh_.tree_bytes(); }

private:
    render::cuda::BvhBaseline bvh_;
};

MeshWay baseline(const BaselineWay& way) {
    const auto open = [way](Device& device, const MeshOnHost& mesh) -> std::unique_ptr<MeshMaker> {
        render::cuda::BvhBaselineOptions options = way.options;
        options.mesh = accel::MeshId{0};
        return std::make_unique<Baseline>(device, mesh, options);
    };
    return {way.name, false, false, MeshTree::Ours, open};
}

std::vector<MeshWay> all_ways() {
    using Kind = OctreeSchedule::Kind;
    constexpr auto columns = TriangleLayout::Columns, records = TriangleLayout::Records,
                   indexed = TriangleLayout::Indexed;
    std::vector<MeshWay> ways = {
        ours("octree: records", MeshTree::Ours, {records}, {.kind = Kind::WhileWhile}),
        ours("octree: records, a leaf a turn", MeshTree::Ours, {records}, {.kind = Kind::PerLeaf}),
        ours("octree: records, tests postponed", MeshTree::Ours, {records}, {.kind = Kind::Postponed}),
        ours("octree: records, persistent 16, 4", MeshTree::Ours, {records},
             {.kind = Kind::Persistent, .ready = 16, .idle = 4}),
        ours("octree: records, persistent 24, 12", MeshTree::Ours, {records},
             {.kind = Kind::Persistent, .ready = 24, .idle = 12}),
        ours("octree: records, persistent 32, 16", MeshTree::Ours, {records},
             {.kind = Kind::Persistent, .ready = 32, .idle = 16}),
        ours("octree: records, leaves of 32 bytes", MeshTree::Ours, {records, false}, {.kind = Kind::WhileWhile}),
        ours("octree: columns", MeshTree::Ours, {columns}, {.kind = Kind::WhileWhile}),
        ours("octree: columns, a leaf a turn", MeshTree::Ours, {columns}, {.kind = Kind::PerLeaf}),
        ours("octree: indexed", MeshTree::Ours, {indexed}, {.kind = Kind::WhileWhile}),
        ours("octree: indexed, a leaf a turn", MeshTree::Ours, {indexed}, {.kind = Kind::PerLeaf}),
        ours("octree: records, split as for a processor", MeshTree::OursOfHost, {records}, {.kind = Kind::WhileWhile}),
        ours("octree: records, split as the paper's", MeshTree::PaperFree, {records}, {.kind = Kind::WhileWhile}),
        papers("the paper's: balanced, stored boxes", MeshTree::PaperBalanced, true, false),
        papers("the paper's: balanced, stored boxes, double", MeshTree::PaperBalanced, true, true),
        papers("the paper's: balanced, computed boxes", MeshTree::PaperBalanced, false, false),
        papers("the paper's: free, computed boxes", MeshTree::PaperFree, false, false),
    };
    for (const BaselineWay& way : baseline_ways()) ways.push_back(baseline(way));
    return ways;
}

}  // namespace

MeshOnHost::MeshOnHost(const accel::SceneView& scene, const accel::Executor& executor)
    : scene_(scene), executor_(executor), sound_(render::sound_triangles(scene, scene.meshes[0])) {
    part_ = render::mesh_part(scene_, scene_.meshes[0], sound_);
}

const accel::Octree& MeshOnHost::tree(MeshTree kind) const {
    const auto found = trees_.find(kind);
    if (found != trees_.end()) return found->second;
    return trees_.emplace(kind, build_octree(part_, options_of(kind, sound_.size()), executor_)).first->second;
}

const accel::LinkedOctree& MeshOnHost::linked(MeshTree kind) const {
    const auto found = linked_.find(kind);
    if (found != linked_.end()) return found->second;
    return linked_.emplace(kind, accel::LinkedOctree(tree(kind), part_, executor_)).first->second;
}

render::cuda::OctreeArrays MeshOnHost::uploaded(Device& device, MeshTree kind) const {
    render::cuda::OctreeArrays arrays = upload_octree(device, linked(kind));
    if (kind != MeshTree::Ours || arrays.view.leaves == nullptr) return arrays;
    const accel::Octree& built = tree(kind);
    use_jump_levels(
        device, built,
        accel::jump_levels_for(built.frame.depth, built.leaves.size(), render::cuda::most_device_jump_levels), arrays);
    return arrays;
}

void MeshRays::copy(Device& device) {
    const std::vector<render::cuda::OctreeRay> here = batch.rays();
    rays = {device, std::span<const render::cuda::OctreeRay>(here)};
    answers = {device, here.size()};
}

const std::vector<MeshWay>& mesh_ways() {
    static const std::vector<MeshWay> ways = all_ways();
    return ways;
}

}  // namespace enfilade::tools::gpu
