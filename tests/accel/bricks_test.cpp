// Bricks of an octree: every triangle is in every cell that it meets.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <vector>

#include "accel/octree/bricks.h"
#include "accel/octree/triangle_box.h"
#include "tests/accel/octree_meshes.h"

namespace enfilade::accel {
namespace {

using test::OctreeMesh;

constexpr std::uint32_t floats = 10;

/// A cell of some brick.
struct Cell {
    std::array<double, 3> low;
    double width;
};

Corners lattice_corners(const Octree& tree, const MeshPart& mesh, std::uint32_t triangle) {
    Corners corners;
    for (std::size_t c = 0; c < 3; ++c) {
        const Vertex& v = mesh.places[mesh.triangles[triangle].corners[c]];
        const std::array<float, 3> p = {v.x, v.y, v.z};
        for (std::size_t k = 0; k < 3; ++k)
            corners[c][k] = (double{p[k]} - double{tree.frame.low[k]}) * double{tree.frame.cells_a_unit[k]};
    }
    return corners;
}

/// Walks all bricks; counts triangles that miss in a cell that they meet.
class Census {
public:
    Census(const Octree& tree, const MeshPart& mesh, const Bricks& bricks)
        : tree_(tree), mesh_(mesh), bricks_(bricks), slack_(octree_slack * double{tree.frame.side()}) {
        for (const OctreeLeaf& leaf : tree.leaves)
            if (leaf.count > 0) leaf_at_[floats * leaf.first] = &leaf;
    }

    void look_into(std::uint32_t brick, const std::array<double, 3>& low, double width,
                   const std::vector<std::uint32_t>& here) {
        seen_.insert(brick);
        const std::uint64_t mask = bricks_.masks[brick].mirrored[0];
        std::size_t at = bricks_.first[brick];
        for (std::uint32_t bit = 0; bit < 64; ++bit) {
            const double w = width / 4;
            const std::array<double, 3> corner = {low[0] + w * (bit & 3), low[1] + w * (bit >> 2 & 3),
                                                  low[2] + w * (bit >> 4)};
            std::vector<std::uint32_t> inside;
            for (const std::uint32_t t : here)
                if (triangle_meets_box(lattice_corners(tree_, mesh_, t),
                                       {corner[0] + w / 2, corner[1] + w / 2, corner[2] + w / 2}, w / 2 + slack_))
                    inside.push_back(t);
            if ((mask >> bit & 1) == 0) {
                missing += inside.size();
                continue;
            }
            const BrickEntry entry = bricks_.entries[at++];
            if (!entry.is_leaf()) {
                look_into(entry.brick(), corner, w, inside);
                continue;
            }
            const OctreeLeaf& leaf = *leaf_at_.at(entry.first());
            EXPECT_EQ(entry.count(), leaf.count);
            const auto begin = tree_.references.begin() + leaf.first;
            for (const std::uint32_t t : inside) missing += !std::binary_search(begin, begin + leaf.count, t);
            ++full_cells;
            empty_in_full += inside.empty();
        }
    }

    std::size_t missing = 0, full_cells = 0, empty_in_full = 0;
    [[nodiscard]] std::size_t bricks_seen() const { return seen_.size(); }

private:
    const Octree& tree_;
    MeshPart mesh_;
    const Bricks& bricks_;
    double slack_;
    std::map<std::uint32_t, const OctreeLeaf*> leaf_at_;
    std::set<std::uint32_t> seen_;
};

void expect_sound(const OctreeMesh& mesh, const OctreeOptions& options) {
    const Octree tree = build_octree(mesh.part(), options, SerialExecutor());
    const Bricks bricks = build_bricks(tree, mesh.part(), floats, SerialExecutor());
    Census census(tree, mesh.part(), bricks);
    const std::vector<std::uint32_t> all(mesh.part().used.begin(), mesh.part().used.end());
    census.look_into(0, {0, 0, 0}, double{tree.frame.side()}, all);
    EXPECT_EQ(census.missing, 0U);
    EXPECT_EQ(census.bricks_seen(), bricks.masks.size());
    EXPECT_GT(census.full_cells, 0U);
    EXPECT_LE(census.empty_in_full, census.full_cells / 4 + 64);  // a leaf at the root fills its brick
}

TEST(Bricks, HoldEveryTriangleInEveryCellThatItMeets) {
    for (const OctreeMesh& mesh : {OctreeMesh::sphere(20), OctreeMesh::soup(600, 0.08), OctreeMesh::needles(40),
                                   OctreeMesh::on_one_vertex(200), OctreeMesh::disc(200), OctreeMesh::identical(20)}) {
        expect_sound(mesh, {});
        for (const std::uint32_t depth : {0U, 1U, 2U, 3U, 4U, 5U}) expect_sound(mesh, {.depth = depth, .leaf_size = 3});
    }
}

TEST(Bricks, OfUsedTrianglesAlone) {
    OctreeMesh mesh = OctreeMesh::soup(900, 0.1);
    mesh.use_every(5);
    expect_sound(mesh, {.leaf_size = 4});
}

TEST(Bricks, AreMirroredForEachOctant) {
    const OctreeMesh mesh = OctreeMesh::soup(500, 0.05);
    const Octree tree = build_octree(mesh.part(), {.leaf_size = 4}, SerialExecutor());
    const Bricks bricks = build_bricks(tree, mesh.part(), floats, SerialExecutor());
    for (const BrickMasks& masks : bricks.masks) {
        for (std::uint32_t axes = 0; axes < 8; ++axes) {
            ASSERT_EQ(std::popcount(masks.mirrored[axes]), std::popcount(masks.mirrored[0]));
            for (std::uint32_t x = 0; x < 4; ++x)
                for (std::uint32_t y = 0; y < 4; ++y)
                    for (std::uint32_t z = 0; z < 4; ++z) {
                        const std::uint32_t there = ((axes & 1) != 0 ? 3 - x : x) | ((axes & 2) != 0 ? 3 - y : y) << 2 |
                                                    ((axes & 4) != 0 ? 3 - z : z) << 4;
                        ASSERT_EQ(masks.mirrored[0] >> (x | y << 2 | z << 4) & 1, masks.mirrored[axes] >> there & 1);
                    }
        }
    }
}

TEST(Bricks, AreTheSameOnAnyNumberOfThreads) {
    const OctreeMesh mesh = OctreeMesh::sphere(50);
    const Octree tree = build_octree(mesh.part(), {}, SerialExecutor());
    const Bricks one = build_bricks(tree, mesh.part(), floats, SerialExecutor());
    const Bricks many = build_bricks(tree, mesh.part(), floats, ThreadExecutor(3));
    EXPECT_EQ(one.entries, many.entries);
    EXPECT_EQ(one.first, many.first);
}

}  // namespace
}  // namespace enfilade::accel
