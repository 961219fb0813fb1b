#include "accel/octree/rope_links.h"

#include <atomic>
#include <stdexcept>

namespace enfilade::accel::detail {
namespace {

constexpr std::size_t grain = 4096;

/// The axes along a face, in the order x, y, z.
struct Along {
    std::uint32_t u, v;
};
Along along(int axis) { return {axis == 0 ? 1u : 0u, axis == 2 ? 1u : 2u}; }

}  // namespace

OctreeEntry node_at(const Octree& tree, const std::array<std::uint32_t, 3>& cell, std::uint32_t level) {
    OctreeEntry entry = tree.root;
    for (std::uint32_t bit = tree.frame.depth; !entry.is_leaf() && bit > tree.frame.depth - level;) {
        --bit;
        const std::uint32_t octant = (cell[0] >> bit & 1u) | (cell[1] >> bit & 1u) << 1 | (cell[2] >> bit & 1u) << 2;
        entry = tree.children[8 * std::size_t{entry.number()} + octant];
    }
    return entry;
}

RopeLinks::RopeLinks(const Octree& tree, bool is_balanced, std::uint32_t header, const Executor& executor)
    : tree_(tree), is_balanced_(is_balanced), header_(header), addresses_(tree.leaves.size()) {
    std::atomic<bool> is_broken = false;
    parallel_for(executor, addresses_.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::uint32_t words = header;
            for (std::uint32_t face = 0; face < rope_faces; ++face) {
                const Side side = side_of(tree.leaves[i], face);
                for (std::uint32_t j = 0; j < side.count; ++j)
                    if (is_balanced && !side.nodes[j].is_leaf()) is_broken = true;
                words += side.count;
            }
            addresses_[i] = words;
        }
    });
    if (is_broken) throw std::invalid_argument("neighbours of the octree differ by more than one level");
    for (RopeAddress& address : addresses_) {
        const std::uint32_t words = address;
        address = static_cast<RopeAddress>(leaf_words_);
        leaf_words_ += words;
        if (leaf_words_ + tree.children.size() >= inner_bit) throw std::length_error("the octree's records pass 8 GiB");
    }
}

RopeAddress RopeLinks::address(OctreeEntry entry) const {
    if (entry.is_leaf()) return addresses_[entry.number()];
    return inner_bit | static_cast<RopeAddress>(leaf_words_ + std::size_t{8} * entry.number());
}

std::size_t RopeLinks::neighbour_count() const { return leaf_words_ - header_ * addresses_.size(); }

RopeLinks::Side RopeLinks::side_of(const OctreeLeaf& leaf, std::uint32_t face) const {
    const auto axis = static_cast<std::size_t>(axis_of(face));
    const std::uint32_t width = tree_.width(leaf), side = 1u << tree_.frame.depth;
    if (is_high(face) ? leaf.low[axis] + width == side : leaf.low[axis] == 0) return {};
    std::array<std::uint32_t, 3> cell = leaf.low;
    cell[axis] = is_high(face) ? leaf.low[axis] + width : leaf.low[axis] - 1;
    const OctreeEntry node = node_at(tree_, cell, leaf.level);
    if (!is_balanced_ || node.is_leaf()) return {{node}, 1};
    Side four = {{}, 4};
    const Along axes = along(axis_of(face));
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
        const std::uint32_t octant =
            (is_high(face) ? 0u : 1u) << axis | (quarter & 1u) << axes.u | (quarter >> 1) << axes.v;
        four.nodes[quarter] = tree_.children[std::size_t{8} * node.number() + octant];
    }
    return four;
}

std::uint32_t RopeLinks::write_neighbours(std::size_t leaf, std::uint32_t* to) const {
    std::uint32_t counts = 0;
    for (std::uint32_t face = 0; face < rope_faces; ++face) {
        const Side side = side_of(tree_.leaves[leaf], face);
        for (std::uint32_t j = 0; j < side.count; ++j) *to++ = address(side.nodes[j]);
        counts |= side.count << (4 * face);
    }
    return counts;
}

std::vector<RopeAddress> RopeLinks::cube_map(std::uint32_t level, const Executor& executor) const {
    const std::size_t across = std::size_t{1} << level;
    const std::uint32_t up = tree_.frame.depth - level;
    std::vector<RopeAddress> map(rope_faces * across * across);
    parallel_for(executor, rope_faces * across, 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const auto face = static_cast<std::uint32_t>(row / across);
            const Along axes = along(axis_of(face));
            std::array<std::uint32_t, 3> cell;
            cell[static_cast<std::size_t>(axis_of(face))] = is_high(face) ? (1u << tree_.frame.depth) - 1 : 0;
            cell[axes.v] = static_cast<std::uint32_t>(row % across) << up;
            for (std::size_t u = 0; u < across; ++u) {
                cell[axes.u] = static_cast<std::uint32_t>(u) << up;
                map[row * across + u] = address(node_at(tree_, cell, level));
            }
        }
    });
    return map;
}

}  // namespace enfilade::accel::detail
