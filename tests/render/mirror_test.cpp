// Floors that mirror, against brute force; and pictures walked in double precision.
#include "render/mirror.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/kernel.h"
#include "render/oracle.h"
#include "render/trace.h"
#include "tests/render/walk_paths.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

accel::SceneInput office(double turn = 0) {
    return test::synthetic_office({.rooms_per_row = 3, .rows = 2, .storeys = 2, .turn = turn});
}

std::uint32_t room_of(const accel::SceneView& scene) {
    std::uint32_t room = 0;
    while (scene.cells[room].label != accel::Label::Room) ++room;
    return room;
}

/// In a room, towards its floor and through its door.
Camera camera_in(const accel::SceneView& scene, Vec3d way = {0.35, 1, -0.5}) {
    Camera camera;
    camera.eye = test::centre_of(scene, room_of(scene)) + Vec3d{0.13, -0.71, 0.17};
    camera.target = camera.eye + way;
    camera.width = camera.height = 96;
    return camera;
}

TraceOptions lambert(float mirror_floor) {
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.shading = Shading::Lambert;
    options.mirror_floor = mirror_floor;
    return options;
}

/// Pixels in which the pictures differ by more than rounding.
int differing(const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) {
            const Vec3f d = a.pixel(x, y) - b.pixel(x, y);
            count += magnitude(d.x) > 2e-4f || magnitude(d.y) > 2e-4f || magnitude(d.z) > 2e-4f ? 1 : 0;
        }
    return count;
}

/// Without glass: the oracle knows no tints.
void unglaze(accel::SceneInput& input) {
    for (accel::InputPortal& portal : input.portals) portal.tint = {1, 1, 1};
}

TEST(Mirror, ShowsWhatBruteForceSees) {
    for (const double turn : {0.0, 0.3}) {
        accel::SceneInput input = office(turn);
        unglaze(input);
        const accel::Scene scene = accel::assemble(input);
        const Camera camera = camera_in(scene.view());
        const Image dull = trace(scene.view(), camera, lambert(0));
        for (const float share : {0.25f, 1.0f}) {
            const Image expected = trace_by_oracle(scene.view(), camera, 1, share);
            for (const Precision precision : {Precision::Float, Precision::Double}) {
                TraceOptions options = lambert(share);
                options.precision = precision;
                const Image image = trace(scene.view(), camera, options);
                EXPECT_LE(differing(image, expected), 6) << "turned by " << turn << ", share " << share;
                EXPECT_GT(differing(image, dull), 1500);
            }
        }
    }
}

// Corners and the sun are not what the oracle knows, but lit by the headlight alone both shadings are the same picture.
TEST(Mirror, ShowsTheSameInBothShadings) {
    const accel::Scene scene = accel::assemble(office());
    const Camera camera = camera_in(scene.view());
    const Image expected = trace(scene.view(), camera, lambert(0.5f));
    TraceOptions options = lambert(0.5f);
    options.shading = Shading::Look;
    options.look = lambert_look(options.look);
    EXPECT_EQ(differing(trace(scene.view(), camera, options), expected), 0);
    options.precision = Precision::Double;
    EXPECT_LE(differing(trace(scene.view(), camera, options), expected), 6);
}

TEST(Mirror, OfNoShareChangesNothing) {
    const accel::Scene scene = accel::assemble(office(0.3));
    const Camera camera = camera_in(scene.view());
    for (const Shading shading : {Shading::Lambert, Shading::Look}) {
        RayStats without, with;
        TraceOptions options = lambert(0);
        options.shading = shading;
        options.stats = &without;
        const Image dull = trace(scene.view(), camera, options);
        options.mirror_floor = 1e-30f;  // too little to be seen: Lambert walks it, pictures for people leave it
        options.stats = &with;
        EXPECT_EQ(trace(scene.view(), camera, options), dull);
        if (shading == Shading::Lambert) EXPECT_GT(with.rays, without.rays + 1500);
        else EXPECT_EQ(with.rays, without.rays);
    }
}

// What is white all over and lit evenly stays white, however much of it is mirrored: no light is won or lost.
TEST(Mirror, KeepsTheEnergyOfAWhiteRoom) {
    accel::SceneInput input = test::synthetic_office({.rooms_per_row = 2, .rows = 2, .doors = false});
    for (accel::InputMaterial& material : input.materials) material.colour = {1, 1, 1};
    unglaze(input);
    const accel::Scene scene = accel::assemble(input);
    TraceOptions options = lambert(0);
    options.shading = Shading::Look;
    options.look = lambert_look(options.look);
    options.look.headlight = 0;
    options.look.ambient = options.look.sky_horizon = options.look.sky_zenith = {1, 1, 1};
    for (const float share : {0.0f, 0.5f, 1.0f}) {
        options.mirror_floor = share;
        const Image image = trace(scene.view(), camera_in(scene.view(), {0.2, 1, -1.1}), options);
        for (const float channel : image.rgb) ASSERT_EQ(channel, 1.0f) << "share " << share;
    }
}

TEST(Mirror, IsNoGroundOutdoors) {
    const accel::Scene scene = accel::assemble(office());
    Camera camera;
    camera.eye = {-2.5, -2.5, 1.6};
    camera.target = {-2.4, -3, 0.2};
    camera.width = camera.height = 64;
    RayStats stats;
    TraceOptions options = lambert(1);
    options.stats = &stats;
    const Image image = trace(scene.view(), camera, options);
    EXPECT_EQ(stats.rays, 64u * 64u);
    EXPECT_EQ(image, trace(scene.view(), camera, lambert(0)));
}

