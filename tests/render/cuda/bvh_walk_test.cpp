// Rays through baselines' trees against every triangle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/cuda/bvh2.h"
#include "render/cuda/wide_bvh.h"
#include "tests/support/bvh_scenes.h"

namespace enfilade::render::cuda {
namespace {

using test::BvhTruth;
using test::TriedForest;

struct Counts {
    std::uint64_t nodes = 0, triangles = 0, instances = 0;
    int stack = 0;
    void visited_node() { ++nodes; }
    void tested_triangle() { ++triangles; }
    void entered_instance() { ++instances; }
    void stack_holds(int entries) { stack = std::max(stack, entries); }
};

template <class Walk, class View>
BvhHit walked(const View& view, const BvhQuery& query, Counts& counts) {
    Walk walk;
    typename Walk::Stack stack;
    walk.begin(view, query, stack);
    EXPECT_TRUE(walk.go(view, 0, stack, counts));
    EXPECT_LE(counts.stack, Walk::stack_size);
    return walk.hit();
}

/// What a hit says, without where it lies in a tree.
template <class Arrays>
BvhTruth truth_of(const Arrays& arrays, const BvhHit& hit) {
    if (hit.record == no_record) return {hit.t, ~0u, no_object};
    return {hit.t, arrays.records[hit.record].item & item_mask, hit.instance};
}

bool are_equal(const BvhTruth& a, const BvhTruth& b) {
    return a.t == b.t && a.item == b.item && a.instance == b.instance;
}

/// All trees of a scene.
struct TriedTrees {
    TriedForest binary, single;
    Bvh2Arrays bvh2;
    WideBvhArrays wide;

