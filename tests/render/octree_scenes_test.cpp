// Octrees inside of objects that are placed in every way: scaled, stretched, mirrored, hardly turned, in and through
// each other, about the eye; against brute force over all triangles in the scene's space.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "accel/assemble.h"
#include "accel/octree/linked_octree.h"
#include "render/executor.h"
#include "render/object_oracle.h"
#include "render/object_tracer.h"
#include "render/octree_trees.h"
#include "render/trace_rays.h"
#include "tests/support/object_rays.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"
#include "tests/support/tried_mesh.h"

namespace enfilade::test {
namespace {

using render::RayHit;
using render::RayQuery;
using render::Vec3d;
using Rows = std::array<double, 12>;

constexpr Vec3d middle = {0.25, -0.125, 1.75};

/// Turned about z and a little about x, then scaled along the object's own axes, then in the middle of the room.
Rows placed(std::array<double, 3> scale, double turn) {
    const double c = std::cos(turn), s = std::sin(turn);
    return {c * scale[0], -s * scale[1], 0, middle.x, s * scale[0], c * scale[1], 0, middle.y, 0, 0,
            scale[2],     middle.z};
}

/// One closed room of 8 x 8 x 4 m about (0, 0, 2) with meshes at such places.
accel::Scene room_with(const std::vector<std::pair<accel::InputMesh, Rows>>& objects) {
    accel::SceneInput input =
        scene_from_plots({{grid(-4), grid(-4), grid(4), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(4)}}}});
    input.cell_objects.resize(input.cells.size());
    for (std::uint32_t i = 0; i < objects.size(); ++i) {
        input.meshes.push_back(std::make_shared<accel::InputMesh>(objects[i].first));
        accel::InputObject object;
        object.id = "object " + std::to_string(1000 + i);
        object.mesh = i;
        object.scene_from_object = objects[i].second;
        input.objects.push_back(object);
        input.cell_objects[0].push_back(i);
    }
    return accel::assemble(input);
}

/// Rays from everywhere in the room, from inside the objects, from their middle along the axes.
std::vector<RayQuery> rays_in(int count) {
    std::vector<RayQuery> rays;
    RandomNumbers numbers(21);
    for (int i = 0; i < count; ++i) {
        const Vec3d from = i % 4 == 0   ? middle
                           : i % 4 == 1 ? middle + numbers.point(0.4)
                                        : Vec3d{3.9 * numbers.next(), 3.9 * numbers.next(), 2 + 1.9 * numbers.next()};
        Vec3d way = i % 4 < 2 ? numbers.point(1) : middle + numbers.point(1.2) - from;
        if (i % 7 == 0) way = {i % 2 == 0 ? 1.0 : -1.0, 0, -0.0};
        if (i % 7 == 1) way = {0, -0.0, i % 2 == 0 ? 1.0 : -1.0};
        rays.push_back({from, way, accel::CellId{0}});
    }
    return rays;
}

/// Answers of octrees, all of them allowed by brute force; returns how many end at objects.
int judge(const std::string& name, const accel::Scene& scene, std::vector<RayHit>* answers = nullptr) {
    const std::vector<RayQuery> rays = rays_in(600);
    const render::ObjectOracle oracle(scene.view(), render::error_band(scene.view()));
    int objects = 0;
    for (const std::uint32_t depth : {accel::OctreeOptions::automatic, 16u}) {
        const accel::OctreeOptions options = {.depth = depth,
                                              .leaf_size = depth == 16 ? 4 : accel::OctreeOptions::automatic};
        const auto built =
            build_object_accel(scene.view(), render::ObjectAccelKind::Octree, *render::make_executor(), options);
        const render::ObjectTracer tracer = built->tracer();
        for (const render::Precision precision : {render::Precision::Float, render::Precision::Double}) {
            std::vector<RayHit> hits(rays.size());
            trace_rays(scene.view(), rays, hits, precision, nullptr, &tracer);
            for (std::size_t i = 0; i < rays.size(); ++i) {
                objects += hits[i].status == render::WalkStatus::Object;
                EXPECT_TRUE(oracle.allows(rays[i], hits[i])) << name << ", ray " << i << ", at " << hits[i].distance;
            }
            if (answers != nullptr) *answers = hits;
        }
    }
    return objects;
}

