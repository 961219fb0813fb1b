// Counts of octrees made by hand.

#include "accel/octree/octree_stats.h"

#include <gtest/gtest.h>

namespace enfilade::accel {
namespace {

/// A root cut once; the octants 0, 1 and 6 hold triangles.
Octree cut_once() {
    Octree tree;
    tree.frame.depth = 1;
    tree.root = OctreeEntry::inner(0);
    for (std::uint32_t octant = 0; octant < 8; ++octant) {
        tree.children.push_back(OctreeEntry::leaf(octant));
        const auto first = static_cast<std::uint32_t>(tree.references.size());
        if (octant == 0) tree.references.insert(tree.references.end(), {2, 5});
        if (octant == 1) tree.references.insert(tree.references.end(), {5});
        if (octant == 6)
            for (std::uint32_t t = 10; t < 27; ++t) tree.references.push_back(t);
        tree.leaves.push_back({{octant & 1u, octant >> 1 & 1u, octant >> 2},
                               1,
                               first,
                               static_cast<std::uint32_t>(tree.references.size()) - first});
    }
    return tree;
}

TEST(OctreeStats, CountsLeavesAndReferences) {
    const OctreeStats stats = octree_stats(cut_once());
    EXPECT_EQ(stats.leaves, 8);
    EXPECT_EQ(stats.empty_leaves, 5);
    EXPECT_EQ(stats.inner_nodes, 1);
    EXPECT_EQ(stats.references, 20);
    EXPECT_EQ(stats.triangles, 19);
    EXPECT_EQ(stats.deepest, 1);
    EXPECT_EQ(stats.largest_leaf, 17);
    EXPECT_DOUBLE_EQ(stats.references_a_triangle, 20.0 / 19);
    EXPECT_DOUBLE_EQ(stats.triangles_a_leaf, 20.0 / 3);
}

// Each octant of a cube has a quarter of its area: of the lines through the cube a quarter cross it.
TEST(OctreeStats, WeighsLeavesByTheirArea) {
    const OctreeStats stats = octree_stats(cut_once(), {.full_leaf = 100, .empty_leaf = 10, .block = 1});
    EXPECT_DOUBLE_EQ(stats.crossed_leaves, 2);
    EXPECT_DOUBLE_EQ(stats.crossed_empty_leaves, 1.25);
    EXPECT_DOUBLE_EQ(stats.crossed_blocks, 1);
    EXPECT_DOUBLE_EQ(stats.expected_cost, 0.75 * 100 + 1.25 * 10 + 1);
}

TEST(OctreeStats, AreZeroWithoutATree) { EXPECT_EQ(octree_stats(Octree()), OctreeStats()); }

}  // namespace
}  // namespace enfilade::accel
