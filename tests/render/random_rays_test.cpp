#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/oracle.h"
#include "render/trace_rays.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

constexpr std::uint64_t seed = 20130913;

std::vector<RayQuery> random_rays(const accel::SceneView& scene, std::size_t count, bool flat) {
    std::mt19937_64 random(seed);
    std::vector<RayQuery> rays;
    while (rays.size() < count) {
        const auto cell = static_cast<std::uint32_t>(random() % scene.cells.size());
        Vec3d d = test::rounded_to_float(test::random_direction(random));
        if (flat) d.z *= 0x1p-8;
        rays.push_back({test::random_point(scene, cell, random), d, static_cast<accel::CellId>(cell)});
    }
    return rays;
}

accel::Scene office(double turn) {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 5, .storeys = 3, .turn = turn}));
}

TEST(RandomRays, NeverLeak) {
    for (const double turn : {0.0, 0.1, 0.7}) {
        const accel::Scene scene = office(turn);
        for (const bool flat : {false, true}) {
            const std::vector<RayQuery> rays = random_rays(scene.view(), 500000, flat);
            std::vector<RayHit> hits(rays.size());
            for (const Precision precision : {Precision::Float, Precision::Double}) {
                RayStats stats;
                trace_rays(scene.view(), rays, hits, precision, &stats);
                EXPECT_EQ(stats.leaks, 0u);
                for (const RayHit& hit : hits) ASSERT_EQ(hit.status, WalkStatus::Hit);
                EXPECT_LT(stats.several + stats.none, rays.size() / 1000);
            }
        }
    }
}

// A closed room, a grid of rays aligned with its corners (tinybvh #168, three-mesh-bvh #169).
TEST(GridRays, StayInAClosedRoom) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2, .doors = false}));
    const accel::SceneView& view = scene.view();
    std::uint32_t room = 0;
    while (view.cells[room].label != accel::Label::Room) ++room;
    const Vec3d p = test::centre_of(view, room);
    std::vector<RayQuery> rays;
    for (int x = -64; x <= 64; ++x)
        for (int y = -64; y <= 64; ++y)
            for (int z = -8; z <= 8; ++z)
                if (x != 0 || y != 0 || z != 0)
                    rays.push_back({p, {x * 2.0 / 64, y * 2.5 / 64, z * 1.35 / 8}, static_cast<accel::CellId>(room)});
    std::vector<RayHit> hits(rays.size());
    RayStats stats;
    trace_rays(view, rays, hits, Precision::Float, &stats);
    EXPECT_EQ(stats.cells, rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(hits[i].status, WalkStatus::Hit);
        ASSERT_LT(hits[i].distance, 3.6);
    }
}

class Agreeing : public testing::TestWithParam<double> {};

TEST_P(Agreeing, WithTheOracleOutsideTheBand) {
    const accel::Scene scene =
        accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = GetParam()}));
    const Oracle oracle(scene.view());
    const std::vector<RayQuery> rays = random_rays(scene.view(), 40000, false);
    std::vector<RayHit> hits(rays.size());
    const double band = error_band(scene.view());
    EXPECT_LT(band, 0.001);
    for (const Precision precision : {Precision::Float, Precision::Double}) {
        trace_rays(scene.view(), rays, hits, precision);
        const Agreement agreement = compare(oracle, rays, hits, band);
        EXPECT_EQ(agreement.differing_outside_band, 0u);
        EXPECT_LT(agreement.differing_inside_band, 40u) << "of 40000";
        EXPECT_LT(agreement.largest_distance_error, precision == Precision::Float ? 0.02 : 0.01);
        RecordProperty("inside_band", static_cast<int>(agreement.differing_inside_band));
    }
}

// Shadow and reflected rays start on faces, in float, with no offset: the walk cannot meet the face it starts on.
TEST_P(Agreeing, WithTheOracleFromPointsOnFaces) {
    const accel::Scene scene =
        accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = GetParam()}));
    const accel::SceneView& view = scene.view();
    const Oracle oracle(view);
    const std::vector<RayQuery> first = random_rays(view, 20000, false);
    std::vector<RayHit> hits(first.size());
    trace_rays(view, first, hits);
    std::mt19937_64 random(seed);
    std::vector<RayQuery> second;
    std::vector<accel::SourceFaceId> started_on;
    for (std::size_t i = 0; i < first.size(); ++i) {
        Vec3d p = test::rounded_to_float(first[i].origin + hits[i].distance * normalized(first[i].direction));
        const accel::Cell& cell = view.cells[index(hits[i].cell)];
        if (hits[i].exit == Exit::Floor) p.z = cell.z_floor;
        if (hits[i].exit == Exit::Ceiling) p.z = cell.z_ceiling;
        const Vec3d normal = oracle.normal(hits[i].source_face);
        Vec3d d = test::random_direction(random);
        if (dot(d, normal) < 0) d = -d;
        d = test::rounded_to_float(d + 0.05 * normal);
        second.push_back({p, d, hits[i].cell});
        started_on.push_back(hits[i].source_face);
    }
    hits.resize(second.size());
    trace_rays(view, second, hits);
    for (std::size_t i = 0; i < second.size(); ++i) ASSERT_NE(hits[i].source_face, started_on[i]) << "ray " << i;
    const Agreement agreement = compare(oracle, second, hits, error_band(view));
    EXPECT_EQ(agreement.differing_outside_band, 0u);
    EXPECT_LT(agreement.differing_inside_band, 40u) << "of 20000";
}

