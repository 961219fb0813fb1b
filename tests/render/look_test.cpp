#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/trace.h"
#include "render/trace_rays.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

accel::Scene office() { return accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2})); }

std::uint32_t first_with(const accel::SceneView& scene, accel::Label label) {
    std::uint32_t c = 0;
    while (scene.cells[c].label != label) ++c;
    return c;
}

TEST(Glass, TintsWhatCrossesIt) {
    const accel::Scene scene = office();
    const std::uint32_t window = first_with(scene.view(), accel::Label::Window);
    const Vec3d p = test::centre_of(scene.view(), window);
    const RayHit out = trace_ray(scene.view(), {p, {0, -1, 0}, static_cast<accel::CellId>(window)});
    EXPECT_EQ(out.throughput, (Vec3f{0.75f, 0.875f, 0.8125f}));
    EXPECT_EQ(scene.view().source_faces[index(out.source_face)].surface, accel::Surface::Sky);
    // Into the room, down to its floor.
    const RayHit in = trace_ray(scene.view(), {p, {0, 1, -1}, static_cast<accel::CellId>(window)});
    EXPECT_EQ(in.throughput, (Vec3f{1, 1, 1}));
}

TEST(Limit, StopsARayWhereItIsToldTo) {
    const accel::Scene scene = office();
    const std::uint32_t room = first_with(scene.view(), accel::Label::Room);
    const Vec3d p = test::centre_of(scene.view(), room);
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
        RayQuery ray = {p, 7.0 * test::random_direction(random), static_cast<accel::CellId>(room)};
        const RayHit far = trace_ray(scene.view(), ray, Precision::Double);
        ray.max_distance = 0.99 * far.distance;
        EXPECT_EQ(trace_ray(scene.view(), ray, Precision::Double).status, WalkStatus::Reached);
        ray.max_distance = 1.01 * far.distance;
        const RayHit near = trace_ray(scene.view(), ray, Precision::Double);
        EXPECT_EQ(near.status, WalkStatus::Hit);
        EXPECT_EQ(near.source_face, far.source_face);
    }
}

TEST(TraceRays, AnswersWhatIsNoRayWithRefused) {
    const accel::Scene scene = office();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(trace_ray(scene.view(), {{nan, 0, 0}, {1, 0, 0}, {}}).status, WalkStatus::Refused);
    EXPECT_EQ(trace_ray(scene.view(), {{0, 0, 0}, {0, 0, 0}, {}}).status, WalkStatus::Refused);
    EXPECT_EQ(trace_ray(scene.view(), {{0, 0, 0}, {1, 0, 0}, {}, nan}).status, WalkStatus::Refused);
}

// Pictures are lit: the default look leaves no black room and no leak's magenta.
TEST(Look, LightsARoom) {
    const accel::Scene scene = office();
    Camera camera;
    camera.eye = {0.6, 0.7, 1.6};
    camera.target = {3, 4, 1.2};
    camera.width = camera.height = 64;
    TraceOptions options;
    options.samples_per_pixel = 4;
    const Image image = trace(scene.view(), camera, options);
    double mean = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const Vec3f p = image.pixel(x, y);
            EXPECT_GT(p.y, 0);
            mean += p.y / 4096.0;
        }
    EXPECT_GT(mean, 0.15);
    EXPECT_LT(mean, 0.9);
}

}  // namespace
}  // namespace enfilade::render
