#include <gtest/gtest.h>

#include <cmath>

#include "accel/assemble.h"
#include "render/embree_reference.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

accel::Scene office() {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 6, .rows = 4, .storeys = 2, .turn = 0.3}));
}

std::vector<RayQuery> random_rays(const accel::SceneView& view, int count) {
    std::mt19937_64 random(17);
    std::vector<RayQuery> rays;
    for (int i = 0; i < count; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % view.cells.size());
        rays.push_back({test::random_point(view, cell, random),
                        vec_cast<double>(vec_cast<float>(test::random_direction(random))),
                        static_cast<accel::CellId>(cell)});
    }
    return rays;
}

/// The same rays as columns that own their memory.
struct Columns {
    std::vector<float> o[3], d[3], limit;
    std::vector<float> distance;
    std::vector<accel::SourceFaceId> face;
    std::vector<WalkStatus> status;

    explicit Columns(std::span<const RayQuery> rays) : distance(rays.size()), face(rays.size()), status(rays.size()) {
        for (const RayQuery& ray : rays) {
            const Vec3f p = vec_cast<float>(ray.origin), q = vec_cast<float>(ray.direction);
            o[0].push_back(p.x), o[1].push_back(p.y), o[2].push_back(p.z);
            d[0].push_back(q.x), d[1].push_back(q.y), d[2].push_back(q.z);
        }
    }
    [[nodiscard]] RayColumns rays() const { return {o[0], o[1], o[2], d[0], d[1], d[2], {}, limit}; }
    [[nodiscard]] HitColumns hits() { return {distance, face, {}, status}; }
};

TEST(Embree, MeetsTheSameFacesOutsideTheBand) {
    const accel::Scene scene = office();
    const accel::SceneView& view = scene.view();
    const EmbreeReference embree(view);
    const Oracle oracle(view);
    const double band = error_band(view);
    const std::vector<RayQuery> rays = random_rays(view, 300000);
    std::vector<RayHit> cells(rays.size()), reference(rays.size());
    trace_rays(view, rays, cells);
    embree.trace(rays, reference);
    int inside = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        ASSERT_EQ(cells[i].status, WalkStatus::Hit);
        if (reference[i].status == WalkStatus::Hit && cells[i].source_face == reference[i].source_face) continue;
        EXPECT_LE(oracle.edge_distance(rays[i].origin, rays[i].direction,
                                       std::max(cells[i].distance, reference[i].distance) + band),
                  band)
            << "ray " << i;
        ++inside;
    }
    EXPECT_LT(inside, 200);
}

TEST(Embree, AnswersAlikeHoweverItIsAsked) {
    const accel::Scene scene = office();
    const EmbreeReference embree(scene.view());
    const std::vector<RayQuery> rays = random_rays(scene.view(), 50'003);  // the last packet is not full
    std::vector<RayHit> reference(rays.size());
    embree.trace(rays, reference);
    const std::unique_ptr<accel::Executor> cores = make_executor();
    for (const EmbreeWay way : embree_ways) {
        Columns columns(rays);
        embree.nearest(columns.rays(), columns.hits(), way, *cores);
        int other_face = 0, other_distance = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(columns.status[i], reference[i].status);
            if (columns.face[i] != reference[i].source_face) ++other_face;
            else other_distance += std::abs(columns.distance[i] - reference[i].distance) > 1e-3;
        }
        EXPECT_LE(other_face, 40) << text(way);
        EXPECT_EQ(other_distance, 0) << text(way);
    }
}

