// Octrees of meshes that no tree of cells can separate, or that are hardly meshes: the answers of brute force, in
// bounded depth and memory.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/judge_octrees.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {
namespace {

using accel::InputMesh;
using accel::OctreeOptions;
using Point = std::array<float, 3>;
using Triangle = std::array<Point, 3>;

std::vector<OctreeOptions> tried_options() {
    return {{},
            {.is_balanced = true},
            {.depth = 20, .leaf_size = 1},
            {.depth = 20, .leaf_size = 1, .is_balanced = true},
            {.depth = 6, .leaf_size = 2}};
}

/// Leaves, references and depth are within what options and octree.h promise, and every used triangle is listed.
void expect_bounded(const TriedMesh& mesh, const TriedOctree& octree) {
    const accel::Octree& tree = octree.tree();
    EXPECT_LE(tree.frame.depth, accel::largest_octree_depth);
    const std::uint64_t most = accel::octree_entries_a_triangle * mesh.used().size() + accel::octree_entries_spare;
    EXPECT_LE(tree.leaves.size() + tree.references.size(), most);
    std::vector<bool> listed(mesh.triangles().size(), false);
    for (const std::uint32_t t : tree.references) listed[t] = true;
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(listed, true)), mesh.used().size());
}

OctreeTally judge(const std::string& name, const InputMesh& input, double most_beside = 0) {
    const TriedMesh mesh(input);
    OctreeTally sum;
    for (const OctreeOptions& options : tried_options()) {
        SCOPED_TRACE(name + ", depth " + std::to_string(static_cast<int>(options.depth)) + ", leaf size " +
                     std::to_string(static_cast<int>(options.leaf_size)) + (options.is_balanced ? ", balanced" : ""));
        const TriedOctree octree(mesh, options);
        expect_bounded(mesh, octree);
        sum.add(judge_every_family(mesh, octree, 2, 5));
    }
    EXPECT_LE(static_cast<double>(sum.beside), most_beside * static_cast<double>(sum.rays)) << name;
    return sum;
}

TEST(OctreeOfDegenerateMesh, NothingIsHitInNothing) {
    for (const InputMesh& input : {InputMesh{}, soup({{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}}),
                                   soup({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}, {{{3, 0, 0}, {3, 0, 0}, {3, 1, 0}}}})}) {
        const TriedMesh mesh(input);
        ASSERT_TRUE(mesh.used().empty());
        for (const OctreeOptions& options : tried_options()) {
            const TriedOctree octree(mesh, options);
            EXPECT_TRUE(octree.tree().is_empty());
            EXPECT_EQ(octree.view().leaves, nullptr);
            const std::vector<render::ObjectRay> rays(32, object_ray({0, 0.5, 0.5}, {1, 1e-3, 0}, 0, 1e30f));
            const OctreeTally tally = judge_octree(mesh, octree_walks(octree), rays);
            EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
            EXPECT_EQ(tally.hits, 0u);
        }
    }
}

TEST(OctreeOfDegenerateMesh, OneTriangleHoweverItLies) {
    judge("in a plane of an axis", soup({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}));
    judge("tilted", soup({{{{0.1f, 0.2f, 0.3f}, {1.3f, -0.2f, 0.7f}, {0.3f, 1, -1}}}}));
    judge("a needle", soup({{{{0, 0, 0}, {100, 1e-4f, 0}, {50, 0, 2e-4f}}}}), 0.2);
    judge("a needle along a diagonal", soup({{{{0, 0, 0}, {100, 100, 100}, {50, 50.0001f, 50}}}}), 0.2);
}

TEST(OctreeOfDegenerateMesh, TheSameTriangleAThousandTimes) {
    std::vector<Triangle> copies(1000, {{{-1, -1, 0.5f}, {1, -1, 0.25f}, {0, 1, 0.5f}}});
    copies.push_back({{{-1, -1, -1}, {1, 1, 1}, {1, -1, 1}}});
    const OctreeTally tally = judge("copies", soup(copies));
    EXPECT_GT(tally.hits, tally.rays / 4);
}

TEST(OctreeOfDegenerateMesh, TrianglesOfAFifthOfAMillimetreInAHundredMetres) {
    // A floor of 100 m, a fan of large triangles, and crumbs of 0.2 mm on it and beyond: each crumb is found.
    std::vector<Triangle> triangles = {{{{-50, -50, 0}, {50, -50, 0}, {50, 50, 0}}},
                                       {{{-50, -50, 0}, {50, 50, 0}, {-50, 50, 0}}}};
    RandomNumbers numbers(3);
    std::vector<std::array<double, 3>> crumbs;
    for (int i = 0; i < 300; ++i) {
        const std::array<double, 3> at = {49.9 * numbers.next(), 49.9 * numbers.next(), 0.5 * numbers.next()};
        crumbs.push_back(at);
        const auto x = static_cast<float>(at[0]), y = static_cast<float>(at[1]), z = static_cast<float>(at[2]);
        triangles.push_back({{{x, y, z}, {x + 2e-4f, y, z}, {x, y + 2e-4f, z + 1e-4f}}});
    }
    const InputMesh input = soup(triangles);
    judge("crumbs", input, 1e-3);
    const TriedMesh mesh(input);
    for (const OctreeOptions& options : tried_options()) {
        const TriedOctree octree(mesh, options);
        std::vector<render::ObjectRay> rays;
        for (std::uint32_t i = 0; i < crumbs.size(); ++i) {
            const render::Vec3d middle =
                (1.0 / 3) * (mesh.corner(i + 2, 0) + mesh.corner(i + 2, 1) + mesh.corner(i + 2, 2));
            rays.push_back(object_ray({middle.x, middle.y, 0.51}, {0, 0, -1}, 0, 10));
        }
        const OctreeTally tally = judge_octree(mesh, octree_walks(octree), rays);
        EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
        int found = 0;
        for (std::uint32_t i = 0; i < crumbs.size(); ++i) {
            render::ObjectRay ray = rays[i];
            octree_walks(octree).front().nearest(ray);
            found += ray.triangle >= 2 || crumbs[i][2] < 0;
        }
        EXPECT_EQ(found, 300);
    }
}

