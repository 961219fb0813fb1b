// The rays for which the paper's text has no answer (README.md of render, "Ties and noise"): vertical ones, rays in
// planes of walls and floors, through vertical lines, with zeros of either sign. Each leaves by exactly one face, and
// the reversed line crosses the reversed cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using accel::SceneView;
using test::follow;

/// The line of `ray`, run through backwards: the same Plücker coordinates, negated.
template <class T>
Ray<T> reversed(const Ray<T>& ray) {
    return make_ray_unchecked(ray.origin, -ray.direction);
}

/// Walks the whole line through `cell` in both directions and compares the cells.
template <class T>
void expect_reversible(const SceneView& scene, Vec3d origin, Vec3d direction, std::uint32_t cell) {
    Ray<T> ray;
    ASSERT_TRUE(make_ray(vec_cast<T>(origin), vec_cast<T>(direction), ray));
    const auto back = follow(scene, reversed(ray), cell);
    ASSERT_EQ(back.end.status, WalkStatus::Hit);
    const auto forth = follow(scene, ray, back.end.cell);
    ASSERT_EQ(forth.end.status, WalkStatus::Hit);
    const auto back_again = follow(scene, reversed(ray), forth.end.cell);
    ASSERT_EQ(back_again.end.status, WalkStatus::Hit);
    // Where a side is bent by a grid unit, a line along it has two ways past the bend.
    if (forth.path.several + forth.path.none + back.path.several + back.path.none + back_again.path.several > 0) return;
    std::vector<std::uint32_t> expected = forth.path.cells;
    std::ranges::reverse(expected);
    EXPECT_EQ(back_again.path.cells, expected)
        << "origin " << origin.x << " " << origin.y << " " << origin.z << " direction " << direction.x << " "
        << direction.y << " " << direction.z;
    EXPECT_NE(std::ranges::find(expected, cell), expected.end());
}

class DegenerateRays : public testing::TestWithParam<double> {
protected:
    DegenerateRays()
        : scene_(accel::assemble(
              test::synthetic_office({.rooms_per_row = 3, .rows = 4, .storeys = 2, .turn = GetParam()}))) {}

    /// Calls visit(cell, point) for a few points inside every cell, all on the grid.
    template <class Visit>
    void for_each_start(const Visit& visit) const {
        const SceneView& view = scene_.view();
        for (std::uint32_t c = 0; c < view.cells.size(); ++c) {
            Vec3d p = test::centre_of(view, c);
            const auto on_grid = [&](double v) { return std::floor(v / view.unit) * view.unit; };
            p = {on_grid(p.x), on_grid(p.y), on_grid(p.z)};
            if (accel::contains(view, static_cast<accel::CellId>(c), {p.x, p.y, p.z})) visit(c, p);
        }
    }

    void expect_reversible_in_both(Vec3d origin, Vec3d direction, std::uint32_t cell) const {
        expect_reversible<float>(scene_.view(), origin, direction, cell);
        expect_reversible<double>(scene_.view(), origin, direction, cell);
    }

    accel::Scene scene_;
};

TEST_P(DegenerateRays, VerticalOnesEndAtAFloorOrACeiling) {
    const SceneView& view = scene_.view();
    for_each_start([&](std::uint32_t cell, Vec3d p) {
        for (const double dz : {1.0, -1.0}) {
            for (const double zero : {0.0, -0.0}) {
                Ray<float> ray;
                ASSERT_TRUE(
                    make_ray(vec_cast<float>(p), Vec3f{static_cast<float>(zero), 0, static_cast<float>(dz)}, ray));
                const auto walked = follow(view, ray, cell);
                ASSERT_EQ(walked.end.status, WalkStatus::Hit);
                EXPECT_EQ(walked.end.exit, dz > 0 ? Exit::Ceiling : Exit::Floor);
                EXPECT_GT(parameter(view, ray, walked.end), 0);
                for (const std::uint32_t c : walked.path.cells)
                    EXPECT_TRUE(accel::contains(
                        view, static_cast<accel::CellId>(c),
                        {p.x, p.y, 0.5 * (double{view.cells[c].z_floor} + double{view.cells[c].z_ceiling})}));
            }
        }
        expect_reversible_in_both(p, {0, 0, 1}, cell);
    });
}

TEST_P(DegenerateRays, AxisParallelOnesWithZerosOfEitherSign) {
    for_each_start([&](std::uint32_t cell, Vec3d p) {
        for (const double zero : {0.0, -0.0})
            for (const double one : {1.0, -1.0}) {
                expect_reversible_in_both(p, {one, zero, zero}, cell);
                expect_reversible_in_both(p, {zero, one, -zero}, cell);
                expect_reversible_in_both(p, {one, one, zero}, cell);
            }
    });
}

