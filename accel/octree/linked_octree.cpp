#include "accel/octree/linked_octree.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "accel/octree/exit_boxes.h"

namespace enfilade::accel {
namespace {

constexpr std::size_t fields = 10;  ///< nine coordinates and the number
constexpr std::size_t padding = 16;

std::vector<std::uint8_t> occupied_children(const Octree& tree) {
    std::vector<std::uint8_t> occupied(tree.children.size() / 8, 0);
    for (std::size_t i = 0; i < tree.children.size(); ++i) {
        const OctreeEntry child = tree.children[i];
        if (child.is_leaf() && tree.leaves[child.number()].count == 0) continue;
        occupied[i / 8] = static_cast<std::uint8_t>(occupied[i / 8] | 1u << (i % 8));
    }
    return occupied;
}

}  // namespace

LinkedOctree::LinkedOctree(const Octree& tree, const MeshPart& mesh, const Executor& executor)
    : frame_(tree.frame), root_(tree.root), children_(tree.children), occupied_(occupied_children(tree)) {
    if (tree.is_empty()) return;
    std::ranges::fill(low_, std::numeric_limits<float>::max());
    std::ranges::fill(high_, -std::numeric_limits<float>::max());
    for (const std::uint32_t t : mesh.used) {
        for (const std::uint32_t corner : mesh.triangles[t].corners) {
            const Vertex& v = mesh.places[corner];
            const float p[3] = {v.x, v.y, v.z};
            for (int k = 0; k < 3; ++k) {
                low_[k] = std::min(low_[k], p[k]);
                high_[k] = std::max(high_[k], p[k]);
            }
        }
    }
    leaves_.resize(tree.leaves.size());
    corners_.assign(tree.references.size() * fields + padding, 0.0f);
    jumps_ = build_jump_table(tree);
    bricks_ = build_bricks(tree, mesh, fields, executor);
    const FullCells cells(tree, executor);
    parallel_for(executor, tree.leaves.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const OctreeLeaf& from = tree.leaves[i];
            LinkedLeaf& to = leaves_[i];
            const std::uint32_t unit = exit_unit(tree.frame.depth - from.level);
            for (std::uint32_t octant = 0; octant < 8; ++octant) {
                const std::array<std::uint32_t, 3> extent =
                    exit_extent(from.low, tree.width(from), cells.view(), octant);
                for (std::size_t k = 0; k < 3; ++k)
                    to.exits[octant][k] = static_cast<std::uint8_t>(std::min(extent[k] >> unit, 255u));
            }
            to.first = static_cast<std::uint32_t>(fields * from.first);
            to.count = from.count;
            for (std::uint32_t j = 0; j < from.count; ++j) {
                const std::uint32_t t = tree.references[from.first + j];
                float* at = corners_.data() + to.first + j;
                for (const std::uint32_t corner : mesh.triangles[t].corners) {
                    const Vertex& v = mesh.places[corner];
                    for (const float p : {v.x, v.y, v.z}) {
                        *at = p;
                        at += from.count;
                    }
                }
                *at = std::bit_cast<float>(t);
            }
        }
    });
}

LatticeBox lattice_box(const OctreeFrame& frame, const float* low, const float* high) {
    LatticeBox box = {};
    const float slack = static_cast<float>(octree_slack) * frame.side();
    for (std::size_t k = 0; k < 3; ++k) {
        box.size = std::max(box.size, high[k] - low[k]);
        box.origin[k] = frame.low[k];
        box.cells_a_unit[k] = frame.cells_a_unit[k];
        box.low[k] = low[k];
        box.high[k] = high[k];
        box.from[k] = (low[k] - frame.low[k]) * frame.cells_a_unit[k] - slack;
        box.to[k] = (high[k] - frame.low[k]) * frame.cells_a_unit[k] + slack;
    }
    box.side = frame.side();
    return box;
}

OctreeView LinkedOctree::view() const {
    OctreeView view = {frame_,
                       root_,
                       children_.data(),
                       leaves_.empty() ? nullptr : leaves_.data(),
                       corners_.data(),
                       {low_[0], low_[1], low_[2]},
                       {high_[0], high_[1], high_[2]},
                       occupied_.data(),
                       jumps_.entries.data(),
                       jumps_.levels,
                       {},
                       bricks_.masks.data(),
                       bricks_.first.data(),
                       bricks_.entries.data()};
    view.box = lattice_box(frame_, low_, high_);
    return view;
}

}  // namespace enfilade::accel
