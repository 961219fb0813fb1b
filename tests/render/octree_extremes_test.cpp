// Octrees at their limits, against brute force to the last bit: every depth, every place and size, every kind of ray.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/judge_octrees.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {
namespace {

std::vector<accel::InputMesh> plain_meshes() {
    return {ball_mesh(10, 1), box_mesh({-1, -1, -1}, {1, 1, 1}), random_soup(150, 0.3f, 1), random_soup(3, 1, 2)};
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
                sum.add(judge_every_family(mesh, TriedOctree(mesh, {.depth = depth, .leaf_size = 4}), 2, depth));
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
                const TriedOctree octree(
                    mesh, {.depth = depth, .leaf_size = depth > 8 ? 4u : 1u, .is_balanced = is_balanced});
                sum.add(judge_every_family(mesh, octree, 3, depth));
            }
        }
        EXPECT_GT(sum.hits, sum.rays / 4);
        EXPECT_LE(sum.beside, sum.rays / 100);
    }
}

}  // namespace
}  // namespace enfilade::test