TEST_P(DegenerateRays, ThroughEveryVerticalLineOfTheirCell) {
    const SceneView& view = scene_.view();
    for_each_start([&](std::uint32_t cell, Vec3d p) {
        const accel::Cell& c = view.cells[cell];
        for (std::uint32_t s = c.first_section; s < c.first_section + c.section_count; ++s) {
            const Vec3d line = {view.section_x[s], view.section_y[s], p.z};
            for (const double dz : {0.0, 0.125, -0.125}) expect_reversible_in_both(p, line - p + Vec3d{0, 0, dz}, cell);
        }
    });
}

TEST_P(DegenerateRays, ThroughEveryVertexOfTheirCell) {
    const SceneView& view = scene_.view();
    for_each_start([&](std::uint32_t cell, Vec3d p) {
        const accel::Cell& c = view.cells[cell];
        for (std::uint32_t s = c.first_section; s < c.first_section + c.section_count; ++s)
            for (std::uint32_t f = view.section_tails[s].first_face; f < view.section_tails[s + 1].first_face; ++f) {
                const Vec3d top = {view.section_x[s], view.section_y[s], view.side_faces[f].z_top};
                expect_reversible_in_both(p, top - p, cell);
            }
    });
}

TEST_P(DegenerateRays, AlongEverySideOfTheirCell) {
    const SceneView& view = scene_.view();
    for (std::uint32_t cell = 0; cell < view.cells.size(); ++cell) {
        const accel::Cell& c = view.cells[cell];
        for (std::uint32_t i = 0; i < c.section_count; ++i) {
            const std::uint32_t a = c.first_section + i, b = c.first_section + (i + 1) % c.section_count;
            const double z = 0.5 * (double{c.z_floor} + double{c.z_ceiling});
            const Vec3d p = {view.section_x[a], view.section_y[a], z};
            const Vec3d q = {view.section_x[b], view.section_y[b], z};
            for (const Vec3d direction : {q - p, p - q}) {
                const Vec3d middle = p + 0.5 * (q - p);
                const auto start = accel::locate(view, {middle.x, middle.y, middle.z});
                // Where the virtual shift puts the line into the wall, no cell holds it.
                if (!start || !accel::contains(view, *start, {middle.x, middle.y, middle.z})) continue;
                Ray<float> ray;
                ASSERT_TRUE(make_ray(vec_cast<float>(middle), vec_cast<float>(direction), ray));
                EXPECT_EQ(follow(view, ray, static_cast<std::uint32_t>(*start)).end.status, WalkStatus::Hit);
                expect_reversible<double>(view, middle, direction, static_cast<std::uint32_t>(*start));
            }
        }
    }
}

TEST_P(DegenerateRays, AlongFloorPlanesAndLevelsOfTheStack) {
    const SceneView& view = scene_.view();
    for_each_start([&](std::uint32_t cell, Vec3d p) {
        const accel::Cell& c = view.cells[cell];
        for (const float z : {c.z_floor, view.side_faces[view.section_tails[c.first_section].first_face].z_top}) {
            if (z >= c.z_ceiling) continue;
            for (const Vec3d direction : {Vec3d{1, 0, 0}, {0, -1, 0}, {1, 0.25, 0}, {-0.5, 1, -0.0}})
                expect_reversible_in_both({p.x, p.y, z}, direction, cell);
        }
    });
}

INSTANTIATE_TEST_SUITE_P(Turned, DegenerateRays, testing::Values(0.0, 0.3));

// madmann91/bvh #21, svenstaro/bvh #142: what is no ray is said to be none.
TEST(MakeRay, RefusesNaNInfinityAndNoDirection) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    Ray<float> ray;
    for (const float bad : {nan, -nan, inf, -inf}) {
        EXPECT_FALSE(make_ray<float>({bad, 0, 0}, {1, 0, 0}, ray));
        EXPECT_FALSE(make_ray<float>({0, bad, 0}, {1, 0, 0}, ray));
        EXPECT_FALSE(make_ray<float>({0, 0, bad}, {1, 0, 0}, ray));
        EXPECT_FALSE(make_ray<float>({0, 0, 0}, {bad, 0, 1}, ray));
        EXPECT_FALSE(make_ray<float>({0, 0, 0}, {1, bad, 1}, ray));
        EXPECT_FALSE(make_ray<float>({0, 0, 0}, {1, 1, bad}, ray));
    }
    EXPECT_FALSE(make_ray<float>({0, 0, 0}, {0, -0.0f, 0}, ray));
    EXPECT_TRUE(make_ray<float>({0, 0, 0}, {0, -0.0f, 1e-45f}, ray));
}

TEST(MakeRay, ScalesByPowersOfTwoOnly) {
    Ray<float> unit, scaled;
    for (const int exponent : {-140, -60, -1, 1, 60, 120}) {
        ASSERT_TRUE(make_ray<float>({1, 2, 3}, {0.75f, -0.5f, 0.25f}, unit));
        const float s = std::scalbn(1.0f, exponent);
        ASSERT_TRUE(make_ray<float>({1, 2, 3}, {0.75f * s, -0.5f * s, 0.25f * s}, scaled));
        EXPECT_EQ(unit.direction, scaled.direction) << exponent;
    }
}

}  // namespace
}  // namespace enfilade::render
