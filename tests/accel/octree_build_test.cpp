// Octrees against everything tested against everything, in double.

#include <gtest/gtest.h>

#include <cmath>

#include "accel/octree/octree_split.h"
#include "accel/octree/octree_stats.h"
#include "tests/accel/octree_meshes.h"

namespace enfilade::accel {
namespace {

using test::OctreeMesh;
using test::reference_fault;
using test::same_trees;
using test::tree_fault;
using test::unbalanced_pairs;

Octree built(const OctreeMesh& mesh, const OctreeOptions& options = {}) {
    return build_octree(mesh.part(), options, SerialExecutor());
}

void expect_whole(const OctreeMesh& mesh, const OctreeOptions& options) {
    const Octree tree = built(mesh, options);
    EXPECT_EQ(tree_fault(tree), "");
    EXPECT_EQ(reference_fault(tree, mesh.part()), "");
}

TEST(OctreeBuild, ListsWhatMeetsEachLeaf) {
    for (const OctreeMesh& mesh : {OctreeMesh::sphere(24), OctreeMesh::soup(1500, 0.05), OctreeMesh::needles(60),
                                   OctreeMesh::on_one_vertex(300), OctreeMesh::disc(400), OctreeMesh::identical(40)}) {
        expect_whole(mesh, {});
        expect_whole(mesh, {.depth = 4, .leaf_size = 4});
        expect_whole(mesh, {.depth = 5, .leaf_size = 6, .is_balanced = true});
    }
}

// Above 4096 triangles cores share the first levels.
TEST(OctreeBuild, ListsWhatMeetsEachLeafOfLargeMeshes) {
    const OctreeMesh mesh = OctreeMesh::sphere(60);
    ASSERT_GT(mesh.size(), 4096);
    expect_whole(mesh, {});
}

TEST(OctreeBuild, ListsUsedTrianglesByTheirNumbersInTheMesh) {
    OctreeMesh mesh = OctreeMesh::soup(2000, 0.1);
    mesh.use_every(7);
    expect_whole(mesh, {.leaf_size = 8});
}

TEST(OctreeBuild, HoldsItsSlackAnywhereAndOfAnySize) {
    for (const double scale : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
        OctreeMesh mesh = OctreeMesh::sphere(14);
        mesh.move(scale, {0, 0, 0});
        expect_whole(mesh, {.leaf_size = 8});
    }
    for (const double offset : {1e3, -1e6}) {
        OctreeMesh mesh = OctreeMesh::soup(700, 0.1);
        mesh.move(1, {offset, 0.5 * offset, -offset});
        expect_whole(mesh, {.leaf_size = 8});
    }
}

// Cells of the finest lattice are as wide as the slack.
TEST(OctreeBuild, HoldsItsSlackAtTheLargestDepth) {
    OctreeMesh mesh;
    for (int i = 1; i < 40; ++i) {
        const double s = std::ldexp(1.0, -i / 2);
        mesh.add({s, 0.3 * s, 0.1 * s}, {0.8 * s, 0.4 * s, 0.2 * s}, {0.9 * s, 0.1 * s, 0.3 * s});
    }
    const OctreeOptions options = {.depth = largest_octree_depth, .leaf_size = 1};
    EXPECT_GE(octree_stats(built(mesh, options)).deepest, 15);
    expect_whole(mesh, options);
}

TEST(OctreeBuild, DoesNotDependOnThreads) {
    for (const OctreeMesh& mesh : {OctreeMesh::sphere(90), OctreeMesh::soup(9000, 0.02)}) {
        for (const OctreeOptions& options :
             {OctreeOptions{}, OctreeOptions{.leaf_size = 5}, OctreeOptions{.leaf_size = 5, .is_balanced = true}}) {
            const Octree alone = built(mesh, options);
            for (const unsigned threads : {2u, 3u, 8u})
                EXPECT_TRUE(same_trees(alone, build_octree(mesh.part(), options, ThreadExecutor(threads))));
        }
    }
}

TEST(OctreeBuild, IsEmptyOverNothing) {
    const Octree tree = built(OctreeMesh());
    EXPECT_TRUE(tree.is_empty());
    EXPECT_TRUE(tree.leaves.empty());
}

TEST(OctreeBuild, MakesOneLeafOfFewTriangles) {
    const OctreeMesh mesh = OctreeMesh::soup(5, 0.5);
    const Octree tree = built(mesh);
    ASSERT_EQ(tree.leaves.size(), 1);
    EXPECT_EQ(tree.frame.depth, 0);
    EXPECT_EQ(tree.references.size(), 5);
}

TEST(OctreeBuild, StopsAtTheDepthAndSizeAskedFor) {
    const OctreeMesh mesh = OctreeMesh::sphere(40);
    const Octree shallow = built(mesh, {.depth = 3, .leaf_size = 1});
    EXPECT_EQ(shallow.frame.depth, 3);
    EXPECT_EQ(octree_stats(shallow).deepest, 3);
    const OctreeStats stats = octree_stats(built(OctreeMesh::soup(3000, 0.01), {.leaf_size = 20}));
    EXPECT_LE(stats.largest_leaf, 20);
    EXPECT_GT(stats.largest_leaf, 10);
}

/// What the builder looks for the least of.
double cost_and_memory(const OctreeMesh& mesh, const OctreeOptions& options) {
    const OctreeStats stats = octree_stats(built(mesh, options));
    const double entries =
        static_cast<double>(stats.references) + detail::SplitRule::leaf_references * static_cast<double>(stats.leaves);
    return stats.expected_cost + detail::SplitRule::memory_price * entries / static_cast<double>(mesh.size());
}

// What cost decides is no worse by cost than any stop by depth and number.
TEST(OctreeBuild, CostsLessThanAnyStopByNumber) {
    for (const OctreeMesh& mesh : {OctreeMesh::sphere(60), OctreeMesh::soup(6000, 0.02), OctreeMesh::disc(2000)}) {
        const double cost = cost_and_memory(mesh, {});
        for (std::uint32_t depth = 1; depth < 8; ++depth)
            for (const std::uint32_t size : {4u, 16u, 32u, 64u})
                EXPECT_LE(cost, 1.0001 * cost_and_memory(mesh, {.depth = depth, .leaf_size = size}));
    }
}

// Dear leaves are larger, and fewer are crossed.
TEST(OctreeBuild, FollowsTheCostsItIsGiven) {
    const OctreeMesh mesh = OctreeMesh::sphere(60);
    OctreeOptions dear;
    dear.cost.full_leaf *= 4;
    dear.cost.empty_leaf *= 4;
    const OctreeStats plain = octree_stats(built(mesh)), few = octree_stats(built(mesh, dear));
    EXPECT_LT(few.crossed_leaves, 0.8 * plain.crossed_leaves);
    EXPECT_GT(few.crossed_blocks, plain.crossed_blocks);
}

TEST(OctreeBalance, LetsNeighboursDifferByOneLevel) {
    for (const OctreeMesh& mesh : {OctreeMesh::sphere(40), OctreeMesh::on_one_vertex(3000), OctreeMesh::disc(3000)}) {
        const OctreeOptions asked = {.leaf_size = 6}, balanced = {.leaf_size = 6, .is_balanced = true};
        const Octree free_tree = built(mesh, asked), tree = built(mesh, balanced);
        EXPECT_GT(unbalanced_pairs(free_tree), 0);
        EXPECT_EQ(unbalanced_pairs(tree), 0);
        EXPECT_GT(tree.leaves.size(), free_tree.leaves.size());
    }
}

// It only splits: every leaf lies in one of the free tree, and those that were left whole are as they were.
TEST(OctreeBalance, RefinesTheFreeTree) {
    const OctreeMesh mesh = OctreeMesh::sphere(40);
    const Octree free_tree = built(mesh, {.leaf_size = 6}), tree = built(mesh, {.leaf_size = 6, .is_balanced = true});
    ASSERT_EQ(tree.frame.depth, free_tree.frame.depth);
    for (const OctreeLeaf& leaf : tree.leaves) EXPECT_LE(test::level_at(free_tree, leaf.low), leaf.level);
}

TEST(OctreeBalance, LeavesBalancedTreesAlone) {
    const OctreeMesh mesh = OctreeMesh::soup(5, 0.5);
    EXPECT_TRUE(same_trees(built(mesh), built(mesh, {.is_balanced = true})));
}

}  // namespace
}  // namespace enfilade::accel
