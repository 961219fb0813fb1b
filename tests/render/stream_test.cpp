// Columns of rays are answered like single rays; and what is counted of them.
#include <gtest/gtest.h>

#include <limits>

#include "accel/assemble.h"
#include "render/ray_stream.h"
#include "render/trace.h"
#include "render/trace_rays.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

accel::Scene office() {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .storeys = 2, .turn = 0.3}));
}

/// Rays as columns, and their answers.
struct Stream {
    std::vector<float> origin[3], direction[3], limit;
    std::vector<accel::CellId> cell;
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> face;
    std::vector<accel::CellId> last_cell;
    std::vector<WalkStatus> status;

    void add(const RayQuery& ray) {
        const Vec3f o = vec_cast<float>(ray.origin), d = vec_cast<float>(ray.direction);
        const float from[3] = {o.x, o.y, o.z}, along[3] = {d.x, d.y, d.z};
        for (int k = 0; k < 3; ++k) {
            origin[k].push_back(from[k]);
            direction[k].push_back(along[k]);
        }
        limit.push_back(static_cast<float>(ray.max_distance));
        cell.push_back(ray.cell);
    }
    void trace(const accel::SceneView& scene, const StreamOptions& options) {
        distance.assign(cell.size(), 0);
        face.assign(cell.size(), {});
        last_cell.assign(cell.size(), {});
        status.assign(cell.size(), WalkStatus::Leak);
        nearest(scene, {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], cell, limit},
                {distance, face, last_cell, status}, options);
    }
};

std::vector<RayQuery> queries(const accel::SceneView& scene, std::size_t count, bool limited) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<float> metres(0.1f, 12), size(1e-6f, 1e3f);
    std::vector<RayQuery> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % scene.cells.size());
        const Vec3f d = vec_cast<float>(double{size(random)} * test::random_direction(random));
        rays.push_back(
            {test::random_point(scene, cell, random), vec_cast<double>(d), static_cast<accel::CellId>(cell)});
        if (limited) rays.back().max_distance = metres(random);
    }
    return rays;
}

TEST(Nearest, AnswersLikeSingleRays) {
    const accel::Scene scene = office();
    for (const bool limited : {false, true}) {
        const std::vector<RayQuery> rays = queries(scene.view(), 50000, limited);
        std::vector<RayHit> expected(rays.size());
        trace_rays(scene.view(), rays, expected);
        Stream stream;
        for (const RayQuery& ray : rays) stream.add(ray);
        for (const StreamOrder order : {StreamOrder::Coherent, StreamOrder::Any}) {
            stream.trace(scene.view(), {.tracer = Tracer::Scalar, .order = order});
            std::size_t reached = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                ASSERT_EQ(stream.status[i], expected[i].status) << i;
                ASSERT_EQ(stream.last_cell[i], expected[i].cell) << i;
                ASSERT_EQ(stream.distance[i], static_cast<float>(expected[i].distance)) << i;
                const bool is_hit = expected[i].status == WalkStatus::Hit;
                reached += is_hit ? 0 : 1;
                ASSERT_EQ(stream.face[i], is_hit ? expected[i].source_face : none<accel::SourceFaceId>) << i;
            }
            if (limited) EXPECT_GT(reached, 10000u);
            else EXPECT_EQ(reached, 0u);
        }
    }
}

TEST(Nearest, RefusesWhatIsNoRayAndGoesOn) {
    const accel::Scene scene = office();
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const std::vector<RayQuery> good = queries(scene.view(), 32, false);
    Stream stream;
    for (const RayQuery& ray : good) {
        stream.add(ray);
        stream.add(ray);
    }
    for (std::size_t i = 1; i < 64; i += 2) {
        const float bad = i % 4 == 1 ? nan : inf;
        const std::size_t what = i / 2 % 8;
        if (what < 3) stream.origin[what][i] = bad;
        else if (what < 6) stream.direction[what - 3][i] = bad;
        else if (what == 6) stream.limit[i] = nan;
        else stream.direction[0][i] = stream.direction[1][i] = stream.direction[2][i] = 0;
    }
    stream.trace(scene.view(), {.tracer = Tracer::Scalar});
    for (std::size_t i = 0; i < 64; ++i) {
        EXPECT_EQ(stream.status[i], i % 2 == 0 ? WalkStatus::Hit : WalkStatus::Refused) << i;
        if (i % 2 == 0) continue;
        EXPECT_TRUE(std::isnan(stream.distance[i]));
        EXPECT_EQ(stream.face[i], none<accel::SourceFaceId>);
        EXPECT_EQ(stream.last_cell[i], stream.cell[i]);
    }
}

