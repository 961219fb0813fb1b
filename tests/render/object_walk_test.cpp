// Walks through furnished rooms against brute force, and against each other.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/executor.h"
#include "render/object_oracle.h"
#include "render/object_tracer.h"
#include "render/ray_stream.h"
#include "render/trace_rays.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"
#include "tools/random_rays.h"

namespace enfilade::render {
namespace {

std::unique_ptr<ObjectAccel> accel_of(const accel::Scene& scene, ObjectAccelKind kind = ObjectAccelKind::Plain) {
    return build_object_accel(scene.view(), kind, *make_executor());
}

struct Case {
    const char* name;
    test::FurnishedOptions options;
    ObjectAccelKind kind = ObjectAccelKind::Plain;
    Precision precision = Precision::Float;
};

class FurnishedWalk : public ::testing::TestWithParam<Case> {};

INSTANTIATE_TEST_SUITE_P(
    Offices, FurnishedWalk,
    ::testing::Values(Case{"Plain", {}}, Case{"Embree", {.seed = 2}, ObjectAccelKind::Bvh},
                      Case{"Turned", {.seed = 3, .turn = 0.3}}, Case{"Double", {.seed = 4}, {}, Precision::Double},
                      Case{"TinyMeshes", {.seed = 5, .mesh_scale = 1e-3}, ObjectAccelKind::Bvh},
                      Case{"HugeMeshes", {.seed = 6, .mesh_scale = 1e3}, ObjectAccelKind::Bvh},
                      Case{"Many", {.seed = 7, .objects = 250, .turn = 0.1}},
                      Case{"KeepingAngles", {.seed = 8, .stretched = false}},
                      Case{"Octrees", {.seed = 9}, ObjectAccelKind::Octree},
                      Case{"OctreesDouble", {.seed = 10, .turn = 0.2}, ObjectAccelKind::Octree, Precision::Double},
                      Case{"OctreesTiny", {.seed = 11, .mesh_scale = 1e-3}, ObjectAccelKind::Octree},
                      Case{"OctreesHuge", {.seed = 12, .mesh_scale = 1e3}, ObjectAccelKind::Octree},
                      Case{"OctreesMany", {.seed = 13, .objects = 250}, ObjectAccelKind::Octree}),
    [](const auto& tried) { return tried.param.name; });

TEST_P(FurnishedWalk, EndsWhereBruteForceSays) {
    const accel::Scene scene = test::furnished_office(GetParam().options);
    const auto built = accel_of(scene, GetParam().kind);
    const ObjectTracer tracer = built->tracer();
    const ObjectOracle oracle(scene.view(), error_band(scene.view()));
    tools::RandomRays random(scene.view(), 11);
    int objects = 0, unsure = 0, wrong = 0, count = 0;
    for (const tools::RayFamily family : tools::ray_families) {
        std::vector<RayQuery> rays = random.take(400, family);
        for (std::size_t i = 0; i < rays.size(); i += 3) rays[i].max_distance = 0.25 * static_cast<double>(1 + i % 20);
        std::vector<RayHit> hits(rays.size());
        trace_rays(scene.view(), rays, hits, GetParam().precision, nullptr, &tracer);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ++count;
            objects += hits[i].status == WalkStatus::Object;
            EXPECT_EQ(hits[i].status == WalkStatus::Object, hits[i].object != none<accel::ObjectId>);
            unsure += oracle.ends_of(rays[i]).size() > 1;
            if (oracle.allows(rays[i], hits[i])) continue;
            ++wrong;
            const PossibleEnd sure = oracle.ends_of(rays[i]).back();
            ADD_FAILURE() << name_of(family) << " " << i << ": status " << static_cast<int>(hits[i].status)
                          << " object " << static_cast<int>(hits[i].object) << " at " << hits[i].distance
                          << ", expected " << static_cast<int>(sure.object) << " at " << sure.distance;
            if (wrong > 5) return;
        }
    }
    EXPECT_GT(objects, count / 25);
    EXPECT_LT(unsure, count / 5);
}

TEST_P(FurnishedWalk, SeesWhatRaysReach) {
    const accel::Scene scene = test::furnished_office(GetParam().options);
    const auto built = accel_of(scene, GetParam().kind);
    const ObjectTracer tracer = built->tracer();
    tools::RandomRays random(scene.view(), 5);
    const std::vector<RayQuery> rays = random.take(4000);
    std::vector<float> columns[6];
    std::vector<accel::CellId> from_cell, to_cell;
    std::vector<double> lengths;
    std::vector<RayQuery> ways;
    for (std::size_t i = 0; i + 1 < rays.size(); i += 2) {
        const Vec3d p = rays[i].origin, q = rays[i + 1].origin;
        for (int k = 0; k < 6; ++k) {
            const Vec3d v = k < 3 ? p : q;
            columns[k].push_back(static_cast<float>(k % 3 == 0 ? v.x : k % 3 == 1 ? v.y : v.z));
        }
        from_cell.push_back(rays[i].cell);
        to_cell.push_back(rays[i + 1].cell);
        ways.push_back({p, q - p, rays[i].cell});
    }
    std::vector<std::uint8_t> there(ways.size()), back(ways.size()), unknown(ways.size());
    SegmentColumns segments = {columns[0], columns[1], columns[2], columns[3],
                               columns[4], columns[5], from_cell,  to_cell};
    const StreamOptions options = {.tracer = Tracer::Scalar, .objects = &tracer};
    visible(scene.view(), segments, there, options);
    segments.to_cell = {};
    visible(scene.view(), segments, unknown, options);
    segments = {columns[3], columns[4], columns[5], columns[0], columns[1], columns[2], to_cell, from_cell};
    visible(scene.view(), segments, back, options);
    std::vector<RayHit> hits(ways.size());
    trace_rays(scene.view(), ways, hits, Precision::Float, nullptr, &tracer);
    int seen = 0, blocked = 0, differing = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        const bool is_seen = hits[i].distance > length(ways[i].direction);
        seen += is_seen;
        blocked += !is_seen && hits[i].status == WalkStatus::Object;
        differing += is_seen != (there[i] != 0) || is_seen != (back[i] != 0) || is_seen != (unknown[i] != 0);
    }
    EXPECT_GT(seen, 20);
    EXPECT_GT(blocked, 100);
    EXPECT_LE(differing, 4);  // along edges
}

