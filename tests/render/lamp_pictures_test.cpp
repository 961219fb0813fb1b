// Pictures by the light of lamps: however it is found out which lamps a place sees, they are the same.

#include <gtest/gtest.h>

#include <cstring>

#include "accel/assemble.h"
#include "render/executor.h"
#include "render/kernel.h"
#include "tests/support/lamp_judge.h"
#include "tests/support/object_scenes.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using test::LitScene;
using test::PictureTally;

LitScene lit_office(double turn, int storeys = 1, int lamps = 24) {
    LitScene lit(accel::assemble(test::synthetic_office({.rooms_per_row = 4, .storeys = storeys, .turn = turn})));
    lit.add_random_lamps(lamps, 3);
    return lit;
}

TraceOptions by_lamps(Shading shading = Shading::Lambert) {
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    options.shading = shading;
    return options;
}

/// Most pixels are lit, and none is wrong.
void expect_same(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options,
                 const ObjectTracer* objects = nullptr) {
    const PictureTally tally = test::judge_pictures(scene, camera, options, objects);
    EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
    EXPECT_LE(tally.differing * 500, tally.pixels);
    EXPECT_GT(tally.lit * 10, tally.pixels);
}

TEST(LampPictures, OfOffices) {
    for (const double turn : {0.0, 0.3}) {
        const LitScene lit = lit_office(turn, turn == 0 ? 2 : 1);
        for (const Camera& camera : test::cameras_by_lamps(lit.view(), 4, 96))
            expect_same(lit.view(), camera, by_lamps());
    }
}

TEST(LampPictures, BesideSunAndSky) {
    const LitScene lit = lit_office(0.3, 1, 8);
    TraceOptions options = by_lamps(Shading::Look);
    options.look.ambient_samples = 2;
    expect_same(lit.view(), test::cameras_by_lamps(lit.view(), 1, 48).at(0), options);
}

TEST(LampPictures, FromOutside) {
    LitScene lit = lit_office(0.3, 1, 6);
    lit.add_lamp({-3, -4, 2.2}, {300, 200, 100});
    lit.add_lamp({-2, 9, 2.2}, {300, 200, 100});
    Camera camera;
    camera.eye = {-4, -6, 1.7};
    camera.target = {3, 3, 1.2};
    camera.width = camera.height = 96;
    ASSERT_NO_THROW((void)start_cell(lit.view(), make_frame(camera)));
    const PictureTally tally = test::judge_pictures(lit.view(), camera, by_lamps(), nullptr);
    EXPECT_EQ(tally.wrong, 0u) << tally.first_wrong;
    EXPECT_GT(tally.lit, 0u);
}

TEST(LampPictures, WithMirrorsOnTheFloor) {
    const LitScene lit = lit_office(0.3);
    TraceOptions options = by_lamps();
    options.mirror_floor = 0.5f;
    for (const Camera& camera : test::cameras_by_lamps(lit.view(), 2, 64)) {
        // Who is within the error band of an edge is not looked for in mirrors.
        const PictureTally tally = test::judge_pictures(lit.view(), camera, options, nullptr);
        EXPECT_LE(tally.wrong * 500, tally.pixels) << tally.first_wrong;
        EXPECT_GT(tally.lit * 10, tally.pixels);
    }
}

/// A cut takes walls away from the eye, not from the light, and lamps above it shine.
TEST(LampPictures, CutBelowTheLamps) {
    LitScene lit(accel::assemble(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.3})));
    lit.add_random_lamps(200, 5);
    Camera camera;
    camera.eye = {3, 4, 30};
    camera.target = {6, 7, 0};
    camera.width = camera.height = 64;
    TraceOptions options = by_lamps();
    options.cut_z = 1.2;
    const PictureTally tally = test::judge_pictures(lit.view(), camera, options, nullptr);
    EXPECT_LE(tally.wrong * 500, tally.pixels) << tally.first_wrong;
    EXPECT_GT(tally.lit * 10, tally.pixels);
    // The same floor, by those above the cut alone: still lit, and not more than by all.
    std::vector<accel::Light> high;
    for (const accel::Light& light : lit.view().lights)
        if (light.position[2] > 1.3f) high.push_back(light);
    ASSERT_GT(high.size(), 20u);
    accel::SceneView view = lit.view();
    options.lamps = LampOptions{.search = LampSearch::Tree, .exposure = 0.02f};
    const Image all = trace(view, camera, options);
    view.lights = {high.data(), high.size()};
    const Image some = trace(view, camera, options);
    int lit_pixels = 0, brighter = 0;
    for (std::size_t i = 0; i < all.rgb.size(); ++i) {
        lit_pixels += some.rgb[i] > 0.01f ? 1 : 0;
        brighter += some.rgb[i] > 1.001f * all.rgb[i] + 1e-6f ? 1 : 0;
    }
    EXPECT_GT(lit_pixels, 1000);
    EXPECT_EQ(brighter, 0);
}

