// The paper's octree where objects ask: built as the options say, found right by all ways to ask.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "render/executor.h"
#include "render/object_tracer.h"
#include "render/octree_counter.h"
#include "render/rope_walk.h"
#include "tests/support/object_rays.h"
#include "tests/support/octree_rays.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {
namespace {

using accel::MeshId;
using render::ObjectAccelKind;
using render::ObjectRay;
using render::ObjectRays;

class RopeObjectsTest : public ::testing::TestWithParam<int> {
protected:
    static accel::OctreeOptions options() {
        accel::OctreeOptions options;
        options.layout = accel::OctreeLayout::Ropes;
        options.is_balanced = (GetParam() & 1) != 0;
        options.has_stored_boxes = (GetParam() & 2) != 0;
        options.walks_in_double = (GetParam() & 4) != 0;
        return options;
    }
};

INSTANTIATE_TEST_SUITE_P(All, RopeObjectsTest, ::testing::Range(0, 8), [](const auto& variant) {
    return std::string((variant.param & 1) != 0 ? "Balanced" : "Free") +
           ((variant.param & 2) != 0 ? "Stored" : "Implicit") + ((variant.param & 4) != 0 ? "Double" : "Float");
});

accel::Scene scene_of_meshes() {
    return room_of_meshes({ball_mesh(20, 1), box_mesh({-1, -1, -1}, {1, 1, 1}), random_soup(500, 0.3f, 1),
                           random_soup(3, 1, 2), random_soup(2000, 0.02f, 4)});
}

TEST_P(RopeObjectsTest, FindsWhatBruteForceFinds) {
    const accel::Scene scene = scene_of_meshes();
    for (const std::uint32_t depth : {accel::OctreeOptions::automatic, 2u, 9u}) {
        accel::OctreeOptions asked_for = options();
        asked_for.depth = depth;
        if (depth != accel::OctreeOptions::automatic) asked_for.leaf_size = 4;
        const auto built =
            build_object_accel(scene.view(), ObjectAccelKind::Octree, *render::make_executor(), asked_for);
        EXPECT_EQ(built->name(), "ropes");
        const render::ObjectTracer tracer = built->tracer();
        RandomNumbers numbers(7);
        int hits = 0, misses = 0, at_edges = 0;
        for (std::uint32_t m = 0; m < scene.view().meshes.size(); ++m) {
            for (int i = 0; i < 300; ++i) {
                const render::Vec3d from = numbers.point(2), to = numbers.point(1);
                ObjectRay ray =
                    object_ray(i % 4 == 0 ? to : from, i % 8 == 0 ? render::Vec3d{0, -0.0, 1} : to - from, 0, 1e30f);
                const ObjectRay asked = ray;
                tracer.nearest(tracer.state, MeshId{m}, ray);
                EXPECT_EQ(tracer.blocked(tracer.state, MeshId{m}, asked), ray.triangle != render::no_triangle);
                const Verdict verdict = judge(scene.view(), MeshId{m}, asked, ray);
                EXPECT_NE(verdict, Verdict::Wrong);
                hits += verdict == Verdict::Hit;
                misses += verdict == Verdict::Miss;
                at_edges += verdict == Verdict::AtEdge;
            }
        }
        EXPECT_GT(hits, 300);
        EXPECT_GT(misses, 100);
        EXPECT_LT(at_edges, 20);
    }
}

TEST_P(RopeObjectsTest, AnswersSixteenAsOne) {
    const accel::Scene scene = scene_of_meshes();
    const auto built = build_object_accel(scene.view(), ObjectAccelKind::Octree, *render::make_executor(), options());
    const render::ObjectTracer tracer = built->tracer();
    RandomNumbers numbers(3);
    int hits = 0;
    for (int block = 0; block < 60; ++block) {
        const auto mesh = static_cast<MeshId>(block % 5);
        ObjectRays rays = {};
        alignas(64) std::array<std::int32_t, 16> valid{};
        std::array<ObjectRay, 16> alone;
        for (int i = 0; i < 16; ++i) {
            const render::Vec3d from = numbers.point(2), to = numbers.point(1);
            ObjectRay& one = alone[static_cast<std::size_t>(i)] = object_ray(from, to - from, 0, 1e30f);
            valid[static_cast<std::size_t>(i)] = i % 5 == 3 ? 0 : -1;
            rays.origin_x[i] = one.origin_x;
            rays.origin_y[i] = one.origin_y;
            rays.origin_z[i] = one.origin_z;
            rays.direction_x[i] = one.direction_x;
            rays.direction_y[i] = one.direction_y;
            rays.direction_z[i] = one.direction_z;
            rays.far[i] = one.far;
            rays.triangle[i] = render::no_triangle;
        }
        (block % 2 == 0 ? tracer.nearest16 : tracer.nearest16_apart)(tracer.state, mesh, valid.data(), rays);
        for (int i = 0; i < 16; ++i) {
            ObjectRay& one = alone[static_cast<std::size_t>(i)];
            if (valid[static_cast<std::size_t>(i)] != 0) tracer.nearest(tracer.state, mesh, one);
            ASSERT_EQ(rays.triangle[i], one.triangle);
            ASSERT_EQ(rays.far[i], one.far);
            hits += one.triangle != render::no_triangle;
        }
    }
    EXPECT_GT(hits, 100);
}

TEST_P(RopeObjectsTest, TellsWhatRaysDo) {
    const accel::Scene scene = scene_of_meshes();
    const auto built = build_object_accel(scene.view(), ObjectAccelKind::Octree, *render::make_executor(), options());
    ASSERT_NE(built->octrees(), nullptr);
    const accel::OctreeFigures figures = built->octrees()->figures();
    EXPECT_EQ(figures.trees, 5u);
    EXPECT_GT(figures.references, 1600u + 12 + 500 + 3 + 2000 - 1);
    EXPECT_GT(built->bytes(), 40 * figures.references + 16 * figures.leaves);
    render::OctreeWork work;
    RandomNumbers numbers(2);
    for (int i = 0; i < 100; ++i) {
        const render::Vec3d from = numbers.point(2);
        ObjectRay ray = object_ray(from, numbers.point(1) - from, 0, 10), same = ray;
        built->octrees()->nearest_counted(MeshId{0}, ray, work);
        built->tracer().nearest(built->tracer().state, MeshId{0}, same);
        EXPECT_EQ(ray.triangle, same.triangle);
    }
    EXPECT_GT(work.leaves, 150u);
    EXPECT_GT(work.triangles, 500u);
    EXPECT_LT(work.triangles, 100u * 800);
}

/// Fans of thousands about one corner, needles, sheets of one place listed often, a flat mesh, one triangle.
std::vector<accel::InputMesh> awkward_meshes() {
    std::vector<std::array<std::array<float, 3>, 3>> fan, needles, sheets, flat;
    RandomNumbers numbers(17);
    const auto next = [&] { return static_cast<float>(numbers.next()); };
    for (int i = 0; i < 3000; ++i) fan.push_back({{{0, 0, 0}, {next(), next(), next()}, {next(), next(), next()}}});
    for (int i = 0; i < 300; ++i) {
        const float x = next(), y = next();
        needles.push_back({{{x, y, -1}, {x + 1e-5f, y, 1}, {x, y + 1e-6f, 1}}});
    }
    for (int i = 0; i < 200; ++i) sheets.push_back({{{-1, -1, 0.25f}, {1, -1, 0.25f}, {0, 1, 0.25f}}});
    for (int i = 0; i < 300; ++i) {
        const float x = next(), y = next();
        flat.push_back({{{x, y, 0.5f}, {x + 0.1f, y, 0.5f}, {x, y + 0.1f, 0.5f}}});
    }
    return {soup(fan), soup(needles), soup(sheets), soup(flat), soup({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}})};
}