TEST(Stats, CountRaysCellsAndTheLinesOfTheseCells) {
    const accel::Scene scene = office();
    const std::vector<RayQuery> rays = queries(scene.view(), 5000, false);
    std::uint64_t cells = 0, lines = 0, glass = 0;
    for (const RayQuery& query : rays) {
        Ray<float> ray;
        ASSERT_TRUE(make_ray(vec_cast<float>(query.origin), vec_cast<float>(query.direction), ray));
        const auto walked = test::follow(scene.view(), ray, static_cast<std::uint32_t>(query.cell));
        cells += walked.path.cells.size();
        for (const std::uint32_t cell : walked.path.cells) lines += scene.view().cells[cell].section_count;
        glass += static_cast<std::uint64_t>(walked.path.panes);
    }
    Stream stream;
    for (const RayQuery& ray : rays) stream.add(ray);
    RayStats stats;
    stream.trace(scene.view(), {.tracer = Tracer::Scalar, .stats = &stats});
    EXPECT_EQ(stats.rays, rays.size());
    EXPECT_EQ(stats.cells, cells);
    EXPECT_EQ(stats.side_tests, lines);
    EXPECT_EQ(stats.glass, glass);
    EXPECT_GT(glass, 0u);
    EXPECT_EQ(stats.leaks, 0u);
    EXPECT_EQ(stats.tiles + stats.splits + stats.filled, 0u);
    std::vector<RayHit> hits(rays.size());
    RayStats single;
    trace_rays(scene.view(), rays, hits, Precision::Float, &single);
    EXPECT_EQ(single.rays, stats.rays);
    EXPECT_EQ(single.side_tests, stats.side_tests);
}

TEST(Stats, CountNoWalkOfRefusedRaysOrOfPointsInOneCell) {
    const accel::Scene scene = office();
    const Vec3f p = vec_cast<float>(test::centre_of(scene.view(), 3));
    const std::vector<float> x = {p.x}, y = {p.y}, z = {p.z}, zero = {0};
    const std::vector<accel::CellId> cell = {static_cast<accel::CellId>(3)};
    RayStats stats;
    std::vector<WalkStatus> status(1);
    nearest(scene.view(), {x, y, z, zero, zero, zero, cell, {}}, {{}, {}, {}, status},
            {.tracer = Tracer::Scalar, .stats = &stats});
    EXPECT_EQ(status[0], WalkStatus::Refused);
    std::vector<std::uint8_t> seen(1);
    visible(scene.view(), {x, y, z, x, y, z, cell, cell}, seen, {.tracer = Tracer::Scalar, .stats = &stats});
    EXPECT_EQ(seen[0], 1);
    EXPECT_EQ(stats.rays, 0u);
    EXPECT_EQ(stats.cells, 0u);
}

// A picture's rays: one a sample, and where it is lit the short ones that darken corners and the one towards the sun.
TEST(Stats, CountTheRaysOfPictures) {
    const accel::Scene scene = office();
    Camera camera;
    camera.eye = test::centre_of(scene.view(), 0);
    camera.target = camera.eye + Vec3d{1, 0.5, -0.5};
    camera.width = 40;
    camera.height = 30;
    RayStats plain, lit;
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.shading = Shading::Lambert;
    options.stats = &plain;
    (void)trace(scene.view(), camera, options);
    EXPECT_EQ(plain.rays, 1200u);
    EXPECT_GE(plain.cells, plain.rays);
    options.shading = Shading::Look;
    options.samples_per_pixel = 4;
    options.look.ambient_samples = 5;
    options.stats = &lit;
    (void)trace(scene.view(), camera, options);
    EXPECT_GE(lit.rays, 4800u * 3);
    EXPECT_LE(lit.rays, 4800u * (1 + 5 + 1));
    EXPECT_GE(lit.cells, lit.rays);
}

}  // namespace
}  // namespace enfilade::render
