// Meshes that no octree separates: depth, memory and time stay bounded.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "accel/octree/octree_stats.h"
#include "tests/accel/octree_meshes.h"

namespace enfilade::accel {
namespace {

using test::OctreeMesh;

void expect_bounded(const OctreeMesh& mesh, const OctreeOptions& options) {
    const Octree tree = build_octree(mesh.part(), options, ThreadExecutor(2));
    EXPECT_EQ(test::tree_fault(tree), "");
    EXPECT_LE(tree.frame.depth, largest_octree_depth);
    EXPECT_LE(tree.leaves.size() + tree.references.size(),
              octree_entries_a_triangle * mesh.size() + octree_entries_spare);
    EXPECT_EQ(octree_stats(tree).triangles, mesh.size());
    EXPECT_TRUE(!options.is_balanced || test::unbalanced_pairs(tree) == 0);
}

void expect_always_bounded(const OctreeMesh& mesh) {
    for (const bool is_balanced : {false, true})
        for (const std::uint32_t leaf_size : {OctreeOptions::automatic, 0u, 6u})
            expect_bounded(mesh, {.leaf_size = leaf_size, .is_balanced = is_balanced});
}

TEST(OctreeBounds, HoldForTrianglesOnOneVertex) { expect_always_bounded(OctreeMesh::on_one_vertex(30000)); }
TEST(OctreeBounds, HoldForAMillionTrianglesOnOneVertex) { expect_bounded(OctreeMesh::on_one_vertex(1000000), {}); }
TEST(OctreeBounds, HoldForIdenticalTriangles) { expect_always_bounded(OctreeMesh::identical(30000)); }
TEST(OctreeBounds, HoldForNeedles) { expect_always_bounded(OctreeMesh::needles(20000)); }
TEST(OctreeBounds, HoldForLargeTriangles) { expect_always_bounded(OctreeMesh::soup(10000, 1)); }
TEST(OctreeBounds, HoldForOneTriangle) { expect_always_bounded(OctreeMesh::identical(1)); }

// The same needle along the diagonal, where boxes about it shrink for ever.
TEST(OctreeBounds, HoldForIdenticalNeedles) {
    OctreeMesh mesh;
    for (int i = 0; i < 20000; ++i) mesh.add({0, 0, 0}, {1, 1, 1}, {1, 1.00001, 1});
    expect_always_bounded(mesh);
}

TEST(OctreeBounds, HoldForTrianglesThatShrinkTowardsACorner) {
    OctreeMesh mesh;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> place(0, 1);
    for (int i = 0; i < 20000; ++i) {
        const double s = std::pow(10, -9 * place(random));
        const auto p = [&] { return OctreeMesh::Point{s * place(random), s * place(random), s * place(random)}; };
        const OctreeMesh::Point a = p(), b = p(), c = p();
        mesh.add(a, b, c);
    }
    expect_always_bounded(mesh);
}

TEST(OctreeBounds, HoldWithoutExtentAlongAnAxis) {
    expect_always_bounded(OctreeMesh::disc(20000));
    OctreeMesh line;
    for (int i = 0; i < 5000; ++i) line.add({0, 0, i + 0.0}, {0, 0, i + 0.5}, {0, 0, i + 1.0});
    expect_always_bounded(line);
    OctreeMesh point;
    for (int i = 0; i < 5000; ++i) point.add({1, 2, 3}, {1, 2, 3}, {1, 2, 3});
    expect_always_bounded(point);
}

// A fan of many triangles about a middle where four cells would meet is separated nevertheless.
TEST(OctreeBounds, AFlatFanIsSeparated) {
    const Octree tree = build_octree(OctreeMesh::disc(20000).part(), {}, SerialExecutor());
    EXPECT_LT(octree_stats(tree).crossed_blocks, 20000.0 / 16 / 10);
}

TEST(OctreeBounds, HoldAtTheEndsOfFloat) {
    for (const double scale : {1e-44, 1e-38, 1e-30, 1e30, 1e38}) {
        OctreeMesh mesh = OctreeMesh::sphere(30);
        mesh.move(scale, {0, 0, 0});
        expect_always_bounded(mesh);
        const Octree tree = build_octree(mesh.part(), {}, SerialExecutor());
        for (const float cells : tree.frame.cells_a_unit) EXPECT_TRUE(std::isfinite(cells) && cells > 0);
    }
    OctreeMesh far_away = OctreeMesh::sphere(30);
    far_away.move(1e-3, {1e6, -1e6, 1e6});  // all in a few points
    expect_always_bounded(far_away);
}

}  // namespace
}  // namespace enfilade::accel