TEST_P(RopeObjectsTest, AnswersAsBruteForceWhereTrianglesLieAwkwardly) {
    int hits = 0;
    std::uint64_t beside = 0;
    for (const accel::InputMesh& input : awkward_meshes()) {
        const TriedMesh mesh(input);
        const accel::Octree tree = accel::build_octree(mesh.part(), options(), accel::SerialExecutor());
        const accel::RopeOctree ropes(tree, mesh.part(), {options().is_balanced, options().has_stored_boxes},
                                      accel::SerialExecutor());
        EXPECT_LT(ropes.bytes().total(), 2000 * mesh.used().size() + 2'000'000);
        OctreeRays draw(mesh, tree.frame, 5);
        for (const NamedOctreeRays& named : octree_ray_families) {
            for (int i = 0; i < 40; ++i) {
                const ObjectRay asked = draw.take(named.family), expected = mesh.nearest(asked);
                ObjectRay found = asked;
                render::NoRopeEvents events;
                if (options().walks_in_double) render::rope_walk<double, false>(ropes.view(), found, events);
                else render::rope_walk<float, false>(ropes.view(), found, events);
                hits += found.triangle != render::no_triangle;
                if (found.triangle == expected.triangle && found.far == expected.far) continue;
                // Rays along a triangle's plane: the test takes a place beside it for the meeting.
                const auto off = [&](const ObjectRay& answer) {
                    return answer.triangle == render::no_triangle ? 0 : mesh.off_triangle(asked, answer.triangle);
                };
                EXPECT_GT(std::max(off(found), off(expected)), 1e-6) << named.name;
                ++beside;
            }
        }
    }
    EXPECT_GT(hits, 500);
    EXPECT_LT(beside, 60u);
}

}  // namespace
}  // namespace enfilade::test
