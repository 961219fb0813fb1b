// Octrees at their limits, against brute force to the last bit: every depth, every place and size, every kind of ray.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/support/object_scenes.h"
#include "tests/support/octree_judge.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {
namespace {

using accel::OctreeOptions;
using render::ObjectRay;

/// The mesh, so many times larger, then so far away along (1, -0.7, 0.4).
accel::InputMesh moved(accel::InputMesh mesh, float scale, float offset) {
    for (auto& v : mesh.vertices) {
        v[0] = scale * v[0] + offset;
        v[1] = scale * v[1] - 0.7f * offset;
        v[2] = scale * v[2] + 0.4f * offset;
    }
    return mesh;
}

std::vector<accel::InputMesh> plain_meshes() {
    return {ball_mesh(10, 1), box_mesh({-1, -1, -1}, {1, 1, 1}), random_soup(150, 0.3f, 1), random_soup(3, 1, 2)};
}

void judge_all(const TriedMesh& mesh, const OctreeOptions& options, int groups, std::uint64_t seed, OctreeTally& sum) {
    const TriedOctree octree(mesh, options);
    const std::vector<OctreeWalk> walks = octree_walks(octree);
    OctreeRays draw(mesh, octree.tree().frame, seed);
    for (const NamedOctreeRays& named : octree_ray_families) {
        std::vector<ObjectRay> rays;
        for (int i = 0; i < 16 * groups; ++i) rays.push_back(draw.take(named.family));
        const OctreeTally tally = judge_octree(mesh, walks, rays);
        EXPECT_EQ(tally.wrong, 0u) << named.name << ": " << tally.first_wrong;
        sum.add(tally);
    }
}

struct Offset {
    double scale, offset;  ///< of a mesh of side 2, then of it
};

TEST(OctreeExtremes, AnywhereAndOfAnySizeAnswerAsBruteForce) {
    // So far away as 1e6 sizes corners keep few bits: what is left of the meshes are steps, and much without area.
    constexpr Offset offsets[] = {{1, 0},      {1, 1e3},    {1, 1e5},     {1, 1e6},      {1e-4, 0},
                                  {1e-4, 0.1}, {1e-4, 100}, {1e-10, 0},   {1e-10, 1e-5}, {1e6, 0},
                                  {1e6, 1e7},  {1e12, 0},   {1e12, 1e15}, {0.3, -7e4}};
    for (const accel::InputMesh& input : plain_meshes()) {
        OctreeTally sum;
        for (const auto& [scale, offset] : offsets) {
            SCOPED_TRACE(input.name + ", " + std::to_string(scale) + " large, " + std::to_string(offset) + " away");
            const TriedMesh mesh(moved(input, static_cast<float>(scale), static_cast<float>(offset)));
            if (mesh.used().empty()) continue;
            for (const std::uint32_t depth : {4u, 9u, 20u})
                judge_all(mesh, {.depth = depth, .leaf_size = 4}, 2, depth, sum);
        }
        EXPECT_GT(sum.hits, sum.rays / 4);
        EXPECT_LE(sum.beside, sum.rays / 100);
    }
}

TEST(OctreeExtremes, OfEveryDepthAnswerAsBruteForce) {
    for (const accel::InputMesh& input : plain_meshes()) {
        const TriedMesh mesh(input);
        OctreeTally sum;
        for (const std::uint32_t depth : {0u, 1u, 2u, 4u, 8u, 12u, 16u, 20u}) {
            for (const bool is_balanced : {false, true}) {
                SCOPED_TRACE(input.name + ", depth " + std::to_string(depth) + (is_balanced ? ", balanced" : ""));
                judge_all(mesh, {.depth = depth, .leaf_size = depth > 8 ? 4u : 1u, .is_balanced = is_balanced}, 3,
                          depth, sum);
            }
        }
        EXPECT_GT(sum.hits, sum.rays / 4);
        EXPECT_LE(sum.beside, sum.rays / 100);
    }
}

}  // namespace
}  // namespace enfilade::test
