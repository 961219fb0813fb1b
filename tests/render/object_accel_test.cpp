// Both structures inside of objects against brute force.

#include <array>
#include <limits>
#include <memory>
#include <vector>

#include "render/executor.h"
#include "render/object_tracer.h"
#include "tests/support/object_rays.h"

namespace enfilade::render {
namespace {

using accel::MeshId;
using test::judge;
using test::object_ray;
using test::RandomNumbers;
using test::Verdict;

/// What so many rays to each mesh came to.
struct Tally {
    int hits = 0, misses = 0, at_edges = 0, wrong = 0;
    void add(Verdict verdict) {
        hits += verdict == Verdict::Hit;
        misses += verdict == Verdict::Miss;
        at_edges += verdict == Verdict::AtEdge;
        wrong += verdict == Verdict::Wrong;
    }
};

/// The i-th of many rays: one in four along an axis.
ObjectRay test_ray(RandomNumbers& numbers, int i, double size) {
    const Vec3d from = numbers.point(2 * size), to = numbers.point(size);
    Vec3d d = to - from;
    if (i % 8 == 0) d = {0, -0.0, i % 16 == 0 ? 1.0 : -1.0};
    if (i % 8 == 4) d = {i % 16 == 4 ? 1.0 : -1.0, -0.0, 0};
    return object_ray(i % 4 == 0 ? to : from, d, 0, 1e30f);
}

class ObjectAccelTest : public ::testing::TestWithParam<ObjectAccelKind> {
protected:
    static std::unique_ptr<ObjectAccel> build(const accel::Scene& scene) {
        return build_object_accel(scene.view(), GetParam(), *make_executor());
    }

    /// The three ways to ask, of many rays, against brute force and each other.
    static Tally ask_all(const accel::Scene& scene, int ray_count, double size) {
        const auto built = build(scene);
        const ObjectTracer tracer = built->tracer();
        RandomNumbers numbers(7);
        Tally tally;
        for (std::uint32_t m = 0; m < scene.view().meshes.size(); ++m) {
            for (int i = 0; i < ray_count; ++i) {
                const ObjectRay asked = test_ray(numbers, i, size);
                ObjectRay answered = asked;
                tracer.nearest(tracer.state, static_cast<MeshId>(m), answered);
                tally.add(judge(scene.view(), static_cast<MeshId>(m), asked, answered));
                EXPECT_EQ(tracer.blocked(tracer.state, static_cast<MeshId>(m), asked),
                          answered.triangle != no_triangle);
            }
        }
        return tally;
    }
};

INSTANTIATE_TEST_SUITE_P(All, ObjectAccelTest,
                         ::testing::Values(ObjectAccelKind::Bvh, ObjectAccelKind::Plain, ObjectAccelKind::Octree),
                         [](const auto& kind) {
                             return kind.param == ObjectAccelKind::Bvh     ? "Bvh"
                                    : kind.param == ObjectAccelKind::Plain ? "Plain"
                                                                           : "Octree";
                         });

TEST_P(ObjectAccelTest, FindsWhatBruteForceFinds) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(20, 1), test::box_mesh({-1, -1, -1}, {1, 1, 1}),
                                                     test::random_soup(500, 0.3f, 1), test::random_soup(3, 1, 2)});
    const Tally tally = ask_all(scene, 600, 1);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.hits, 600);
    EXPECT_GT(tally.misses, 100);
    EXPECT_LT(tally.at_edges, 20);
}