/// In double, rounding decides for other pixels; the rest have the same light.
TEST(LampPictures, InDoubleAsInFloat) {
    const LitScene lit = lit_office(0.3);
    const Camera camera = test::cameras_by_lamps(lit.view(), 1, 96).at(0);
    TraceOptions options = by_lamps();
    options.lamps = LampOptions{.search = LampSearch::Naive, .exposure = 0.02f};
    const Image single = trace(lit.view(), camera, options);
    options.precision = Precision::Double;
    expect_same(lit.view(), camera, options);
    const Image exact = trace(lit.view(), camera, options);
    int differing = 0, lit_parts = 0;
    for (std::size_t i = 0; i < single.rgb.size(); ++i) {
        lit_parts += exact.rgb[i] > 0 ? 1 : 0;
        differing += std::abs(single.rgb[i] - exact.rgb[i]) > 1e-4f * exact.rgb[i] + 1e-7f ? 1 : 0;
    }
    EXPECT_GT(lit_parts, 20000);
    EXPECT_LE(differing, 300);
}

TEST(LampPictures, CountPairsOfPlacesAndLamps) {
    const LitScene lit = lit_office(0.3);
    const Camera camera = test::cameras_by_lamps(lit.view(), 1, 32).at(0);
    RayStats stats[3];
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
        TraceOptions options = by_lamps();
        options.lamps = LampOptions{.search = search};
        options.stats = &stats[static_cast<int>(search)];
        (void)trace(lit.view(), camera, options);
    }
    EXPECT_EQ(stats[0].lamps_considered % lit.view().lights.size(), 0u);
    EXPECT_LT(stats[1].lamps_considered, stats[0].lamps_considered);
    EXPECT_EQ(stats[1].lamps_considered, stats[2].lamps_considered);
    EXPECT_GT(stats[0].lamps_lit, 1000u);
    EXPECT_NEAR(static_cast<double>(stats[1].lamps_lit), static_cast<double>(stats[0].lamps_lit), 5.0);
    EXPECT_NEAR(static_cast<double>(stats[2].lamps_lit), static_cast<double>(stats[0].lamps_lit), 5.0);
    EXPECT_LT(stats[2].rays, stats[1].rays);
}

/// Every instruction set draws what the loops for any machine draw.
TEST(LampPictures, AreTheSameBitsWithEveryInstructionSet) {
    LitScene lit(test::furnished_office({.seed = 3, .objects = 40, .turn = 0.4}));
    lit.add_random_lamps(12, 9);
    const accel::SceneView scene = lit.view();
    const auto executor = make_executor(1);
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, *executor);
    const auto built = build_object_accel(scene, ObjectAccelKind::Plain, *executor);
    const ObjectTracer objects = built->tracer();
    const Camera camera = test::cameras_by_lamps(scene, 1, 64).at(0);
    const CameraFrame frame = make_frame(camera);
    const Look look;
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
        const Lamps lamps = {.trees = trees.view(), .search = search, .exposure = 0.02f};
        const auto drawn = [&](const detail::Kernels& kernels) {
            std::vector<float> rgb(3 * 64 * 64);
            detail::TileJob job = {};
            job.scene = &scene;
            job.camera = &frame;
            job.look = &look;
            job.rgb = rgb.data();
            job.width = job.x1 = job.y1 = 64;
            job.samples_a_side = 1;
            job.start_cell = static_cast<std::uint32_t>(start_cell(scene, frame));
            job.objects = &objects;
            job.lamps = &lamps;
            kernels.lambert_tile(job);
            return rgb;
        };
        const std::vector<float> expected = drawn(detail::portable_kernel_set());
        EXPECT_GT(*std::max_element(expected.begin(), expected.end()), 0.05f);
        for (const detail::Kernels* kernels : detail::kernel_sets())
            EXPECT_EQ(std::memcmp(drawn(*kernels).data(), expected.data(), expected.size() * sizeof(float)), 0)
                << kernels->name;
    }
}

}  // namespace
}  // namespace enfilade::render