INSTANTIATE_TEST_SUITE_P(Turned, Agreeing, testing::Values(0.0, 0.25, 0.8));

// A wrong answer must be found: the comparison itself is tested.
TEST(Compare, CountsAWrongFaceAsOutsideTheBand) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2}));
    const Oracle oracle(scene.view());
    std::vector<RayQuery> rays = random_rays(scene.view(), 200, false);
    std::vector<RayHit> hits(rays.size());
    trace_rays(scene.view(), rays, hits);
    for (RayHit& hit : hits)
        hit.source_face =
            static_cast<accel::SourceFaceId>((index(hit.source_face) + 1) % scene.view().source_face_count());
    EXPECT_GT(compare(oracle, rays, hits, error_band(scene.view())).differing_outside_band, 190u);
}

TEST(UnnormalisedRays, MeetTheSameFacesAtTheSameDistance) {
    const accel::Scene scene = office(0.1);
    const std::vector<RayQuery> rays = random_rays(scene.view(), 20000, false);
    std::vector<RayHit> expected(rays.size()), hits(rays.size());
    trace_rays(scene.view(), rays, expected);
    for (const double scale : {1e-18, 1e-30, 3.0, 1e18, 1e30}) {
        std::vector<RayQuery> scaled = rays;
        for (RayQuery& ray : scaled) ray.direction = scale * ray.direction;
        trace_rays(scene.view(), scaled, hits);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(hits[i].status, WalkStatus::Hit);
            different += hits[i].source_face != expected[i].source_face ||
                         std::abs(hits[i].distance - expected[i].distance) > 1e-3 * expected[i].distance;
        }
        EXPECT_LT(different, 20u) << scale;  // rounding of the direction, not its size
    }
}

TEST(DenormalRays, MeetSomethingAndStop) {
    const accel::Scene scene = office(0.1);
    std::vector<RayQuery> rays = random_rays(scene.view(), 20000, false);
    std::vector<RayHit> hits(rays.size());
    for (const double scale : {1e-38, 1e-42, 1e-44}) {
        for (RayQuery& ray : rays) {
            ray.direction = scale * normalized(ray.direction);
            const Vec3f d = vec_cast<float>(ray.direction);
            if (d.x == 0 && d.y == 0 && d.z == 0) ray.direction.z = scale;
        }
        RayStats stats;
        trace_rays(scene.view(), rays, hits, Precision::Float, &stats);
        EXPECT_EQ(stats.leaks, 0u);
        for (const RayHit& hit : hits) ASSERT_EQ(hit.status, WalkStatus::Hit);
    }
    // One component denormal, the others not: nearly axis-parallel.
    for (RayQuery& ray : rays) ray.direction = {1, 1e-42, -1e-45};
    trace_rays(scene.view(), rays, hits);
    for (const RayHit& hit : hits) ASSERT_EQ(hit.status, WalkStatus::Hit);
}

TEST(Corridor, OfTenThousandDoorsIsWalkedToItsEnd) {
    const accel::Scene scene = accel::assemble(test::synthetic_corridor(10000));
    const accel::SceneView& view = scene.view();
    const double west = view.locator_nodes[0].low[0], east = view.locator_nodes[0].high[0];
    for (const double slope : {0.0, 1e-5, -1e-4}) {
        const RayQuery ray = {{west + 0.125, 0, 1}, {1, slope, slope}, static_cast<accel::CellId>(0)};
        RayStats stats;
        RayHit hit;
        trace_rays(view, {&ray, 1}, {&hit, 1}, Precision::Float, &stats);
        EXPECT_EQ(hit.status, WalkStatus::Hit);
        if (slope == 0) {
            EXPECT_EQ(stats.cells, view.cells.size());
            EXPECT_NEAR(hit.distance, east - west - 0.125, 1e-3);
        }
        RayHit precise;
        trace_rays(view, {&ray, 1}, {&precise, 1}, Precision::Double);
        EXPECT_EQ(hit.source_face, precise.source_face);
        EXPECT_NEAR(hit.distance, precise.distance, 1e-4 * precise.distance);
    }
}

}  // namespace
}  // namespace enfilade::render
