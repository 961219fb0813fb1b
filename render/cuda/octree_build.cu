#include "render/cuda/octree_build.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "render/cuda/launch.h"
#include "render/cuda/octree_build_passes.h"
#include "render/cuda/scan.h"

namespace enfilade::render::cuda {
namespace {

using namespace build;

/// One number of a device's.
std::uint32_t read_one(Device& device, const std::uint32_t* at) {
    std::uint32_t value = 0;
    device.download(&value, at, sizeof value);
    return value;
}

/// What stays of a level until all are done.
struct BuiltLevel {
    Buffer<Node> nodes;
    Buffer<std::uint32_t> work, settled;
    Buffer<Extent> sums;
};

class Builder {
public:
    Builder(Device& device, const MeshOnDevice& mesh, const DeviceOctreeBuild& build)
        : device_(device), mesh_(mesh), build_(build), scanner_(device) {}

    OctreeOnDevice run() {
        place_triangles();
        add_root();
        while (add_level()) {
        }
        put_together();
        return std::move(tree_);
    }

private:
    [[nodiscard]] std::uint32_t triangles() const { return static_cast<std::uint32_t>(mesh_.used.size()); }

    void place_triangles() {
        const std::uint32_t chunks = (triangles() + Bounds::grain - 1) / Bounds::grain;
        Buffer<Bounds::Box> boxes(device_, chunks);
        for_each(device_, chunks,
                 Bounds{mesh_.places.data(), mesh_.triangles.data(), mesh_.used.data(), triangles(), boxes.data()});
        Bounds::Box box = Bounds::nothing();
        for (const Bounds::Box& each : boxes.read()) {
            for (int k = 0; k < 3; ++k) {
                box.low[k] = std::min(box.low[k], each.low[k]);
                box.high[k] = std::max(box.high[k], each.high[k]);
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            tree_.low[k] = box.low[k];
            tree_.high[k] = box.high[k];
        }
        tree_.frame =
            accel::detail::cube_about(tree_.low, tree_.high, std::min(build_.depth, accel::largest_octree_depth));
        corners_ = Buffer<float>(device_, 9 * mesh_.used.size());
        for_each(
            device_, triangles(),
            PlaceCorners{mesh_.places.data(), mesh_.triangles.data(), mesh_.used.data(), tree_.frame, corners_.data()});
    }

    void add_root() {
        BuiltLevel root;
        Node node = {};
        node.budget = accel::detail::SplitRule::budget(triangles());
        node.count = triangles();
        node.child = none;
        node.is_work = tree_.frame.depth > 0 && node.count > build_.leaf_size;
        root.nodes = Buffer<Node>(device_, std::span<const Node>(&node, 1));
        Buffer<std::uint32_t>& list = node.is_work ? root.work : root.settled;
        list = Buffer<std::uint32_t>(device_, node.is_work ? whole_blocks(node.count) : node.count);
        for_each(device_, node.count, CountUp{list.data()});
        work_first_ = Buffer<std::uint32_t>(device_, 1);
        work_first_.clear();
        levels_.push_back(std::move(root));
    }

    /// Splits nodes of the last level; false: none is.
    bool add_level() {
        BuiltLevel& last = levels_.back();
        const auto level = static_cast<std::uint32_t>(levels_.size() - 1);
        const auto nodes = static_cast<std::uint32_t>(last.nodes.size());
        const auto blocks = static_cast<std::uint32_t>(last.work.size() / block_size);
        if (blocks == 0) return false;
        const std::uint32_t warps = (blocks + blocks_a_warp - 1) / blocks_a_warp;
        Buffer<std::uint32_t> block_node(device_, blocks), counts(device_, 8 * std::size_t{blocks} + 1),
            before(device_, 8 * std::size_t{blocks} + 1);
        Buffer<std::uint8_t> octants(device_, last.work.size());
        for_each(device_, blocks, FindNodes{work_first_.data(), nodes, block_node.data()});
        const Level at = {last.nodes.data(), last.work.data(), block_node.data(), blocks};
        const float quarter = std::ldexp(0.25f, static_cast<int>(tree_.frame.depth - level));
        counts.clear();
        for_each_warp(device_, warps,
                      FindOctants{at, corners_.data(), quarter, accel::detail::octant_slack(tree_.frame.side()),
                                  octants.data(), counts.data()});
        scanner_.sums_before(counts.data(), before.data(), counts.size());
        Buffer<std::uint32_t> splits(device_, nodes + 1), ranks(device_, nodes + 1);
        splits.clear();
        for_each(device_, nodes, Decide{last.nodes.data(), before.data(), blocks, splits.data()});
        scanner_.sums_before(splits.data(), ranks.data(), splits.size());
        const std::uint32_t next = 8 * read_one(device_, ranks.data() + nodes);
        if (next == 0) return false;
        BuiltLevel below;
        below.nodes = Buffer<Node>(device_, next);
        Buffer<std::uint32_t> sizes[2] = {{device_, next + 1}, {device_, next + 1}};
        Buffer<std::uint32_t> first[2] = {{device_, next + 1}, {device_, next + 1}};
        for (auto& each : sizes) each.clear();
        for_each(device_, nodes,
                 MakeNodes{last.nodes.data(), before.data(), blocks, splits.data(), ranks.data(),
                           1u << (tree_.frame.depth - level - 1), build_.leaf_size, level + 1 == tree_.frame.depth,
                           below.nodes.data(), sizes[0].data(), sizes[1].data()});
        for (int i = 0; i < 2; ++i) scanner_.sums_before(sizes[i].data(), first[i].data(), next + 1);
        for_each(device_, next, SetPlaces{below.nodes.data(), first[0].data(), first[1].data()});
        below.work = Buffer<std::uint32_t>(device_, read_one(device_, first[0].data() + next));
        below.settled = Buffer<std::uint32_t>(device_, read_one(device_, first[1].data() + next));
        for_each_warp(
            device_, warps,
            Deal{at, octants.data(), before.data(), below.nodes.data(), below.work.data(), below.settled.data()});
        device_.wait();
        work_first_ = std::move(first[0]);
        levels_.push_back(std::move(below));
        return true;
    }

    void put_together() {
        const std::size_t count = levels_.size();
        for (std::size_t level = count; level-- > 0;) {
            BuiltLevel& at = levels_[level];
            at.sums = Buffer<Extent>(device_, at.nodes.size());
            for_each(
                device_, at.nodes.size(),
                SumUp{at.nodes.data(), level + 1 < count ? levels_[level + 1].sums.data() : nullptr, at.sums.data()});
        }
        const Extent all = levels_.front().sums.read().front();
        tree_.children = Buffer<accel::OctreeEntry>(device_, std::size_t{8} * all.inner);
        tree_.inner_levels = Buffer<std::uint32_t>(device_, all.inner);
        tree_.leaves = Buffer<accel::OctreeLeaf>(device_, all.leaves);
        tree_.references = Buffer<std::uint32_t>(device_, all.references);
        tree_.root = all.inner == 0 ? accel::OctreeEntry::leaf(0) : accel::OctreeEntry::inner(0);
        std::uint32_t unused = 0;
        if (build_.depth == accel::OctreeOptions::automatic)
            unused = tree_.frame.depth - static_cast<std::uint32_t>(count - 1);
        Buffer<Extent> starts(device_, 1);
        starts.clear();
        for (std::size_t level = 0; level < count; ++level) {
            BuiltLevel& at = levels_[level];
            const BuiltLevel* next = level + 1 < count ? &levels_[level + 1] : nullptr;
            Buffer<Extent> next_starts(device_, next != nullptr ? next->nodes.size() : 0);
            for_each(device_, at.nodes.size(),
                     PlaceNodes{at.nodes.data(), next != nullptr ? next->nodes.data() : nullptr,
                                next != nullptr ? next->sums.data() : nullptr, starts.data(), next_starts.data(),
                                static_cast<std::uint32_t>(level), unused, tree_.children.data(),
                                tree_.inner_levels.data(), tree_.leaves.data()});
            for_each_warp(device_, at.nodes.size(),
                          WriteReferences{at.nodes.data(), starts.data(), at.work.data(), at.settled.data(),
                                          mesh_.used.data(), tree_.references.data()});
            device_.wait();
            starts = std::move(next_starts);
        }
        for (float& cells : tree_.frame.cells_a_unit) cells = std::ldexp(cells, -static_cast<int>(unused));
        tree_.frame.depth -= unused;
    }

    Device& device_;
    const MeshOnDevice& mesh_;
    DeviceOctreeBuild build_;
    Scanner scanner_;
    Buffer<float> corners_;
    Buffer<std::uint32_t> work_first_;  ///< [node of the last level]: in its list of work
    std::vector<BuiltLevel> levels_;
    OctreeOnDevice tree_;
};

}  // namespace

OctreeOnDevice build_octree_on(Device& device, const MeshOnDevice& mesh, const DeviceOctreeBuild& build) {
    if (build.leaf_size == accel::OctreeOptions::automatic)
        throw std::invalid_argument("a device builds octrees by the size of their leaves");
    if (mesh.used.size() == 0) return {};
    return Builder(device, mesh, build).run();
}

accel::Octree OctreeOnDevice::read() const { return {frame, root, children.read(), leaves.read(), references.read()}; }

}  // namespace enfilade::render::cuda