TEST_P(ObjectAccelTest, AnswersSixteenAsOne) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(20, 1), test::random_soup(200, 0.3f, 1)});
    const auto built = build(scene);
    const ObjectTracer tracer = built->tracer();
    RandomNumbers numbers(3);
    int hits = 0;
    for (int block = 0; block < 100; ++block) {
        const auto mesh = static_cast<MeshId>(block % 2);
        ObjectRays rays = {};
        alignas(64) std::array<std::int32_t, 16> valid{};
        std::array<ObjectRay, 16> alone;
        for (int i = 0; i < 16; ++i) {
            alone[i] = test_ray(numbers, i, 1);
            valid[i] = i % 5 == 3 ? 0 : -1;
            rays.origin_x[i] = alone[i].origin_x;
            rays.origin_y[i] = alone[i].origin_y;
            rays.origin_z[i] = alone[i].origin_z;
            rays.direction_x[i] = alone[i].direction_x;
            rays.direction_y[i] = alone[i].direction_y;
            rays.direction_z[i] = alone[i].direction_z;
            rays.far[i] = alone[i].far;
            rays.mask[i] = ~0u;
            rays.triangle[i] = rays.geometry[i] = rays.instance[i] = no_triangle;
        }
        (block % 3 == 0 ? tracer.nearest16 : tracer.nearest16_apart)(tracer.state, mesh, valid.data(), rays);
        for (int i = 0; i < 16; ++i) {
            if (valid[i] == 0) {
                EXPECT_EQ(rays.triangle[i], no_triangle);
                continue;
            }
            ObjectRay together = alone[i];
            together.far = rays.far[i];
            together.triangle = rays.triangle[i];
            together.u = rays.u[i];
            together.v = rays.v[i];
            EXPECT_NE(judge(scene.view(), mesh, alone[i], together), Verdict::Wrong);
            hits += rays.triangle[i] != no_triangle;
        }
    }
    EXPECT_GT(hits, 400);
}

/// By columns, as asked whether they are blocked.
ObjectRays columns_of(const std::array<ObjectRay, 16>& rays) {
    ObjectRays columns = {};
    for (int i = 0; i < 16; ++i) {
        const ObjectRay& ray = rays[static_cast<std::size_t>(i)];
        columns.origin_x[i] = ray.origin_x;
        columns.origin_y[i] = ray.origin_y;
        columns.origin_z[i] = ray.origin_z;
        columns.near[i] = ray.near;
        columns.direction_x[i] = ray.direction_x;
        columns.direction_y[i] = ray.direction_y;
        columns.direction_z[i] = ray.direction_z;
        columns.far[i] = ray.far;
        columns.mask[i] = ~0u;
    }
    return columns;
}

