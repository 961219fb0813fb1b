// Rays aimed exactly at corners and edges of closed meshes: none gets through any octree, however it is walked.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/judge_octrees.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {
namespace {

using render::ObjectRay;
using render::Vec3d;

/// Asks 16 at a time, in every walk; counts the rays that hit nothing.
std::uint64_t passed(const std::vector<OctreeWalk>& walks, const std::vector<ObjectRay>& rays) {
    std::uint64_t through = 0;
    for (const OctreeWalk& walk : walks) {
        for (const ObjectRay& asked : rays) {
            ObjectRay ray = asked;
            through += !walk.nearest(ray);
            through += !walk.blocked(asked);
        }
        if (!walk.nearest16) continue;
        for (std::size_t first = 0; first < rays.size(); first += 16) {
            for (const auto& nearest : {walk.nearest16, walk.nearest16_apart}) {
                render::ObjectRays all = rays_together(rays, first);
                alignas(64) std::array<std::int32_t, 16> valid;
                valid.fill(-1);
                nearest(valid.data(), all);
                for (std::size_t i = 0; i < 16; ++i) through += all.triangle[i] == render::no_triangle;
            }
        }
    }
    return through;
}

TEST(OctreeLeaks, NothingPassesBetweenTrianglesOfABall) {
    const TriedMesh mesh(ball_mesh(24, 1));
    RandomNumbers numbers(13);
    std::uint64_t count = 0;
    for (int round = 0; round < 66; ++round) {
        const TriedOctree octree(mesh, {.depth = round % 4 == 0 ? accel::OctreeOptions::automatic : 4u + round % 14u,
                                        .leaf_size = 4,
                                        .is_balanced = round % 3 == 0});
        const std::vector<OctreeWalk> walks = octree_walks(octree);
        const Vec3d direction = normalized(numbers.point(1));
        const Vec3d from = (round % 5 == 4 ? 2e4 : 3.0) * direction + numbers.point(0.01);
        std::vector<ObjectRay> rays;
        for (const std::uint32_t t : mesh.used()) {
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d a = mesh.corner(t, k), b = mesh.corner(t, (k + 1) % 3);
                const Vec3d p = a + 0.25 * (round % 4) * (b - a);
                if (length(cross(from, normalized(p - from))) > 0.9) continue;  // past the rim, or along a bump
                rays.push_back(object_ray(from, p - from, 0, 100));
            }
        }
        rays.resize(rays.size() / 16 * 16);
        count += rays.size();
        ASSERT_EQ(passed(walks, rays), 0u) << "round " << round;
    }
    EXPECT_GT(count, 250000u);
}

/// From inside a closed box out of which there is no way: through its corners, its edges, the lattice's and along axes.
TEST(OctreeLeaks, NothingGetsOutOfABox) {
    for (const std::uint32_t depth : {0u, 3u, 11u, 20u}) {
        const TriedMesh mesh(box_mesh({-1, -0.5f, 0.25f}, {1, 0.5f, 0.75f}));
        const TriedOctree octree(mesh, {.depth = depth, .leaf_size = 1, .is_balanced = depth == 11});
        const std::vector<OctreeWalk> walks = octree_walks(octree);
        std::vector<ObjectRay> rays;
        for (int i = 0; i < 17 * 17 * 17; ++i) {
            const Vec3d to = {-1 + (i % 17) / 8.0, -0.5 + (i / 17 % 17) / 16.0, 0.25 + (i / 289) / 32.0};
            if (i % 17 % 16 != 0 && i / 17 % 17 % 16 != 0 && i / 289 % 16 != 0) continue;
            const Vec3d from = i % 2 == 0 ? Vec3d{0, 0, 0.5} : Vec3d{0.5, -0.25, 0.375};
            rays.push_back(object_ray(from, to - from, 0, 100));
        }
        for (int i = 0; i < 512; ++i) {
            const Vec3d from = {-0.875 + (i % 8) / 4.0, -0.4375 + (i / 8 % 8) / 8.0, 0.28125 + (i / 64) / 16.0};
            rays.push_back(object_ray(from,
                                      i % 3 == 0   ? Vec3d{i % 2 == 0 ? 1.0 : -1.0, -0.0, 0}
                                      : i % 3 == 1 ? Vec3d{0, i % 2 == 0 ? 1.0 : -1.0, 0}
                                                   : Vec3d{-0.0, 0, i % 2 == 0 ? 1.0 : -1.0},
                                      0, 100));
        }
        rays.resize(rays.size() / 16 * 16);
        EXPECT_GT(rays.size(), 1500u);
        EXPECT_EQ(passed(walks, rays), 0u) << "depth " << depth;
    }
}

}  // namespace
}  // namespace enfilade::test