TEST(Embree, StopsAtTheLimitInEveryWay) {
    const accel::Scene scene = office();
    const EmbreeReference embree(scene.view());
    const std::vector<RayQuery> rays = random_rays(scene.view(), 5'000);
    std::vector<RayHit> reference(rays.size());
    embree.trace(rays, reference);
    for (const EmbreeWay way : embree_ways) {
        Columns columns(rays);
        for (std::size_t i = 0; i < rays.size(); ++i)
            columns.limit.push_back(static_cast<float>(reference[i].distance) * (i % 2 == 0 ? 0.99f : 1.01f));
        embree.nearest(columns.rays(), columns.hits(), way, accel::SerialExecutor());
        int wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            wrong += columns.status[i] != (i % 2 == 0 ? WalkStatus::Reached : WalkStatus::Hit);
        EXPECT_LE(wrong, 4) << text(way);
    }
}

TEST(Embree, SeesAsFarAsTheNearestFaceInEveryWay) {
    const accel::Scene scene = office();
    const EmbreeReference embree(scene.view());
    const std::vector<RayQuery> rays = random_rays(scene.view(), 5'001);
    std::vector<RayHit> hits(rays.size());
    embree.trace(rays, hits);
    Columns from(rays), to(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double t = hits[i].distance / length(rays[i].direction) * (i % 3 == 0 ? 0.99 : 1.01);
        const Vec3f q = vec_cast<float>(rays[i].origin + t * rays[i].direction);
        to.o[0][i] = q.x, to.o[1][i] = q.y, to.o[2][i] = q.z;
    }
    const SegmentColumns segments = {from.o[0], from.o[1], from.o[2], to.o[0], to.o[1], to.o[2], {}, {}};
    for (const EmbreeWay way : embree_ways) {
        std::vector<std::uint8_t> visible(rays.size(), 2);
        embree.visible(segments, visible, way, accel::SerialExecutor());
        int wrong = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) wrong += visible[i] != (i % 3 == 0 ? 1 : 0);
        EXPECT_LE(wrong, 4) << text(way);
    }
}

TEST(Embree, SkinKeepsRaysOffTheFaceOnWhichTheyStart) {
    const accel::Scene scene = office();
    const EmbreeReference embree(scene.view());
    std::vector<RayQuery> rays = random_rays(scene.view(), 5'000);
    std::vector<RayHit> hits(rays.size());
    embree.trace(rays, hits);
    // Back along the way that they came.
    for (std::size_t i = 0; i < rays.size(); ++i) {
        rays[i].origin = rays[i].origin + hits[i].distance / length(rays[i].direction) * rays[i].direction;
        rays[i].direction = -rays[i].direction;
    }
    for (const EmbreeWay way : embree_ways) {
        Columns columns(rays);
        embree.nearest(columns.rays(), columns.hits(), way, accel::SerialExecutor(), 2e-3f);
        int same = 0;
        for (std::size_t i = 0; i < rays.size(); ++i)
            same += columns.face[i] == hits[i].source_face && columns.distance[i] < 1e-2f;
        EXPECT_LE(same, 20) << text(way);  // those that graze it
    }
}

/// The picture of a camera in the middle of an office.
struct View {
    accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 4, .rows = 4, .doors = true}));
    CameraFrame frame;

    View() {
        Camera camera;
        camera.eye = {2, 6.4, 1.6};
        camera.target = {10, 6, 1.4};
        camera.width = camera.height = 128;
        frame = make_frame(camera);
    }
};

TEST(Embree, DrawsTheSamePicture) {
    const View view;
    Framebuffer cells(128, 128);
    trace_lambert(view.scene.view(), view.frame, start_cell(view.scene.view(), view.frame), {.tracer = Tracer::Scalar},
                  accel::SerialExecutor(), cells);
    const EmbreeReference embree(view.scene.view());
    for (const EmbreeWay way : embree_ways) {
        Framebuffer picture(128, 128);
        embree.trace_lambert(view.frame, way, accel::SerialExecutor(), picture);
        int different = 0;
        for (std::size_t i = 0; i < cells.rgba.size(); ++i) {
            for (int shift = 0; shift < 24; shift += 8) {
                const int ours = static_cast<int>(cells.rgba[i] >> shift & 255u);
                const int other = static_cast<int>(picture.rgba[i] >> shift & 255u);
                // What is seen through a pane is tinted by the walk alone.
                different += std::abs(ours - other) > 1 && !(ours >= other * 0.86 && ours < other);
            }
        }
        EXPECT_LE(different, 18) << text(way);
    }
}

TEST(Embree, DrawsTheSamePictureOnAllCores) {
    const View view;
    const EmbreeReference embree(view.scene.view());
    const std::unique_ptr<accel::Executor> cores = make_executor();
    for (const EmbreeWay way : embree_ways) {
        Framebuffer one(128, 128), all(128, 128);
        embree.trace_lambert(view.frame, way, accel::SerialExecutor(), one);
        embree.trace_lambert(view.frame, way, *cores, all);
        EXPECT_EQ(one, all) << text(way);
    }
}

}  // namespace
}  // namespace enfilade::render
