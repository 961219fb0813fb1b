// Any mesh, any options, any rays. ENFILADE_OCTREE_RAYS=100000000 asks as many rays of each family together
// (tools/campaign.sh octrees), ENFILADE_OCTREE_SERIES=1 others.

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "tests/support/judge_octrees.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {
namespace {

using accel::OctreeOptions;

/// Triangles with corners on a coarse raster (so that they touch, overlap and lie in planes of the lattice), anywhere,
/// or tiny.
accel::InputMesh any_mesh() {
    const auto kind = *rc::gen::inRange(0, 4);
    const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(1, 60));
    if (kind == 0) return random_soup(count, 0.5f, *rc::gen::arbitrary<std::uint32_t>());
    const int raster = kind == 1 ? 4 : kind == 2 ? 64 : 4096;
    const int reach = kind == 3 ? 3 : raster;
    std::vector<std::array<std::array<float, 3>, 3>> triangles(count);
    for (auto& triangle : triangles) {
        std::array<int, 3> at;
        for (int& c : at) c = *rc::gen::inRange(0, raster + 1);
        for (auto& corner : triangle)
            for (std::size_t k = 0; k < 3; ++k)
                corner[k] = static_cast<float>(kind == 3 ? at[k] + *rc::gen::inRange(0, reach)
                                                         : *rc::gen::inRange(0, raster + 1));
    }
    return soup(triangles);
}

OctreeOptions any_options() {
    OctreeOptions options;
    options.depth = *rc::gen::element(OctreeOptions::automatic, 0u, 1u, 2u, 3u, 5u, 8u, 13u, 20u);
    options.leaf_size = *rc::gen::element(OctreeOptions::automatic, 0u, 1u, 2u, 4u, 16u, 33u);
    options.is_balanced = *rc::gen::arbitrary<bool>();
    options.cost.block = *rc::gen::element(1.0, 10.0, 200.0);
    options.cost.empty_leaf = *rc::gen::element(0.0, 16.0, 30.0);
    return options;
}

RC_GTEST_PROP(AnyOctree, AnswersAsBruteForceAsksNothingElseAndSixteenAsOne, ()) {
    const TriedMesh mesh(any_mesh());
    RC_PRE(!mesh.used().empty());
    const TriedOctree octree(mesh, any_options());
    const std::vector<OctreeWalk> walks = octree_walks(octree);
    OctreeRays draw(mesh, octree.tree().frame, *rc::gen::arbitrary<std::uint32_t>());
    for (const NamedOctreeRays& named : octree_ray_families) {
        std::vector<render::ObjectRay> rays;
        for (int i = 0; i < 32; ++i) rays.push_back(draw.take(named.family));
        const OctreeTally tally = judge_octree(mesh, walks, rays);
        if (tally.wrong != 0) RC_FAIL(std::string(named.name) + ": " + tally.first_wrong);
    }
}

/// The surface that is found from one side is found from the other.
RC_GTEST_PROP(AnyOctree, IsMetAtTheSamePlaceByReversedRays, ()) {
    const accel::InputMesh input = ball_mesh(*rc::gen::inRange(3, 12), 1);
    const TriedMesh mesh(input);
    const TriedOctree octree(mesh, any_options());
    const std::vector<OctreeWalk> walks = octree_walks(octree);
    RandomNumbers numbers(*rc::gen::arbitrary<std::uint32_t>());
    for (int i = 0; i < 50; ++i) {
        const render::Vec3d inside = numbers.point(0.3), way = normalized(numbers.point(1));
        for (const OctreeWalk& walk : walks) {
            // The ball's bumps hide no place of it from places so near its middle.
            render::ObjectRay out = object_ray(inside, way, 0, 10);
            RC_ASSERT(walk.nearest(out));
            const render::Vec3d beyond = inside + 3.0 * way;
            render::ObjectRay in = object_ray(beyond, -way, 0, 10);
            RC_ASSERT(walk.nearest(in));
            RC_ASSERT(std::abs(3.0 - double{out.far} - double{in.far}) < 1e-5 || in.triangle != out.triangle);
        }
    }
}

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
    const char* const text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

/// Meshes of up to a few hundred triangles, 160 rays of each family to each.
TEST(AnyOctree, AnswersAsBruteForceInCampaigns) {
    const std::uint64_t count = number_from("ENFILADE_OCTREE_RAYS", 60000);
    const std::uint64_t series = number_from("ENFILADE_OCTREE_SERIES", 0) << 32;
    std::array<OctreeTally, octree_ray_families.size()> tallies;
    std::uint64_t asked = 0;
    for (std::uint64_t seed = series; asked < count; ++seed) {
        RandomNumbers numbers(seed);
        const auto pick = [&](std::uint32_t n) { return static_cast<std::uint32_t>((0.5 * numbers.next() + 0.5) * n); };
        const std::array<float, 4> sizes = {0.02f, 0.1f, 0.5f, 1.5f};
        accel::InputMesh input = pick(4) == 0 ? ball_mesh(static_cast<int>(2 + pick(10)), 1)
                                              : random_soup(1 + pick(300), sizes[pick(4)], seed);
        const std::array<float, 5> offsets = {0, 0, 1, 1e3f, 1e5f};
        const TriedMesh mesh(moved(std::move(input), std::ldexp(1.0f, static_cast<int>(pick(40)) - 20),
                                   offsets[pick(5)] * std::ldexp(1.0f, static_cast<int>(pick(4)))));
        if (mesh.used().empty()) continue;
        const std::array<std::uint32_t, 6> depths = {OctreeOptions::automatic, 3, 6, 10, 15, 20};
        const std::array<std::uint32_t, 4> leaf_sizes = {OctreeOptions::automatic, 1, 4, 24};
        const TriedOctree octree(
            mesh, {.depth = depths[pick(6)], .leaf_size = leaf_sizes[pick(4)], .is_balanced = pick(3) == 0});
        const std::vector<OctreeWalk> walks = octree_walks(octree);
        OctreeRays draw(mesh, octree.tree().frame, seed);
        for (std::size_t f = 0; f < octree_ray_families.size(); ++f) {
            std::vector<render::ObjectRay> rays;
            for (int i = 0; i < 160; ++i) rays.push_back(draw.take(octree_ray_families[f].family));
            const OctreeTally tally = judge_octree(mesh, walks, rays);
            asked += tally.rays;
            EXPECT_EQ(tally.wrong, 0u) << "mesh " << seed << ", " << octree_ray_families[f].name << ": "
                                       << tally.first_wrong;
            tallies[f].add(tally);
        }
    }
    for (std::size_t f = 0; f < octree_ray_families.size(); ++f) {
        const OctreeTally& tally = tallies[f];
        EXPECT_GT(tally.hits, 0u) << octree_ray_families[f].name;
        std::cout << "octrees | " << octree_ray_families[f].name << " | " << tally.rays << " | " << tally.hits << " | "
                  << tally.beside << " | " << tally.wrong << " |\n";
    }
}

}  // namespace
}  // namespace enfilade::test