// The image of a ray is the same line on the plan, bit for bit: it leaves the mirror's cell through the section that
// the ray would have crossed had it not met the floor, at the same parameter.
TEST(Mirror, KeepsTheLineOnThePlan) {
    const accel::Scene scene = accel::assemble(office(0.3));
    const accel::SceneView& view = scene.view();
    std::mt19937_64 random(23);
    int mirrors = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto cell = static_cast<std::uint32_t>(random() % view.cells.size());
        Ray<float> ray;
        ASSERT_TRUE(make_ray(vec_cast<float>(test::random_point(view, cell, random)),
                             vec_cast<float>(test::random_direction(random)), ray));
        const auto fall = test::follow(view, ray, cell);
        if (!is_mirror_hit(view, fall.end)) continue;
        ++mirrors;
        const float z = view.cells[fall.end.cell].z_floor;
        const Ray<float> image = mirrored(ray, z);
        EXPECT_EQ(image.moment, ray.moment);
        EXPECT_EQ(image.zero_mask, ray.zero_mask);
        // Both meet the mirror at the same parameter, the image from below.
        const float fallen = parameter(view, ray, fall.end);
        EXPECT_NEAR(image.origin.z + fallen * image.direction.z, z, 1e-5f);
        const auto rise = test::follow(view, image, fall.end.cell);
        ASSERT_EQ(rise.end.status, WalkStatus::Hit);
        EXPECT_NE(rise.end.exit, Exit::Floor);
        EXPECT_GE(parameter(view, image, rise.end), fallen * (1 - 1e-5f));
        if (rise.path.cells.size() == 1 && rise.path.several + rise.path.none + fall.path.several == 0) {
            EXPECT_EQ(rise.end.section, fall.end.section);
            EXPECT_EQ(rise.end.num, fall.end.num);
            EXPECT_EQ(rise.end.den, fall.end.den);
        }
    }
    EXPECT_GT(mirrors, 1500);
}

TEST(Mirror, OfADollhouseSeesTheSkyThroughTheCut) {
    const accel::Scene scene = accel::assemble(office());
    Camera camera;
    camera.eye = test::centre_of(scene.view(), room_of(scene.view())) + Vec3d{0, 0, 30};
    camera.target = camera.eye - Vec3d{0, 0, 1};
    camera.up = {0, 1, 0};
    camera.fov_deg = 2;
    camera.width = camera.height = 8;
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.cut_z = scene.view().cells[room_of(scene.view())].z_floor + 1.5;
    options.mirror_floor = 1;
    const Image image = trace(scene.view(), camera, options);
    for (int i = 0; i < 8; ++i) {
        const Vec3f p = image.pixel(i, i);
        EXPECT_NEAR(p.x, options.look.sky_zenith.x, 0.01);
        EXPECT_NEAR(p.z, options.look.sky_zenith.z, 0.01);
    }
}

TEST(DoublePictures, AreNearerToTheOracleAndOtherBits) {
    accel::SceneInput input = office(0.3);
    unglaze(input);
    const accel::Scene scene = accel::assemble(input);
    const Camera camera = camera_in(scene.view());
    const Image expected = trace_by_oracle(scene.view(), camera);
    TraceOptions options = lambert(0);
    const Image single = trace(scene.view(), camera, options);
    options.precision = Precision::Double;
    const Image precise = trace(scene.view(), camera, options);
    EXPECT_NE(single, precise);
    double single_error = 0, precise_error = 0;
    for (std::size_t i = 0; i < expected.rgb.size(); ++i) {
        // Where edges decide, either may be right.
        const double a = magnitude(single.rgb[i] - expected.rgb[i]), b = magnitude(precise.rgb[i] - expected.rgb[i]);
        if (a < 1e-4 && b < 1e-4) {
            single_error += a;
            precise_error += b;
        }
    }
    EXPECT_LT(precise_error, 0.5 * single_error);
    EXPECT_LE(differing(single, precise), 6);
    options.tracer = Tracer::Packet;
    EXPECT_ANY_THROW((void)trace(scene.view(), camera, options));
}

TEST(DoublePictures, OfAllInstructionSetsAreTheSame) {
    const accel::Scene scene = accel::assemble(office(0.3));
    const Camera camera = camera_in(scene.view());
    const CameraFrame frame = make_frame(camera);
    const Look look;
    Image pictures[2] = {Image(96, 96), Image(96, 96)};
    for (const bool is_double : {false, true})
        for (const bool is_look : {false, true}) {
            for (const bool is_fast : {false, true}) {
                detail::TileJob job = {};
                job.scene = &scene.view();
                job.camera = &frame;
                job.look = &look;
                job.rgb = pictures[is_fast].rgb.data();
                job.width = job.x1 = job.y1 = 96;
                job.samples_a_side = 1;
                job.start_cell = static_cast<std::uint32_t>(start_cell(scene.view(), frame));
                job.mirror_floor = 0.5f;
                job.is_double = is_double;
                const detail::Kernels& set = is_fast ? detail::kernels() : detail::portable_kernel_set();
                (is_look ? set.look_tile : set.lambert_tile)(job);
            }
            EXPECT_EQ(pictures[0], pictures[1]) << is_double << is_look;
        }
}

}  // namespace
}  // namespace enfilade::render
