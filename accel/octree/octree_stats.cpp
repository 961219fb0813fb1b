#include "accel/octree/octree_stats.h"

#include <algorithm>
#include <cmath>

namespace enfilade::accel {

OctreeStats octree_stats(const Octree& tree, const OctreeCost& cost) {
    OctreeStats stats;
    stats.leaves = tree.leaves.size();
    stats.inner_nodes = tree.children.size() / 8;
    stats.references = tree.references.size();
    std::vector<bool> is_listed;
    for (const std::uint32_t t : tree.references) {
        if (t >= is_listed.size()) is_listed.resize(std::size_t{t} + 1);
        is_listed[t] = true;
    }
    stats.triangles = static_cast<std::uint64_t>(std::ranges::count(is_listed, true));
    for (const OctreeLeaf& leaf : tree.leaves) {
        const double crossed = std::ldexp(1.0, -2 * static_cast<int>(leaf.level));
        stats.deepest = std::max(stats.deepest, leaf.level);
        stats.largest_leaf = std::max(stats.largest_leaf, leaf.count);
        stats.crossed_leaves += crossed;
        if (leaf.count == 0) {
            ++stats.empty_leaves;
            stats.crossed_empty_leaves += crossed;
        }
        stats.crossed_blocks += crossed * OctreeCost::blocks(leaf.count);
        stats.expected_cost += crossed * cost.of_leaf(leaf.count);
    }
    const std::uint64_t full = stats.leaves - stats.empty_leaves;
    if (stats.triangles > 0)
        stats.references_a_triangle = static_cast<double>(stats.references) / static_cast<double>(stats.triangles);
    if (full > 0) stats.triangles_a_leaf = static_cast<double>(stats.references) / static_cast<double>(full);
    return stats;
}

}  // namespace enfilade::accel
