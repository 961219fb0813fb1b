#include "accel/octree/octree_figures.h"

#include <algorithm>
#include <vector>

namespace enfilade::accel {

namespace {

struct Visit {
    OctreeEntry entry;
    std::uint32_t level;
};

void add_tree(const OctreeView& tree, OctreeFigures& sum) {
    std::vector<Visit> stack = {{tree.root, 0}};
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (!visit.entry.is_leaf()) {
            for (std::size_t octant = 0; octant < 8; ++octant)
                stack.push_back({tree.children[8 * std::size_t{visit.entry.number()} + octant], visit.level + 1});
            continue;
        }
        const LinkedLeaf& leaf = tree.leaves[visit.entry.number()];
        ++sum.leaves;
        sum.empty_leaves += leaf.count == 0 ? 1 : 0;
        sum.references += leaf.count;
        sum.depth = std::max(sum.depth, visit.level);
    }
}

}  // namespace

void OctreeFigures::add(const OctreeFigures& other) {
    trees += other.trees;
    leaves += other.leaves;
    empty_leaves += other.empty_leaves;
    references += other.references;
    depth = std::max(depth, other.depth);
}

void OctreeFigures::add(const OctreeStats& tree) {
    if (tree.references == 0) return;
    ++trees;
    leaves += tree.leaves;
    empty_leaves += tree.empty_leaves;
    references += tree.references;
    depth = std::max(depth, tree.deepest);
}

OctreeFigures octree_figures(std::span<const OctreeView> trees) {
    OctreeFigures sum;
    for (const OctreeView& tree : trees) {
        if (tree.leaves == nullptr) continue;
        ++sum.trees;
        add_tree(tree, sum);
    }
    return sum;
}

}  // namespace enfilade::accel
