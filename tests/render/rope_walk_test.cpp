// Walks through the paper's octree, completed: the same answers as brute force to the last bit, and every leaf at most
// once.

#include "render/rope_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/support/object_scenes.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"
#include "tools/deep_octree.h"

namespace enfilade::test {
namespace {

using accel::OctreeOptions;
using accel::RopeAddress;
using accel::RopeOctree;
using accel::RopeView;
using render::ObjectRay;

struct RopeVariant {
    bool is_balanced, has_stored_boxes, is_double;
};

/// Counts, and keeps the way.
struct Counting {
    std::vector<RopeAddress> leaves;
    int recovered = 0, returns = 0;
    void entered_leaf(RopeAddress leaf, std::uint32_t) { leaves.push_back(leaf); }
    void descended(std::uint32_t) {}
    void recovered_exit(RopeAddress) { ++recovered; }
    void came_back(RopeAddress) { ++returns; }
};

template <bool any>
bool walk(const RopeVariant& variant, const RopeView& view, ObjectRay& ray, Counting& events) {
    return variant.is_double ? render::rope_walk<double, any>(view, ray, events)
                             : render::rope_walk<float, any>(view, ray, events);
}

class RopeWalkTest : public ::testing::TestWithParam<RopeVariant> {
protected:
    static RopeOctree ropes(const TriedMesh& mesh, const accel::Octree& tree) {
        return {tree, mesh.part(), {GetParam().is_balanced, GetParam().has_stored_boxes}, accel::SerialExecutor()};
    }
    static bool walk_nearest(const RopeView& view, ObjectRay& ray, Counting& events) {
        return walk<false>(GetParam(), view, ray, events);
    }
    static bool walk_any(const RopeView& view, ObjectRay ray, Counting& events) {
        return walk<true>(GetParam(), view, ray, events);
    }
};

INSTANTIATE_TEST_SUITE_P(All, RopeWalkTest,
                         ::testing::Values(RopeVariant{true, true, false}, RopeVariant{true, true, true},
                                           RopeVariant{true, false, false}, RopeVariant{true, false, true},
                                           RopeVariant{false, true, false}, RopeVariant{false, true, true},
                                           RopeVariant{false, false, false}, RopeVariant{false, false, true}),
                         [](const auto& variant) {
                             return std::string(variant.param.is_balanced ? "Balanced" : "Free") +
                                    (variant.param.has_stored_boxes ? "Stored" : "Implicit") +
                                    (variant.param.is_double ? "Double" : "Float");
                         });

/// The mesh in an octree that is deep about some of its corners.
accel::Octree deep_about_corners(const TriedMesh& mesh, std::uint32_t depth, bool is_balanced) {
    accel::OctreeFrame frame;
    frame.depth = depth;
    const double widened = mesh.size() * (1 + 0x1p-20);
    for (int k = 0; k < 3; ++k) {
        frame.low[static_cast<std::size_t>(k)] = mesh.low(k);
        frame.cells_a_unit[static_cast<std::size_t>(k)] = static_cast<float>(double{frame.side()} / widened);
    }
    std::vector<std::array<double, 3>> about;
    const std::size_t step = std::max<std::size_t>(1, mesh.used().size() / (depth > 10 ? 12 : 60));
    for (std::size_t i = 0; i < mesh.used().size(); i += step) {
        const render::Vec3d p = mesh.corner(mesh.used()[i], i % 3);
        about.push_back({(p.x - mesh.low(0)) * double{frame.cells_a_unit[0]},
                         (p.y - mesh.low(1)) * double{frame.cells_a_unit[1]},
                         (p.z - mesh.low(2)) * double{frame.cells_a_unit[2]}});
    }
    return tools::deep_octree(mesh.part(), {frame, about, is_balanced});
}

std::vector<accel::InputMesh> meshes() {
    return {ball_mesh(10, 1), box_mesh({-1, -1, -1}, {1, 1, 1}), random_soup(150, 0.3f, 1), random_soup(3, 1, 2)};
}

TEST_P(RopeWalkTest, AnswersAsBruteForce) {
    std::uint64_t hits = 0, misses = 0, beside = 0;
    for (const accel::InputMesh& input : meshes()) {
        const TriedMesh mesh(input);
        for (const std::uint32_t depth : {0u, 3u, 8u, 14u, 20u}) {
            const accel::Octree tree = deep_about_corners(mesh, depth, GetParam().is_balanced);
            const RopeOctree built = ropes(mesh, tree);
            OctreeRays draw(mesh, tree.frame, depth);
            for (const NamedOctreeRays& named : octree_ray_families) {
                for (int i = 0; i < 150; ++i) {
                    const ObjectRay asked = draw.take(named.family);
                    const ObjectRay expected = mesh.nearest(asked);
                    ObjectRay found = asked;
                    Counting events;
                    const bool is_met = walk_nearest(built.view(), found, events);
                    ASSERT_EQ(is_met, found.triangle != render::no_triangle);
                    const bool is_same = found.triangle == expected.triangle && found.far == expected.far &&
                                         found.u == expected.u && found.v == expected.v;
                    // Of a triangle that the ray runs along, the test takes a place beside it for the meeting.
                    const double off = std::max(
                        expected.triangle == render::no_triangle ? 0 : mesh.off_triangle(asked, expected.triangle),
                        is_met ? mesh.off_triangle(asked, found.triangle) : 0);
                    if (!is_same && off > 1e-6) {
                        ++beside;
                        continue;
                    }
                    ASSERT_TRUE(is_same) << named.name << ", depth " << depth << ": " << found.triangle << " at "
                                         << found.far << ", not " << expected.triangle << " at " << expected.far;
                    ASSERT_EQ(walk_any(built.view(), asked, events), is_met) << named.name << ", depth " << depth;
                    ++(is_met ? hits : misses);
                }
            }
        }
    }
    EXPECT_GT(hits, 10000u);
    EXPECT_GT(misses, 4000u);
    EXPECT_LT(beside, 40u);
}

/// Where a leaf comes in the order of Morton keys, for a ray of an octant.
std::uint64_t mirrored_key(const RopeView& view, RopeAddress leaf, std::uint32_t octant) {
    const accel::RopeCube cube = accel::cube_of(view, leaf);
    std::uint64_t key = 0;
    for (std::uint32_t bit = view.frame.depth; bit-- > 0;)
        for (std::uint32_t k = 3; k-- > 0;) {
            const std::uint32_t up = bit < view.frame.depth - cube.level ? 0u : cube.low[k] >> bit & 1u;
            key = key << 1 | (bit < view.frame.depth - cube.level ? 0u : up ^ (octant >> k & 1u) ^ 1u);
        }
    return key;
}

TEST_P(RopeWalkTest, ComesToLeavesInMirroredMortonOrder) {
    const TriedMesh mesh(random_soup(40, 0.02f, 5));
    int steps = 0;
    for (const std::uint32_t depth : {5u, 12u, 20u}) {
        const accel::Octree tree = deep_about_corners(mesh, depth, GetParam().is_balanced);
        const RopeOctree built = ropes(mesh, tree);
        const RopeView view = built.view();
        OctreeRays draw(mesh, tree.frame, 3);
        for (const NamedOctreeRays& named : octree_ray_families) {
            for (int i = 0; i < 60; ++i) {
                ObjectRay ray = draw.take(named.family);
                const float direction[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
                const float origin[3] = {0, 0, 0};
                const auto r = render::rope_ray<double>(view.frame, origin, direction);
                Counting way;
                walk_nearest(view, ray, way);
                for (std::size_t j = 1; j < way.leaves.size(); ++j)
                    ASSERT_GT(mirrored_key(view, way.leaves[j], r.octant),
                              mirrored_key(view, way.leaves[j - 1], r.octant))
                        << named.name;
                steps += static_cast<int>(way.leaves.size());
            }
        }
    }
    EXPECT_GT(steps, 10000);
}

/// The leaf where a walk begins, from outside by the cube map, holds the place that the tree gives for it.
TEST_P(RopeWalkTest, EntersByTheCubeMapWhereTheTreeSays) {
    const TriedMesh mesh(random_soup(60, 0.05f, 9));
    const accel::Octree tree = deep_about_corners(mesh, 6, GetParam().is_balanced);
    const RopeOctree built = ropes(mesh, tree);
    const RopeView view = built.view();
    OctreeRays draw(mesh, tree.frame, 8);
    int outside = 0, inside = 0;
    for (int i = 0; i < 2000; ++i) {
        const ObjectRay ray = draw.take(i % 2 == 0 ? OctreeRayFamily::Outside : OctreeRayFamily::Inside);
        const float origin[3] = {ray.origin_x, ray.origin_y, ray.origin_z};
        const float direction[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
        const auto r = render::rope_ray<double>(view.frame, origin, direction);
        render::RopePart<double> part = {ray.near, ray.far, render::invalid_exit};
        if (!render::part_in_cube(view, r, part)) continue;
        Counting events;
        const RopeAddress leaf = render::first_leaf(view, r, part, events);
        const accel::RopeCube cube = accel::cube_of(view, leaf);
        for (int k = 0; k < 3; ++k) {
            const double p = r.origin[k] + part.enter * r.direction[k];
            ASSERT_GE(p, cube.low[k] - 1e-3);
            ASSERT_LE(p, cube.low[k] + cube.width + 1e-3);
        }
        (part.face == render::invalid_exit ? inside : outside)++;
    }
    EXPECT_GT(outside, 500);
    EXPECT_GT(inside, 500);
}

/// A triangle that reaches through several leaves is met in the first, but something nearer lies in the second: the
/// paper's loop would return the first.
TEST_P(RopeWalkTest, DoesNotTakeAHitThatLiesBeyondTheLeaf) {
    // Seen along x, the large one slopes from the first eighth (out of the ray's way) to x = 7.
    const TriedMesh mesh(soup({{{{0.5f, 0, 3.9f}, {8, 8, 0.1f}, {8, 0, 0.1f}}},
                               {{{4.5f, 0.4f, 0.4f}, {4.5f, 2, 0.4f}, {4.5f, 0.4f, 2}}},
                               {{{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}}},
                               {{{8, 8, 8}, {7.9f, 8, 8}, {8, 7.9f, 8}}}}));
    const accel::Octree tree = deep_about_corners(mesh, 1, GetParam().is_balanced);
    ASSERT_EQ(tree.leaves.size(), 8u);
    const auto first = tree.leaves[0];
    ASSERT_TRUE(std::count(tree.references.begin() + first.first, tree.references.begin() + first.first + first.count,
                           0u) == 1);
    const RopeOctree built = ropes(mesh, tree);
    ObjectRay ray = object_ray({-1, 0.6, 0.6}, {1, 0, 0}, 0, 100);
    const ObjectRay beyond = ray;
    Counting events;
    ASSERT_TRUE(walk_nearest(built.view(), ray, events));
    EXPECT_EQ(ray.triangle, 1u);
    EXPECT_EQ(ray.far, 5.5f);
    EXPECT_EQ(events.leaves.size(), 2u);
    EXPECT_EQ(mesh.off_triangle(beyond, 0) < 1e-6 && mesh.off_triangle(beyond, 0) >= 0, true);
}

TEST_P(RopeWalkTest, NeverHitsAnythingWhereThereIsNothing) {
    const RopeOctree none;
    ObjectRay ray = object_ray({0, 0, 0}, {1, 0, 0}, 0, 10);
    Counting events;
    EXPECT_FALSE(walk_nearest(none.view(), ray, events));
    EXPECT_EQ(ray.triangle, render::no_triangle);
}

}  // namespace
}  // namespace enfilade::test
