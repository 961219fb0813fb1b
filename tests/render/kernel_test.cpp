// The loops compiled for different instruction sets, and any number of threads, give the same picture bit for bit.
#include "render/kernel.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

accel::Scene office() {
    return accel::assemble(test::synthetic_office({.rooms_per_row = 20, .rows = 4, .storeys = 2, .turn = 0.3}));
}

Camera inside(Vec3d eye, Vec3d target) {
    const double c = std::cos(0.3), s = std::sin(0.3);
    Camera camera;
    camera.eye = {c * eye.x - s * eye.y, s * eye.x + c * eye.y, eye.z};
    camera.target = {c * target.x - s * target.y, s * target.x + c * target.y, target.z};
    camera.width = 200;
    camera.height = 150;
    return camera;
}

std::vector<Camera> cameras() {
    return {inside({2, 2, 1.6}, {4, 10, 1.2}), inside({10, 6.4, 1.6}, {80, 6.4, 1.6}),
            inside({-4, -4, 5}, {20, 10, 0})};
}

TEST(Trace, IsTheSameForOneAndManyThreads) {
    const accel::Scene scene = office();
    for (const Camera& camera : cameras()) {
        for (const Shading shading : {Shading::Lambert, Shading::Look}) {
            const accel::SerialExecutor one;
            const accel::ThreadExecutor four(4);
            const std::unique_ptr<accel::Executor> best = make_executor();
            TraceOptions options;
            options.shading = shading;
            options.samples_per_pixel = shading == Shading::Look ? 4 : 1;
            options.executor = &one;
            RayStats stats;
            options.stats = &stats;
            const Image image = trace(scene.view(), camera, options);
            EXPECT_EQ(stats.leaks, 0u);
            EXPECT_GT(stats.cells, 0u);
            options.executor = &four;
            EXPECT_EQ(trace(scene.view(), camera, options), image);
            options.executor = best.get();
            options.stats = nullptr;
            EXPECT_EQ(trace(scene.view(), camera, options), image);
        }
    }
}

TEST(Trace, LambertAgreesWithTheOraclesPicture) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.3}));
    Camera camera = inside({2, 2, 1.6}, {4, 10, 1.2});
    camera.width = camera.height = 64;
    TraceOptions options;
    options.shading = Shading::Lambert;
    const Image image = trace(scene.view(), camera, options);
    const Image expected = trace_by_oracle(scene.view(), camera);
    int different = 0, tinted = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const Vec3f a = image.pixel(x, y), b = expected.pixel(x, y);
            if (std::abs(a.x - b.x) < 1e-4f && std::abs(a.y - b.y) < 1e-4f) continue;
            // What is seen through a pane is tinted by the walk alone.
            std::abs(a.x - 0.75f * b.x) < 1e-3f ? ++tinted : ++different;
        }
    EXPECT_LE(different, 2);
    EXPECT_LT(tinted, 1000);
}

TEST(Kernels, OfAllInstructionSetsAgreeBitForBit) {
    const accel::Scene scene = office();
    std::mt19937_64 random(3);
    std::vector<RayQuery> rays;
    for (int i = 0; i < 20000; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % scene.view().cells.size());
        rays.push_back({test::random_point(scene.view(), cell, random), test::random_direction(random),
                        static_cast<accel::CellId>(cell)});
    }
    std::vector<RayHit> fast(rays.size()), plain(rays.size());
    for (const bool is_float : {true, false}) {
        RayStats fast_stats, plain_stats;
        detail::RayJob job = {&scene.view(), rays.data(), fast.data(), rays.size(), &fast_stats};
        (is_float ? detail::kernels().rays_float : detail::kernels().rays_double)(job);
        job.hits = plain.data();
        job.stats = &plain_stats;
        (is_float ? detail::portable_kernel_set().rays_float : detail::portable_kernel_set().rays_double)(job);
        EXPECT_EQ(fast_stats.cells, plain_stats.cells);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            ASSERT_EQ(fast[i].source_face, plain[i].source_face);
            ASSERT_EQ(fast[i].distance, plain[i].distance);
        }
    }
}

TEST(Dollhouse, ShowsCutWallsDarkAndRoomsFromAbove) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2}));
    Camera camera;
    camera.eye = {6.4, 6.2, 40};
    camera.target = {6.4, 6.2, 0};
    camera.up = {0, 1, 0};
    camera.width = camera.height = 128;
    camera.fov_deg = 50;
    TraceOptions options;
    options.cut_z = 1.5;
    const Image image = trace(scene.view(), camera, options);
    // The same place on the plan: x east, y north, 40 m below.
    const auto at = [&](double x, double y) {
        const double scale = 64 / (std::tan(25 * 3.14159265 / 180) * 38.5);
        return image.pixel(static_cast<int>(64 + (x - 6.4) * scale), static_cast<int>(64 - (y - 6.2) * scale));
    };
    EXPECT_EQ(at(4.3, 3), options.look.cut);
    EXPECT_NE(at(2.2, 3), options.look.cut);
    EXPECT_GT(at(2.2, 3).x, 2 * options.look.cut.x);
    EXPECT_EQ(image.pixel(0, 0), options.look.paper);
    camera.eye.z = 1;
    EXPECT_THROW((void)trace(scene.view(), camera, options), std::runtime_error);
}

}  // namespace
}  // namespace enfilade::render
