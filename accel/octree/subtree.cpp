#include "accel/octree/subtree.h"

#include <bit>

namespace enfilade::accel::detail {
namespace {

class SubtreeBuilder {
public:
    SubtreeBuilder(const LatticeTriangles& triangles, const SplitRule& rule, std::vector<std::uint32_t> listed)
        : triangles_(triangles), rule_(rule), lists_(std::move(listed)) {}

    Subtree build(const OctreeNode& node, std::uint64_t budget) {
        const bool is_large = SplitRule::is_large(static_cast<std::uint32_t>(lists_.size()));
        tree_.root = (is_large ? add_leaf(node, 0, lists_.size()) : build(node, 0, lists_.size(), budget)).entry;
        return std::move(tree_);
    }

private:
    struct Built {
        OctreeEntry entry;
        double cost;
    };

    /// Of the node whose triangles are lists_[begin, end).
    Built build(const OctreeNode& node, std::size_t begin, std::size_t end, std::uint64_t budget) {
        const auto count = static_cast<std::uint32_t>(end - begin);
        if (!rule_.may_split(count, node.level)) return add_leaf(node, begin, end);
        octants_.find(triangles_, node, {lists_.data() + begin, count});
        if (!rule_.tries(count, budget, octants_.counts)) return add_leaf(node, begin, end);
        const OctantCounts counts = octants_.counts;
        const std::size_t leaves = tree_.leaves.size(), references = tree_.references.size(),
                          inner = tree_.children.size(), lists = lists_.size();
        std::array<std::size_t, 8> places;
        std::size_t at = lists;
        for (std::size_t i = 0; i < 8; ++i) {
            places[i] = at;
            at += counts[i];
        }
        lists_.resize(at);
        std::array<std::uint32_t*, 8> to;
        for (std::size_t i = 0; i < 8; ++i) to[i] = lists_.data() + places[i];
        octants_.write({lists_.data() + begin, count}, to);
        const std::array<std::uint64_t, 8> budgets = SplitRule::shares(budget, counts);
        tree_.children.resize(inner + 8);
        double cost = 0;
        for (std::uint32_t i = 0; i < 8; ++i) {
            const OctreeNode octant = node.octant(i, triangles_.frame().depth);
            const Built built = build(octant, places[i], places[i] + counts[i], budgets[i]);
            tree_.children[inner + i] = built.entry;
            cost += SplitRule::crossed * built.cost;
        }
        lists_.resize(lists);
        if (rule_.keeps_split(count, node.level, cost, tree_.leaves.size() - leaves,
                              tree_.references.size() - references))
            return {OctreeEntry::inner(static_cast<std::uint32_t>(inner / 8)), cost};
        tree_.leaves.resize(leaves);
        tree_.references.resize(references);
        tree_.children.resize(inner);
        return add_leaf(node, begin, end);
    }

    Built add_leaf(const OctreeNode& node, std::size_t begin, std::size_t end) {
        const auto count = static_cast<std::uint32_t>(end - begin);
        tree_.leaves.push_back({node.low, node.level, static_cast<std::uint32_t>(tree_.references.size()), count});
        tree_.references.insert(tree_.references.end(), lists_.begin() + static_cast<std::ptrdiff_t>(begin),
                                lists_.begin() + static_cast<std::ptrdiff_t>(end));
        return {OctreeEntry::leaf(static_cast<std::uint32_t>(tree_.leaves.size() - 1)), rule_.cost_of_leaf(count)};
    }

    const LatticeTriangles& triangles_;
    const SplitRule& rule_;
    std::vector<std::uint32_t> lists_;  ///< of the nodes from the root to where the work is, each with its siblings
    OctantTriangles octants_;
    Subtree tree_;
};

}  // namespace

void OctantTriangles::find(const LatticeTriangles& triangles, const OctreeNode& node,
                           std::span<const std::uint32_t> listed) {
    octants.resize(listed.size());
    triangles.find_octants(node, listed, octants.data());
    counts = {};
    for (const std::uint8_t octant : octants)
        for (std::uint32_t i = 0; i < 8; ++i) counts[i] += octant >> i & 1u;
}

void OctantTriangles::write(std::span<const std::uint32_t> listed, std::array<std::uint32_t*, 8> to) const {
    for (std::size_t j = 0; j < listed.size(); ++j)
        for (std::uint32_t rest = octants[j]; rest != 0; rest &= rest - 1)
            *to[static_cast<std::size_t>(std::countr_zero(rest))]++ = listed[j];
}

Subtree build_subtree(const LatticeTriangles& triangles, const SplitRule& rule, const OctreeNode& node,
                      std::vector<std::uint32_t> listed, std::uint64_t budget) {
    return SubtreeBuilder(triangles, rule, std::move(listed)).build(node, budget);
}

}  // namespace enfilade::accel::detail