    TriedTrees(const accel::SceneView& view, TriangleTest test, float split_share = 0)
        : binary(view, 8, split_share),
          single(view, 1, split_share),
          bvh2(lay_out_bvh2(binary.scene, binary.forest, test)),
          wide(lay_out_wide_bvh(single.scene, single.forest, test)) {}
};

void expect_exact(const TriedTrees& tried, const std::vector<BvhQuery>& rays) {
    constexpr auto exact = TriangleTest::Watertight;
    Counts counts;
    int wrong = 0, hits = 0;
    for (const BvhQuery& ray : rays) {
        const BvhTruth truth = test::try_all(tried.binary, ray);
        const BvhHit binary = walked<Bvh2Walk<false, true, exact>>(tried.bvh2.view(), ray, counts);
        const BvhHit wide = walked<WideBvhWalk<false, true, exact>>(tried.wide.view(), ray, counts);
        const BvhHit any2 = walked<Bvh2Walk<true, true, exact>>(tried.bvh2.view(), ray, counts);
        const BvhHit any8 = walked<WideBvhWalk<true, true, exact>>(tried.wide.view(), ray, counts);
        const bool is_hit = truth.item != ~0u;
        hits += is_hit ? 1 : 0;
        wrong += are_equal(truth, truth_of(tried.bvh2, binary)) && are_equal(truth, truth_of(tried.wide, wide)) &&
                         (any2.record != no_record) == is_hit && (any8.record != no_record) == is_hit
                     ? 0
                     : 1;
    }
    EXPECT_EQ(wrong, 0) << "of " << rays.size();
    EXPECT_GT(hits, 0);
}

TEST(BvhWalks, MeetWhatTryingEveryTriangleMeets) {
    const accel::Scene scene = test::furnished_office({.objects = 40, .turn = 0.3});
    const TriedTrees tried(scene.view(), TriangleTest::Watertight);
    expect_exact(tried, test::rays_in(tried.binary.forest.top.box, 1, 1000));
}

TEST(BvhWalks, MeetTheSameInSplitTrees) {
    const accel::Scene scene = test::furnished_office({.seed = 2, .objects = 40, .turn = 0.3});
    const TriedTrees tried(scene.view(), TriangleTest::Watertight, 0.5f);
    expect_exact(tried, test::rays_in(tried.binary.forest.top.box, 2, 1000));
}

TEST(BvhWalks, MeetTheFirstOfEqualTriangles) {
    std::vector<std::array<std::array<float, 3>, 3>> equal(3000, {{{-1, 0, 1}, {1, 0, 1}, {0, 1, 2}}});
    const accel::Scene scene = test::room_of_meshes({test::soup(equal), test::soup(equal)});
    const TriedTrees tried(scene.view(), TriangleTest::Watertight);
    expect_exact(tried, test::rays_in({{-1, -1, 0}, {1, 2, 2}}, 3, 100));
}

TEST(BvhWalks, StandMeshesOfAnyShape) {
    accel::InputMesh nothing;
    nothing.vertices = {{0, 0, 0}};
    const accel::InputMesh no_area = test::soup({{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}}});
    const accel::InputMesh one = test::soup({{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}});
    const accel::InputMesh far = test::soup({{{{1e11f, 1e11f, 1}, {1e11f, -1e11f, 1}, {-1e11f, 1, 1}}}});
    accel::InputMesh flat = test::random_soup(500, 0.1f, 9);
    for (auto& v : flat.vertices) v[1] = 0.5f;
    const accel::Scene scene =
        test::room_of_meshes({nothing, no_area, one, far, flat, test::random_soup(2000, 0.3f, 5)});
    const TriedTrees tried(scene.view(), TriangleTest::Watertight);
    expect_exact(tried, test::rays_in({{-1, -1, 0}, {1, 1, 2}}, 4, 500));
}

/// Some triangles lie in one place: either may be met. Between two triangles the fast test may lose a ray.
TEST(BvhWalks, OfFastTestsAreRightButAtEdges) {
    const accel::Scene scene = test::furnished_office({.objects = 40, .turn = 0.3});
    const TriedTrees fast(scene.view(), TriangleTest::Fast), exact(scene.view(), TriangleTest::Watertight);
    Counts counts;
    const auto rays = test::rays_in(fast.binary.forest.top.box, 5, 50'000);
    int lost = 0, hits = 0;
    for (const BvhQuery& ray : rays) {
        const BvhHit truth = walked<Bvh2Walk<false, true, TriangleTest::Watertight>>(exact.bvh2.view(), ray, counts);
        hits += truth.record != no_record ? 1 : 0;
        for (const BvhHit& answer :
             {walked<Bvh2Walk<false, true, TriangleTest::Fast>>(fast.bvh2.view(), ray, counts),
              walked<WideBvhWalk<false, true, TriangleTest::Fast>>(fast.wide.view(), ray, counts)})
            lost += std::abs(answer.t - truth.t) <= 1e-5f * (1 + truth.t) ? 0 : 1;
    }
    EXPECT_GT(hits, 10'000);
    EXPECT_LE(lost, 5) << "of " << 2 * rays.size();
}

/// Figures of README.md.
TEST(BvhWalks, OfWideTreesVisitFarFewerNodes) {
    const accel::Scene scene = test::furnished_office({.objects = 60, .turn = 0.3});
    const TriedTrees fast(scene.view(), TriangleTest::Fast);
    Counts binary, wide;
    const auto rays = test::rays_in(fast.binary.forest.top.box, 6, 20'000);
    for (const BvhQuery& ray : rays) {
        walked<Bvh2Walk<false, true, TriangleTest::Fast>>(fast.bvh2.view(), ray, binary);
        walked<WideBvhWalk<false, true, TriangleTest::Fast>>(fast.wide.view(), ray, wide);
    }
    const auto a_ray = [&](std::uint64_t n) { return static_cast<double>(n) / static_cast<double>(rays.size()); };
    RecordProperty("binary nodes", std::to_string(a_ray(binary.nodes)));
    RecordProperty("binary triangles", std::to_string(a_ray(binary.triangles)));
    RecordProperty("wide nodes", std::to_string(a_ray(wide.nodes)));
    RecordProperty("wide triangles", std::to_string(a_ray(wide.triangles)));
    EXPECT_LT(a_ray(wide.nodes), 0.4 * a_ray(binary.nodes)) << a_ray(wide.nodes) << " " << a_ray(binary.nodes);
    EXPECT_LT(a_ray(wide.triangles), 2 * a_ray(binary.triangles)) << a_ray(wide.triangles);
}

}  // namespace
}  // namespace enfilade::render::cuda