TEST_P(ObjectAccelTest, SaysOfSixteenWhichAreBlocked) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(20, 1), test::random_soup(200, 0.3f, 1)});
    const auto built = build(scene);
    const ObjectTracer tracer = built->tracer();
    RandomNumbers numbers(9);
    int blocked = 0, free = 0, wrong = 0;
    for (int block = 0; block < 400; ++block) {
        const auto mesh = static_cast<MeshId>(block % 2);
        std::array<ObjectRay, 16> alone;
        alignas(64) std::array<std::int32_t, 16> valid{};
        const Vec3d to = numbers.point(0.8);
        for (int i = 0; i < 16; ++i) {
            // Neighbours of a lamp, strangers, and some whose part ends early, or never begins.
            const Vec3d from = block % 3 == 0 ? numbers.point(2) : Vec3d{1.5, 1, 0.5} + numbers.point(0.2);
            ObjectRay& ray = alone[static_cast<std::size_t>(i)];
            ray = object_ray(from, to - from, 0.125f, 1);
            if (i % 7 == 2) ray.far = 0.25f;
            if (i % 7 == 5) ray.far = 0.0625f;
            valid[static_cast<std::size_t>(i)] = i % 5 == 3 ? 0 : -1;
        }
        ObjectRays rays = columns_of(alone);
        const std::uint32_t bits = tracer.blocked16(tracer.state, mesh, valid.data(), rays);
        EXPECT_EQ(bits >> 16, 0u);
        for (int i = 0; i < 16; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const bool is_blocked = valid[at] != 0 && tracer.blocked(tracer.state, mesh, alone[at]);
            wrong += is_blocked != ((bits >> i & 1u) != 0);
            (is_blocked ? blocked : free) += 1;
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(blocked, 1000);
    EXPECT_GT(free, 1000);
}

TEST_P(ObjectAccelTest, KeepsToTheInterval) {
    const accel::Scene scene = test::room_of_meshes({test::box_mesh({-1, -1, -1}, {1, 1, 1})});
    const auto built = build(scene);
    const ObjectTracer tracer = built->tracer();
    const auto met_at = [&](float near, float far) {
        ObjectRay ray = object_ray({-3, 0.25, 0.5}, {1, 0, 0}, near, far);
        const bool is_blocked = tracer.blocked(tracer.state, MeshId{0}, ray);
        tracer.nearest(tracer.state, MeshId{0}, ray);
        EXPECT_EQ(is_blocked, ray.triangle != no_triangle);
        return ray.triangle == no_triangle ? -1.0f : ray.far;
    };
    EXPECT_EQ(met_at(0, 10), 2);
    EXPECT_EQ(met_at(2.5f, 10), 4);
    EXPECT_EQ(met_at(0, 1.9f), -1);
    EXPECT_EQ(met_at(2.5f, 3.9f), -1);
    EXPECT_EQ(met_at(4.5f, 10), -1);
    EXPECT_EQ(met_at(3, 1), -1);
}

TEST_P(ObjectAccelTest, TakesNothingForWhatNoCellLists) {
    const accel::Scene scene = test::room_of_meshes({test::ball_mesh(40, 1), test::box_mesh({-1, -1, -1}, {1, 1, 1})});
    accel::SceneView view = scene.view();
    const std::vector<accel::ObjectId> listed = {accel::ObjectId{1}};
    view.cell_objects = {listed.data(), listed.size()};
    const auto built = build_object_accel(view, GetParam(), *make_executor());
    EXPECT_LT(built->bytes(), 4000u);
    EXPECT_GT(build(scene)->bytes(), 100000u);
    const ObjectTracer tracer = built->tracer();
    for (const std::uint32_t mesh : {0u, 1u}) {
        ObjectRay ray = object_ray({0.1, 0.2, 3}, {0, 0, -1}, 0, 10);
        tracer.nearest(tracer.state, MeshId{mesh}, ray);
        EXPECT_EQ(ray.triangle != no_triangle, mesh == 1);
    }
}

TEST_P(ObjectAccelTest, NeverHitsWhatHasNoArea) {
    const accel::Scene scene =
        test::room_of_meshes({test::soup({{{{-1, -1, 0}, {1, 1, 0}, {0, 0, 0}}},
                                          {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
                                          {{{-1, 0, 0}, {1, 0, 0}, {1, 0, 0}}},
                                          {{{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}}},
                                          {{{-1, -1, 0}, {1, 0, 0}, {0, 1, 0}}},
                                          {{{-1, -1, -0.5f}, {3, -1, -0.5f}, {-1, 3, -0.5f}}}}),
                              test::soup({{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}}), accel::InputMesh{}});
    // No file holds corners that are no places; who makes views of their own may.
    accel::SceneView view = scene.view();
    std::vector<accel::Vertex> places(view.mesh_vertices.begin(), view.mesh_vertices.end());
    places[9].x = std::numeric_limits<float>::quiet_NaN();
    places[13].y = std::numeric_limits<float>::infinity();
    places.resize(places.size() + 16);
    view.mesh_vertices.first = places.data();
    const auto built = build_object_accel(view, GetParam(), *make_executor());
    const ObjectTracer tracer = built->tracer();
    RandomNumbers numbers(5);
    for (int i = 0; i < 200; ++i) {
        const double x = i == 0 ? 0 : 0.4 * numbers.next();
        ObjectRay ray = object_ray({x, i % 2 == 0 ? x : 0, 2}, {0, 0, -1}, 0, 10);
        tracer.nearest(tracer.state, MeshId{0}, ray);
        EXPECT_EQ(ray.triangle, 5u);
        EXPECT_FLOAT_EQ(ray.far, 2.5f);
        for (const std::uint32_t mesh : {1u, 2u}) {
            ObjectRay other = object_ray({1, 1, 2}, {0, 0, -1}, 0, 10);
            tracer.nearest(tracer.state, MeshId{mesh}, other);
            EXPECT_EQ(other.triangle, no_triangle);
            EXPECT_FALSE(tracer.blocked(tracer.state, MeshId{mesh}, other));
        }
    }
}

}  // namespace
}  // namespace enfilade::render
