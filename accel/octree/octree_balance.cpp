// From the deepest leaves up: each asks for neighbours that are twice as wide at most, and leaves that come of that
// ask in their turn when their level comes.

#include "accel/octree/octree_balance.h"

#include "accel/octree/subtree.h"

namespace enfilade::accel::detail {
namespace {

class Balancer {
public:
    Balancer(Octree& tree, const LatticeTriangles& triangles, std::uint64_t budget)
        : tree_(tree), triangles_(triangles), budget_(budget), at_level_(tree.frame.depth + 1) {}

    bool run() {
        for (std::uint32_t i = 0; i < tree_.leaves.size(); ++i) at_level_[tree_.leaves[i].level].push_back(i);
        // Splits add to the levels above the one that asks.
        for (std::size_t level = at_level_.size(); level-- > 2;)
            for (std::size_t i = 0; i < at_level_[level].size() && !is_too_much(); ++i)
                ask_neighbours(at_level_[level][i]);
        if (is_too_much()) return false;
        tree_ = in_order();
        return tree_.leaves.size() + tree_.references.size() <= budget_;
    }

private:
    /// With what is left behind, which may be as much again.
    [[nodiscard]] bool is_too_much() const { return tree_.leaves.size() + tree_.references.size() > 2 * budget_; }

    void ask_neighbours(std::uint32_t number) {
        const OctreeLeaf leaf = tree_.leaves[number];
        const std::uint32_t width = tree_.width(leaf), side = 1u << tree_.frame.depth;
        for (std::size_t k = 0; k < 3; ++k) {
            // The neighbour on the other side has the same parent.
            const bool is_upper = (leaf.low[k] / width & 1u) != 0;
            if (is_upper ? leaf.low[k] + width == side : leaf.low[k] == 0) continue;
            std::array<std::uint32_t, 3> place = leaf.low;
            place[k] = is_upper ? place[k] + width : place[k] - 1;
            need(place, leaf.level - 1);
        }
    }

    /// Splits the leaf at a place of the lattice until it is at `level` or below.
    void need(const std::array<std::uint32_t, 3>& place, std::uint32_t level) {
        OctreeEntry* entry = &tree_.root;
        for (std::uint32_t l = 0; l < level; ++l) {
            if (entry->is_leaf()) {
                const OctreeEntry inner = split(entry);  // first: it moves what `entry` leads to
                *entry = inner;
            }
            const std::uint32_t bit = tree_.frame.depth - 1 - l;
            const std::uint32_t octant =
                (place[0] >> bit & 1u) | (place[1] >> bit & 1u) << 1 | (place[2] >> bit & 1u) << 2;
            entry = &tree_.children[std::size_t{8} * entry->number() + octant];
        }
    }

    /// Of a leaf an inner node; what was the leaf's is left behind. `entry` leads to it, also afterwards.
    OctreeEntry split(OctreeEntry*& entry) {
        const OctreeLeaf leaf = tree_.leaves[entry->number()];
        const OctreeNode node = {leaf.low, leaf.level};
        listed_.assign(tree_.references.begin() + leaf.first, tree_.references.begin() + leaf.first + leaf.count);
        octants_.find(triangles_, node, listed_);
        std::array<std::size_t, 8> places;
        std::size_t at = tree_.references.size();
        for (std::uint32_t i = 0; i < 8; ++i) {
            places[i] = at;
            at += octants_.counts[i];
        }
        tree_.references.resize(at);
        std::array<std::uint32_t*, 8> to;
        for (std::size_t i = 0; i < 8; ++i) to[i] = tree_.references.data() + places[i];
        octants_.write(listed_, to);
        const std::size_t child = tree_.children.size();
        const std::ptrdiff_t place = entry == &tree_.root ? -1 : entry - tree_.children.data();
        tree_.children.resize(child + 8);
        entry = place < 0 ? &tree_.root : tree_.children.data() + place;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const OctreeNode octant = node.octant(i, tree_.frame.depth);
            const auto number = static_cast<std::uint32_t>(tree_.leaves.size());
            tree_.children[child + i] = OctreeEntry::leaf(number);
            tree_.leaves.push_back(
                {octant.low, octant.level, static_cast<std::uint32_t>(places[i]), octants_.counts[i]});
            at_level_[octant.level].push_back(number);
        }
        return OctreeEntry::inner(static_cast<std::uint32_t>(child / 8));
    }

    /// The same tree without what splits left behind.
    [[nodiscard]] Octree in_order() const {
        Octree ordered;
        ordered.frame = tree_.frame;
        ordered.children.reserve(tree_.children.size());
        ordered.leaves.reserve(tree_.leaves.size());
        ordered.references.reserve(tree_.references.size());
        ordered.root = copy(tree_.root, ordered);
        return ordered;
    }

    OctreeEntry copy(OctreeEntry entry, Octree& to) const {
        if (!entry.is_leaf()) {
            const std::size_t child = to.children.size();
            to.children.resize(child + 8);
            for (std::size_t i = 0; i < 8; ++i) {
                const OctreeEntry octant = copy(tree_.children[std::size_t{8} * entry.number() + i], to);
                to.children[child + i] = octant;
            }
            return OctreeEntry::inner(static_cast<std::uint32_t>(child / 8));
        }
        OctreeLeaf leaf = tree_.leaves[entry.number()];
        const auto from = tree_.references.begin() + leaf.first;
        leaf.first = static_cast<std::uint32_t>(to.references.size());
        to.references.insert(to.references.end(), from, from + leaf.count);
        to.leaves.push_back(leaf);
        return OctreeEntry::leaf(static_cast<std::uint32_t>(to.leaves.size() - 1));
    }

    Octree& tree_;
    const LatticeTriangles& triangles_;
    std::uint64_t budget_;
    std::vector<std::vector<std::uint32_t>> at_level_;  ///< leaves
    std::vector<std::uint32_t> listed_;
    OctantTriangles octants_;
};

}  // namespace

bool balance_octree(Octree& tree, const LatticeTriangles& triangles, std::uint64_t budget) {
    return Balancer(tree, triangles, budget).run();
}

}  // namespace enfilade::accel::detail
