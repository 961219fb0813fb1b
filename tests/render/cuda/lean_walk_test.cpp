// The walk without rare cases ends where the walk does, or says that it cannot tell.
#include "render/lean_walk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "accel/assemble.h"
#include "render/cuda/packed_sections.h"
#include "render/sign_bits.h"
#include "tests/support/degenerate_rays.h"
#include "tests/support/devices.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render::cuda {
namespace {

class LeanWalk : public testing::Test {
protected:
    LeanWalk()
        : scene_(accel::assemble(test::synthetic_office({.rooms_per_row = 5, .rows = 4, .storeys = 2, .turn = 0.3}))) {
        tools::RandomRays random(scene_.view(), 31);
        std::vector<RayQuery> queries;
        for (const tools::RayFamily family : tools::ray_families)
            for (const RayQuery& ray : random.take(3000, family)) queries.push_back(ray);
        for (const test::Degenerate family : test::degenerate_families)
            for (const RayQuery& ray : test::degenerate_rays(scene_.view(), family, 300, 8)) queries.push_back(ray);
        for (const RayQuery& query : queries) {
            Ray<float> ray;
            if (make_ray(vec_cast<float>(query.origin), vec_cast<float>(query.direction), ray))
                rays_.push_back({ray, static_cast<std::uint32_t>(query.cell)});
        }
    }

    struct Start {
        Ray<float> ray;
        std::uint32_t cell;
    };

    /// What pictures read of a walk's end.
    static void expect_same(const WalkEnd<float>& a, const WalkEnd<float>& b) {
        ASSERT_EQ(a.status, b.status);
        ASSERT_EQ(a.cell, b.cell);
        ASSERT_EQ(a.exit, b.exit);
        ASSERT_EQ(a.target.bits, b.target.bits);
        if (a.exit != Exit::Side) return;
        ASSERT_EQ(a.face, b.face);
        ASSERT_EQ(a.section, b.section);
        ASSERT_EQ(a.next_section, b.next_section);
        ASSERT_EQ(a.num, b.num);
        ASSERT_EQ(a.den, b.den);
        ASSERT_EQ(a.facing, b.facing);
    }

    accel::Scene scene_;
    std::vector<Start> rays_;
};

TEST_F(LeanWalk, EndsWhereTheWalkEndsOrIsRare) {
    std::size_t rare = 0;
    NoEvents events;
    for (const Start& start : rays_) {
        Vec3f light = {1, 1, 1}, lean_light = {1, 1, 1};
        const WalkEnd<float> expected = walk(scene_.view(), start.ray, start.cell, NoLimit{}, light, events);
        WalkEnd<float> end = {};
        if (!walk_plainly(scene_.view(), start.ray, start.cell, NoLimit{}, lean_light, end)) {
            ++rare;
            continue;
        }
        expect_same(expected, end);
        ASSERT_EQ(light, lean_light);
    }
    EXPECT_GT(rare, 300u);  // vertical rays at least
    EXPECT_LT(rare, rays_.size() / 4);
}

TEST_F(LeanWalk, OfRoomsIsTheWalkForAllRays) {
    NoEvents events;
    for (const Start& start : rays_)
        for (const float limit : {0.7f, 3e38f}) {
            Vec3f light = {1, 1, 1}, lean_light = {1, 1, 1};
            const Limit<float> stop = {limit};
            expect_same(BareRooms{}.look_along(scene_.view(), start.ray, start.cell, stop, light, events).end,
                        LeanRooms{}.look_along(scene_.view(), start.ray, start.cell, stop, lean_light, events).end);
            ASSERT_EQ(light, lean_light);
        }
}

TEST_F(LeanWalk, ReadsTheSameOfRecords) {
    const accel::SerialExecutor one;
    const std::unique_ptr<Device> host = open_host(one);
    DeviceArrays arrays(*host);
    const PackedArrays packed(scene_.view());
    const accel::SceneView copy = copy_scene(scene_.view(), arrays);
    const PackedScene<false> points = copy_packed<false>(copy, packed, arrays);
    const PackedScene<true> pairs = copy_packed<true>(copy, packed, arrays);
    NoEvents events;
    for (const Start& start : rays_) {
        Vec3f light = {1, 1, 1}, of_points = {1, 1, 1}, of_pairs = {1, 1, 1};
        // Recoveries and the walk in double, too.
        const WalkEnd<float> expected = walk(scene_.view(), start.ray, start.cell, NoLimit{}, light, events);
        expect_same(expected, walk(points, start.ray, start.cell, NoLimit{}, of_points, events));
        expect_same(expected, walk(pairs, start.ray, start.cell, NoLimit{}, of_pairs, events));
        ASSERT_EQ(light, of_points);
        ASSERT_EQ(light, of_pairs);
    }
}

TEST_F(LeanWalk, TellsSidesBySigns) {
    const accel::SceneView& scene = scene_.view();
    for (const Start& start : rays_) {
        const accel::Cell& cell = scene.cells[start.cell];
        const std::uint32_t count = std::min<std::uint32_t>(cell.section_count, 32);
        const float* xs = scene.section_x.data() + cell.first_section;
        const float* ys = scene.section_y.data() + cell.first_section;
        std::uint32_t expected = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const float side = line_side(start.ray, xs[i], ys[i]);
            const bool is_left = side > 0 || (side == 0 && start.ray.zero_mask != 0);
            expected |= static_cast<std::uint32_t>(is_left) << i;
        }
        const std::uint32_t mask = ~0u >> (32 - count);
        ASSERT_EQ(left_bits_by_signs(start.ray, xs, ys, count) & mask, expected);
    }
}

TEST(SignBits, AreInTheOrderInWhichTheyCame) {
    for (std::uint32_t count = 1; count <= 32; ++count) {
        SignBits bits;
        const std::uint32_t expected = 0x9c3a51e7u & ~0u >> (32 - count);
        for (std::uint32_t i = 0; i < count; ++i)
            bits.push((expected >> i & 1u) != 0 ? -1e-40f : i % 2 == 0 ? -0.0f : 2);
        EXPECT_EQ(bits.in_order(count), expected);
    }
}

}  // namespace
}  // namespace enfilade::render::cuda