TEST(OctreesInScenes, OfObjectsOfEveryScaleAreHitAsByBruteForce) {
    for (const double scale : {1e-3, 1e-2, 1.0, 1e2, 1e3}) {
        accel::InputMesh mesh = ball_mesh(12, 1);
        for (auto& v : mesh.vertices)
            for (float& c : v) c = static_cast<float>(c / scale);
        EXPECT_GT(judge("scale " + std::to_string(scale), room_with({{mesh, placed({scale, scale, scale}, 0.7)}})),
                  800);
    }
}

TEST(OctreesInScenes, OfStretchedAndMirroredObjectsAreHitAsByBruteForce) {
    const accel::InputMesh mesh = random_soup(200, 0.4f, 5);
    constexpr std::array<double, 3> scales[] = {{1, 0.5, 1.5},  {-1, 1, 1},   {1, -1, -0.25},
                                                {-1.5, -1, -1}, {2, 1e-2, 1}, {1.5, 1, 1e-3}};
    for (const auto& scale : scales)
        EXPECT_GT(judge("stretched by " + std::to_string(scale[0]) + ", " + std::to_string(scale[1]) + ", " +
                            std::to_string(scale[2]),
                        room_with({{mesh, placed(scale, 0.3)}})),
                  100);
}

TEST(OctreesInScenes, ATurnOfTenMillionthsOfARadianMovesNoHit) {
    // Rays along axes are no longer along those of the object: they run nearly level with its cells.
    std::vector<RayHit> straight, turned;
    const accel::InputMesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
    judge("straight", room_with({{box, placed({1, 1, 1}, 0)}}), &straight);
    for (const double turn : {1e-7, -1e-7}) {
        judge("turned", room_with({{box, placed({1, 1, 1}, turn)}}), &turned);
        for (std::size_t i = 0; i < straight.size(); ++i) {
            if (straight[i].status != turned[i].status) continue;  // past an edge
            EXPECT_NEAR(straight[i].distance, turned[i].distance, 1e-4) << i;
        }
    }
}

TEST(OctreesInScenes, OfObjectsThatTouchAndNestAreHitAsByBruteForce) {
    const accel::InputMesh box = box_mesh({-1, -1, -1}, {1, 1, 1});
    const Rows whole = placed({1, 1, 1}, 0), half = placed({0.5, 0.5, 0.5}, 0.4);
    Rows beside = placed({0.5, 0.5, 0.5}, 0);
    beside[3] += 1.5;  // face to face with the whole one
    EXPECT_GT(judge("nested", room_with({{box, whole}, {box, half}, {ball_mesh(10, 0.9f), whole}})), 1900);
    EXPECT_GT(judge("touching", room_with({{box, whole}, {box, beside}})), 1900);
    EXPECT_GT(judge("twice the same", room_with({{box, whole}, {box, whole}})), 1900);
}

/// What devices walk, on this machine: without function pointers, without registers.
TEST(OctreesInScenes, AreTheSameWithoutFunctionPointers) {
    const accel::Scene scene = room_with({{ball_mesh(12, 1), placed({1, 0.7, 1}, 0.2)}});
    const accel::SceneView& view = scene.view();
    const TriedMesh mesh(ball_mesh(12, 1));
    const TriedOctree octree(mesh, {});
    const accel::OctreeView tree = octree.view();
    const render::OctreeTrees trees = {&tree};
    const auto built = build_object_accel(view, render::ObjectAccelKind::Octree, *render::make_executor());
    const render::ObjectTracer tracer = built->tracer();
    int hits = 0;
    for (const RayQuery& query : rays_in(2000)) {
        render::ObjectRay alone = object_ray(query.origin - middle, query.direction, 0, 100);
        render::ObjectRay asked = alone;
        const bool is_blocked = ask_blocked(trees, accel::MeshId{0}, alone);
        ask_nearest(trees, accel::MeshId{0}, alone);
        ask_nearest(tracer, accel::MeshId{0}, asked);
        EXPECT_EQ(alone.triangle, asked.triangle);
        EXPECT_EQ(alone.far, asked.far);
        EXPECT_EQ(is_blocked, alone.triangle != render::no_triangle);
        hits += is_blocked;
    }
    EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace enfilade::test