/// Two rooms side by side with a wall 0.3 m thick between them, and one box mesh.
class TwoRooms : public ::testing::Test {
protected:
    TwoRooms() {
        using test::grid;
        input_ = test::scene_from_plots(
            {{grid(0), grid(0), grid(4), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(2.5)}}},
             {grid(4), grid(0), grid(4.25), grid(4), {}},
             {grid(4.25), grid(0), grid(8), grid(4), {{.z_floor = grid(0), .z_ceiling = grid(2.5)}}}});
        input_.meshes.push_back(std::make_shared<accel::InputMesh>(test::box_mesh({-0.5f, -0.5f, 0}, {0.5f, 0.5f, 1})));
        input_.cell_objects.resize(input_.cells.size());
    }
    void put(double x, double y, double z, const std::vector<std::uint32_t>& cells) {
        accel::InputObject object;
        object.id = std::to_string(input_.objects.size());
        object.scene_from_object = {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z};
        for (const std::uint32_t cell : cells)
            input_.cell_objects[cell].push_back(static_cast<std::uint32_t>(input_.objects.size()));
        input_.objects.push_back(object);
    }
    RayHit trace(Vec3d origin, Vec3d direction, std::uint32_t cell, double max_distance = 1e300) {
        const accel::Scene scene = accel::assemble(input_);
        const auto built = accel_of(scene);
        const ObjectTracer tracer = built->tracer();
        return trace_ray(scene.view(), {origin, direction, static_cast<accel::CellId>(cell), max_distance},
                         Precision::Float, &tracer);
    }
    accel::SceneInput input_;
};

