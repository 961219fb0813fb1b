#pragma once
// Inside of accel/octree: whether a node is split or stays a leaf.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "accel/octree/octree.h"

namespace enfilade::accel::detail {

using OctantCounts = std::array<std::uint32_t, 8>;  ///< triangles that meet each octant

/// Decides by what is in the node alone, so that a tree does not depend on who builds which part of it.
class SplitRule {
public:
    SplitRule(const OctreeOptions& options, std::uint32_t deepest, std::size_t triangles)
        : cost_(options.cost), leaf_size_(options.leaf_size), deepest_(deepest), triangles_(triangles) {}

    /// What one more reference for each triangle is taken to cost a line through the root, since what is larger is less
    /// often in a cache; a leaf takes as much memory as `leaf_references` references.
    static constexpr double memory_price = 15, leaf_references = 1.6;

    /// Leaves and references that the root may have below it.
    [[nodiscard]] static std::uint64_t budget(std::size_t triangles) {
        return octree_entries_a_triangle * triangles + octree_entries_spare;
    }

    /// What each octant gets of its parent's budget: by its entries, so that all get enough to be a leaf.
    /// \pre entries(counts) <= budget
    [[nodiscard]] static ENFILADE_HD std::array<std::uint64_t, 8> shares(std::uint64_t budget,
                                                                         const OctantCounts& counts) {
        const std::uint64_t all = entries(counts);
        std::array<std::uint64_t, 8> shares;
        for (std::size_t i = 0; i < 8; ++i) shares[i] = budget * (std::uint64_t{counts[i]} + 1) / all;
        return shares;
    }

    /// False: no octants can make up for the split.
    [[nodiscard]] bool may_split(std::uint32_t count, std::uint32_t level) const {
        if (level >= deepest_) return false;
        if (!is_by_cost()) return count > leaf_size_;
        OctantCounts alone = {count > 0 ? 1u : 0u};
        return least_cost(alone) < cost_of_leaf(count);
    }

    /// Nodes with more triangles are split where that pays at once, and then for good; below others all is tried, and
    /// taken back where it was not worth it.
    [[nodiscard]] static bool is_large(std::uint32_t count) { return count > 4096; }

    /// Whether to build the octants of a node: they fit the budget, and cost less than a leaf, or might once they are
    /// split in turn; or, where leaves are asked for by size, most triangles lie in few of them.
    [[nodiscard]] bool tries(std::uint32_t count, std::uint64_t budget, const OctantCounts& counts) const {
        if (!is_by_cost()) return tries_by_size(count, budget, counts);
        if (entries(counts) > budget) return false;
        return (is_large(count) ? cost_of_leaves(counts) : least_cost(counts)) < cost_of_leaf(count);
    }

    /// The same where leaves are asked for by size.
    [[nodiscard]] static ENFILADE_HD bool tries_by_size(std::uint32_t count, std::uint64_t budget,
                                                        const OctantCounts& counts) {
        return entries(counts) <= budget && entries(counts) - 8 <= std::uint64_t{octants_at_most} * count;
    }

    /// What a part of the tree below a node at `level` takes, as a cost of lines through that node.
    [[nodiscard]] double price(std::uint32_t level, std::size_t leaves, std::size_t references) const {
        const double entries = static_cast<double>(references) + leaf_references * static_cast<double>(leaves);
        return memory_price * std::ldexp(entries, 2 * static_cast<int>(level)) / static_cast<double>(triangles_);
    }

    /// Whether a split was worth it: what it costs and takes against one leaf.
    [[nodiscard]] bool keeps_split(std::uint32_t count, std::uint32_t level, double cost, std::size_t leaves,
                                   std::size_t references) const {
        return !is_by_cost() || cost + price(level, leaves, references) < cost_of_leaf(count) + price(level, 1, count);
    }

    [[nodiscard]] double cost_of_leaf(std::uint32_t count) const { return cost_.of_leaf(count); }

    /// Of a line through a node it crosses each of the octants in one of four cases: so are their areas.
    static constexpr double crossed = 0.25;

private:
    /// Where each triangle meets more octants than that in the mean, counting separates nothing.
    static constexpr std::uint32_t octants_at_most = 5;

    [[nodiscard]] bool is_by_cost() const { return leaf_size_ == OctreeOptions::automatic; }

    /// The references and one for each leaf.
    [[nodiscard]] static ENFILADE_HD std::uint64_t entries(const OctantCounts& counts) {
        std::uint64_t sum = 8;
        for (std::size_t i = 0; i < 8; ++i) sum += counts[i];
        return sum;
    }

    /// Below what the octants will hardly come, however they are split.
    [[nodiscard]] double least_cost(const OctantCounts& counts) const {
        double sum = 0;
        for (const std::uint32_t count : counts) sum += cost_of_leaf(count > 0 ? 1 : 0);
        return crossed * sum;
    }

    [[nodiscard]] double cost_of_leaves(const OctantCounts& counts) const {
        double sum = 0;
        for (const std::uint32_t count : counts) sum += cost_of_leaf(count);
        return crossed * sum;
    }

    OctreeCost cost_;
    std::uint32_t leaf_size_;
    std::uint32_t deepest_;  ///< level of leaves
    std::size_t triangles_;  ///< of the whole tree
};

}  // namespace enfilade::accel::detail
