#include "accel/octree/rope_octree.h"

#include <algorithm>
#include <limits>

#include "accel/octree/rope_links.h"

namespace enfilade::accel {
namespace {

constexpr std::uint32_t paper_header = 4;
constexpr std::size_t leaf_grain = 4096;

/// Texels that a leaf may cost: what the paper's own cube maps come to, and more.
constexpr std::size_t texels_a_leaf = 16;

/// Level of the smallest leaves at the root's surface, where that costs no more than it may.
std::uint32_t cube_map_level(const Octree& tree) {
    const std::uint32_t side = 1u << tree.frame.depth;
    std::uint32_t level = 0;
    for (const OctreeLeaf& leaf : tree.leaves) {
        const std::uint32_t width = tree.width(leaf);
        for (const std::uint32_t low : leaf.low)
            if (low == 0 || low + width == side) level = std::max(level, leaf.level);
    }
    while (level > 0 && std::size_t{rope_faces} << (2 * level) > texels_a_leaf * tree.leaves.size() + rope_faces)
        --level;
    return level;
}

void write_box(const OctreeFrame& frame, const OctreeLeaf& leaf, RopeBox& box) {
    box = {{static_cast<float>(leaf.low[0]), static_cast<float>(leaf.low[1]), static_cast<float>(leaf.low[2])},
           static_cast<float>(1u << (frame.depth - leaf.level))};
}

}  // namespace

std::uint64_t packed_box(const OctreeFrame& frame, const OctreeLeaf& leaf) {
    const std::uint32_t down = frame.depth - leaf.level;
    const std::uint64_t x = leaf.low[0] >> down | 1u << leaf.level;
    return x << (2 * frame.depth) | std::uint64_t{leaf.low[1] >> down} << frame.depth | leaf.low[2] >> down;
}

RopeOctree::RopeOctree(const Octree& tree, const MeshPart& mesh, const RopeOptions& options, const Executor& executor) {
    if (tree.is_empty()) return;
    const bool is_long = !options.has_stored_boxes && 3 * tree.frame.depth + 1 > 32;
    view_.frame = tree.frame;
    view_.header = paper_header + (is_long ? 1 : 0);
    view_.is_balanced = options.is_balanced;
    leaf_count_ = tree.leaves.size();
    const detail::RopeLinks links(tree, options.is_balanced, view_.header, executor);
    neighbour_count_ = links.neighbour_count();
    leaf_words_ = links.leaf_words();
    words_.resize(leaf_words_ + tree.children.size());
    triangles_.resize(tree.references.size());
    if (options.has_stored_boxes) boxes_.resize(leaf_count_);
    parallel_for(executor, leaf_count_, leaf_grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const OctreeLeaf& leaf = tree.leaves[i];
            std::uint32_t* record = words_.data() + links.address(OctreeEntry::leaf(static_cast<std::uint32_t>(i)));
            const std::uint64_t box = packed_box(tree.frame, leaf);
            record[0] = leaf.count;
            record[1] = leaf.first;
            record[2] = options.has_stored_boxes ? static_cast<std::uint32_t>(i) : static_cast<std::uint32_t>(box);
            if (is_long) record[paper_header] = static_cast<std::uint32_t>(box >> 32);
            record[3] = links.write_neighbours(i, record + view_.header);
            if (options.has_stored_boxes) write_box(tree.frame, leaf, boxes_[i]);
            for (std::uint32_t j = leaf.first; j < leaf.first + leaf.count; ++j) {
                RopeTriangle& to = triangles_[j];
                to.number = tree.references[j];
                for (std::size_t c = 0; c < 3; ++c) {
                    const Vertex& v = mesh.places[mesh.triangles[to.number].corners[c]];
                    to.corners[c][0] = v.x;
                    to.corners[c][1] = v.y;
                    to.corners[c][2] = v.z;
                }
            }
        }
    });
    for (std::size_t i = 0; i < tree.children.size(); ++i) words_[leaf_words_ + i] = links.address(tree.children[i]);
    view_.root = links.address(tree.root);
    view_.cube_map_level = cube_map_level(tree);
    cube_map_ = links.cube_map(view_.cube_map_level, executor);
    std::ranges::fill(view_.low, std::numeric_limits<float>::max());
    std::ranges::fill(view_.high, -std::numeric_limits<float>::max());
    for (const RopeTriangle& triangle : triangles_) {
        for (const auto& corner : triangle.corners) {
            for (std::size_t k = 0; k < 3; ++k) {
                view_.low[k] = std::min(view_.low[k], corner[k]);
                view_.high[k] = std::max(view_.high[k], corner[k]);
            }
        }
    }
}

RopeView RopeOctree::view() const {
    RopeView view = view_;
    view.words = words_.empty() ? nullptr : words_.data();
    view.triangles = triangles_.data();
    view.boxes = boxes_.empty() ? nullptr : boxes_.data();
    view.cube_map = cube_map_.data();
    return view;
}

RopeBytes RopeOctree::bytes() const {
    return {cube_map_.size() * sizeof(RopeAddress), leaf_words_ * sizeof(std::uint32_t),
            (words_.size() - leaf_words_) * sizeof(RopeAddress), triangles_.size() * sizeof(RopeTriangle),
            boxes_.size() * sizeof(RopeBox)};
}

}  // namespace enfilade::accel