TEST(OctreeOfDegenerateMesh, NeedlesAndCornersOfTwoVertices) {
    std::vector<Triangle> triangles;
    RandomNumbers numbers(17);
    const auto place = [&] {
        return Point{static_cast<float>(numbers.next()), static_cast<float>(numbers.next()),
                     static_cast<float>(numbers.next())};
    };
    for (int i = 0; i < 300; ++i) {
        const Point a = place(), b = place();
        Point c = i % 3 == 0 ? a : i % 3 == 1 ? Point{b[0] + 1e-6f, b[1], b[2]} : place();
        if (i % 3 == 2)
            for (std::size_t k = 0; k < 3; ++k) c[k] = 0.5f * (a[k] + b[k]) + (k == 0 ? 1e-5f : 0);
        triangles.push_back({a, b, c});
    }
    EXPECT_EQ(TriedMesh(soup(triangles)).used().size(), 200u);
    judge("needles", soup(triangles), 0.05);
}

TEST(OctreeOfDegenerateMesh, ManySheetsOnOneEdgeAndManyPointsInOne) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 64; ++i) {  // pages of a book: sixty-four triangles share the edge from (0, 0, -1) to (0, 0, 1)
        const double turn = 2 * std::numbers::pi * i / 64;
        triangles.push_back(
            {{{0, 0, -1}, {0, 0, 1}, {static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), 0}}});
    }
    for (int i = 0; i < 64; ++i) {  // a fan of slivers about one corner
        const double a = 0.001 * i, b = 0.001 * (i + 1);
        triangles.push_back({{{1, 1, 1},
                              {static_cast<float>(1 - std::cos(a)), static_cast<float>(1 - std::sin(a)), 0.5f},
                              {static_cast<float>(1 - std::cos(b)), static_cast<float>(1 - std::sin(b)), 0.5f}}});
    }
    judge("a book and a fan", soup(triangles), 0.02);
}

TEST(OctreeOfDegenerateMesh, EverSmallerTowardsOnePoint) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < 100; ++i) {
        const float s = std::ldexp(1.0f, -i % 60);
        triangles.push_back({{{s, 0, 0}, {s, s, 0}, {s, 0, s}}});
    }
    judge("ever smaller", soup(triangles), 1e-3);
}

TEST(OctreeOfDegenerateMesh, FlatInOneAxisAndInTheBorderOfItsBox) {
    std::vector<Triangle> tiles;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) {
            const auto x = static_cast<float>(i), y = static_cast<float>(j);
            tiles.push_back({{{x, y, 3}, {x + 1, y, 3}, {x + 1, y + 1, 3}}});
            tiles.push_back({{{x, y, 3}, {x + 1, y + 1, 3}, {x, y + 1, 3}}});
        }
    judge("tiles", soup(tiles));
    judge("tiles far away", moved(soup(tiles), 1, 5e5f));
}

/// How long it takes is left to the benchmarks: here it must end within what the test may take.
TEST(OctreeOfDegenerateMesh, AMillionTrianglesOnOneVertexAreBounded) {
    constexpr std::uint32_t count = 1000000;
    InputMesh mesh;
    mesh.vertices.push_back({0, 0, 0});
    for (std::uint32_t i = 0; i <= count; ++i) {
        const double turn = 2 * std::numbers::pi * i / count;
        mesh.vertices.push_back({static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)), 0.25f});
        if (i < count) mesh.triangles.push_back({0, i + 1, i + 2});
    }
    const TriedMesh tried(mesh);
    for (const OctreeOptions& options : {OctreeOptions{}, {.depth = 20, .leaf_size = 8}}) {
        const TriedOctree octree(tried, options);
        expect_bounded(tried, octree);
        const std::vector<OctreeWalk> walks = octree_walks(octree);
        OctreeRays draw(tried, octree.tree().frame, 3);
        std::vector<render::ObjectRay> rays;
        for (int i = 0; i < 26; ++i)
            rays.push_back(draw.take(octree_ray_families[static_cast<std::size_t>(i) % 13].family));
        const OctreeTally tally = judge_octree(tried, walks, rays);
        EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
        EXPECT_GT(tally.hits, 5u);
    }
}

}  // namespace
}  // namespace enfilade::test