TEST_F(TwoRooms, CutOffWhatPokesThroughTheWall) {
    put(4, 2, 0, {0});  // half of it is in the wall and in the other room
    const RayHit here = trace({1, 2, 0.5}, {1, 0, 0}, 0);
    EXPECT_EQ(here.status, WalkStatus::Object);
    EXPECT_NEAR(here.distance, 2.5, 1e-6);
    const RayHit beside = trace({1, 2.75, 0.5}, {1, 0, 0}, 0);
    EXPECT_EQ(beside.status, WalkStatus::Hit);
    const RayHit there = trace({6, 2, 0.5}, {-1, 0, 0}, 1);
    EXPECT_EQ(there.status, WalkStatus::Hit);
    EXPECT_NEAR(there.distance, 1.75, 1e-5);
}

TEST_F(TwoRooms, ShowWhatTouchesAWallBeforeTheWall) {
    put(3.5, 2, 0, {0});                                     // its side lies in the wall's plane
    const RayHit hit = trace({3.75, 2, 0.5}, {1, 0, 0}, 0);  // from inside of it
    EXPECT_EQ(hit.status, WalkStatus::Object);
    EXPECT_NEAR(hit.distance, 0.25, 1e-6);
}

TEST_F(TwoRooms, AnswerTheFirstOfEqualObjects) {
    put(2, 2, 0, {0});
    put(2, 2, 0, {0});
    const RayHit hit = trace({0.5, 2, 0.5}, {1, 0, 0}, 0);
    EXPECT_EQ(hit.status, WalkStatus::Object);
    EXPECT_EQ(hit.object, accel::ObjectId{0});
}

TEST_F(TwoRooms, StopAtTheLimitBeforeAnObject) {
    put(2, 2, 0, {0});
    const RayHit before = trace({0.5, 2, 0.5}, {2, 0, 0}, 0, 0.9375);
    EXPECT_EQ(before.status, WalkStatus::Reached);
    EXPECT_EQ(before.distance, 0.9375);
    const RayHit at = trace({0.5, 2, 0.5}, {2, 0, 0}, 0, 1.0625);
    EXPECT_EQ(at.status, WalkStatus::Object);
    EXPECT_EQ(at.distance, 1);
}

TEST_F(TwoRooms, StreamsNameTheObject) {
    put(2, 2, 0, {0});
    const accel::Scene scene = accel::assemble(input_);
    const auto built = accel_of(scene);
    const ObjectTracer tracer = built->tracer();
    const std::vector<float> x = {0.5f, 0.5f}, y = {2, 3}, z = {0.5f, 0.5f}, dx = {1, 1}, zero = {0, 0};
    const std::vector<accel::CellId> cell(2, accel::CellId{0});
    std::vector<float> distance(2);
    std::vector<accel::SourceFaceId> face(2);
    std::vector<accel::ObjectId> object(2);
    std::vector<std::uint32_t> triangle(2);
    std::vector<WalkStatus> status(2);
    const HitColumns hits = {
        .distance = distance, .source_face = face, .status = status, .object = object, .triangle = triangle};
    nearest(scene.view(), {x, y, z, dx, zero, zero, cell, {}}, hits, {.tracer = Tracer::Scalar, .objects = &tracer});
    EXPECT_EQ(status[0], WalkStatus::Object);
    EXPECT_EQ(distance[0], 1);
    EXPECT_EQ(face[0], none<accel::SourceFaceId>);
    EXPECT_EQ(object[0], accel::ObjectId{0});
    EXPECT_NE(triangle[0], no_triangle);
    EXPECT_EQ(status[1], WalkStatus::Hit);
    EXPECT_EQ(object[1], none<accel::ObjectId>);
    EXPECT_EQ(triangle[1], no_triangle);
    nearest(scene.view(), {x, y, z, dx, zero, zero, cell, {}}, hits, {.tracer = Tracer::Scalar});
    EXPECT_EQ(status[0], WalkStatus::Hit);
    EXPECT_EQ(object[0], none<accel::ObjectId>);
    EXPECT_EQ(triangle[0], no_triangle);
}

}  // namespace
}  // namespace enfilade::render
