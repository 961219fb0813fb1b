// Every picture that the scalar tracer makes a device makes, too, pixel for pixel.
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "render/cuda/pictures.h"
#include "tests/support/devices.h"
#include "tests/support/rich_scene.h"
#include "tests/support/same_pictures.h"
#include "tests/support/trying_cameras.h"

namespace enfilade::render::cuda {
namespace {

class PictureVariants : public test::DeviceTest {
protected:
    PictureVariants() : rich_(test::furnished_office({.seed = 2, .objects = 70, .turn = 0.4})) {}

    /// A few cameras that try tracers, made small.
    static std::vector<Camera> cameras(const accel::SceneView& scene, std::uint64_t seed, std::size_t step) {
        std::vector<Camera> chosen;
        const std::vector<test::TryingCamera> all = test::trying_cameras(scene, seed);
        for (std::size_t k = seed % step; k < all.size(); k += step) {
            chosen.push_back(all[k].camera);
            chosen.back().width = 37;
            chosen.back().height = 29;
        }
        return chosen;
    }

    /// Pictures of the device against those of the scalar tracer. Returns the share of pixels that show anything.
    double expect_same(const accel::SceneView& scene, TraceOptions options, const std::vector<Camera>& seen_from,
                       const PictureOptions& how = {}) {
        const accel::SerialExecutor one;
        options.tracer = Tracer::Scalar;
        options.executor = &one;
        const auto objects = build_object_accel(
            scene, how.inside == InsideKind::Octree ? ObjectAccelKind::Octree : ObjectAccelKind::Plain, one);
        const ObjectTracer inside = objects->tracer();
        options.objects = &inside;
        PictureOptions with_executor = how;
        with_executor.executor = &one;
        Pictures pictures(device(), scene, with_executor);
        test::SamePictures same(device());
        for (std::size_t k = 0; k < seen_from.size(); ++k)
            same.add(render::trace(scene, seen_from[k], options), pictures.trace(seen_from[k], options),
                     "camera " + std::to_string(k));
        EXPECT_GT(same.pixels(), 0u);
        return static_cast<double>(same.lit()) / static_cast<double>(same.pixels());
    }

    test::RichScene rich_;
};
ENFILADE_ON_DEVICES(PictureVariants);

TraceOptions lambert() {
    TraceOptions options;
    options.shading = Shading::Lambert;
    return options;
}

TraceOptions lit(LampSearch search, float exposure = 0.05f) {
    TraceOptions options = lambert();
    options.lamps = {search, exposure, std::nullopt};
    return options;
}

TEST_P(PictureVariants, ShowFurnitureByOctrees) {
    EXPECT_GT(expect_same(rich_.plain(), lambert(), cameras(rich_.plain(), 1, 2)), 0.9);
}

TEST_P(PictureVariants, ShowFurnitureByTreesOfBoxes) {
    EXPECT_GT(expect_same(rich_.plain(), lambert(), cameras(rich_.plain(), 2, 2), {.inside = InsideKind::Bvh}), 0.9);
}

TEST_P(PictureVariants, MirrorInFloors) {
    TraceOptions options = lambert();
    options.mirror_floor = 0.4f;
    EXPECT_GT(expect_same(test::RichScene::bare(rich_.plain()), options, cameras(rich_.plain(), 3, 2)), 0.9);
    EXPECT_GT(expect_same(rich_.plain(), options, cameras(rich_.plain(), 3, 3)), 0.9);
}

TEST_P(PictureVariants, WalkInDouble) {
    TraceOptions options = lambert();
    options.precision = Precision::Double;
    options.mirror_floor = 0.2f;
    expect_same(test::RichScene::bare(rich_.plain()), options, cameras(rich_.plain(), 4, 2));
    for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh})
        expect_same(rich_.plain(), options, cameras(rich_.plain(), 4, 3), {.inside = inside});
}

TEST_P(PictureVariants, AreLitByLampsOfBareRooms) {
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree})
        EXPECT_GT(expect_same(test::RichScene::bare(rich_.plain()), lit(search), cameras(rich_.plain(), 5, 4)), 0.3);
}

TEST_P(PictureVariants, AreLitByLampsAmongFurniture) {
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree})
        for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh})
            EXPECT_GT(expect_same(rich_.plain(), lit(search), cameras(rich_.plain(), 6, 6), {.inside = inside}), 0.2);
}

TEST_P(PictureVariants, AreLitOverFloorsThatMirror) {
    TraceOptions options = lit(LampSearch::Tree);
    for (const float share : {0.3f, 0.9999f, 1e-4f, 1.0f}) {
        options.mirror_floor = share;
        expect_same(rich_.plain(), options, cameras(rich_.plain(), 7, 6));
    }
}

TEST_P(PictureVariants, AreLitInDouble) {
    TraceOptions options = lit(LampSearch::Tree);
    options.precision = Precision::Double;
    expect_same(rich_.plain(), options, cameras(rich_.plain(), 8, 5));
}

TEST_P(PictureVariants, TakeTheTreesOfLampsThatTheyAreGiven) {
    const accel::SceneView scene = rich_.plain();
    const accel::LightTrees trees = accel::build_light_trees(scene, {}, accel::SerialExecutor());
    TraceOptions options = lit(LampSearch::Tree);
    options.lamps->trees = trees.view();
    expect_same(scene, options, cameras(scene, 9, 5));
}

TEST_P(PictureVariants, BearAnyExposure) {
    for (const float exposure : {0.0f, 1e-30f, 1e6f, 3e38f})
        expect_same(rich_.plain(), lit(LampSearch::Pvs, exposure), cameras(rich_.plain(), 10, 8));
}

TEST_P(PictureVariants, ShowSunSkyAndDarkenedCorners) {
    TraceOptions options;
    options.look.ambient_samples = 2;
    expect_same(test::RichScene::bare(rich_.plain()), options, cameras(rich_.plain(), 11, 3));
    expect_same(rich_.plain(), options, cameras(rich_.plain(), 12, 5));
}

TEST_P(PictureVariants, ShowMirrorsGlassAndTextures) {
    TraceOptions options;
    options.look.ambient_samples = 1;
    options.mirror_floor = 0.2f;
    expect_same(test::RichScene::bare(rich_.view()), options, cameras(rich_.plain(), 13, 4));
    for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh})
        expect_same(rich_.view(), options, cameras(rich_.plain(), 14, 6), {.inside = inside});
    options.precision = Precision::Double;
    expect_same(rich_.view(), options, cameras(rich_.plain(), 15, 7));
}

TEST_P(PictureVariants, ShowMirrorsGlassAndTexturesByLampsAlone) {
    expect_same(rich_.view(), lit(LampSearch::Tree), cameras(rich_.plain(), 16, 5));
}

TEST_P(PictureVariants, ShowLampsBesidesSunAndSky) {
    TraceOptions options = lit(LampSearch::Tree);
    options.shading = Shading::Look;
    options.look.ambient_samples = 1;
    expect_same(rich_.plain(), options, cameras(rich_.plain(), 17, 6));
}

TEST_P(PictureVariants, TakeSeveralSamplesAPixel) {
    TraceOptions options = lambert();
    options.samples_per_pixel = 3;  // which makes four
    expect_same(rich_.plain(), options, cameras(rich_.plain(), 18, 6));
    options = lit(LampSearch::Tree);
    options.samples_per_pixel = 9;
    expect_same(test::RichScene::bare(rich_.plain()), options, cameras(rich_.plain(), 18, 8));
}

TEST_P(PictureVariants, CutDollhouses) {
    Camera above;
    above.eye = {5, 4, 25};
    above.target = {6, 6.3, 0};
    above.up = {0, 1, 0};
    above.width = 61;
    above.height = 53;
    TraceOptions options;
    options.look.ambient_samples = 1;
    for (const double cut : {1.2, 2.0}) {
        options.cut_z = cut;
        EXPECT_EQ(expect_same(rich_.view(), options, {above}), 1.0);
        expect_same(test::RichScene::bare(rich_.plain()), options, {above});
    }
    options.precision = Precision::Double;
    expect_same(rich_.view(), options, {above}, {.inside = InsideKind::Bvh});
}

TEST_P(PictureVariants, AreOfOnePixelOrOfOddSizes) {
    std::vector<Camera> seen_from(5, cameras(rich_.plain(), 19, 1).at(0));
    for (std::size_t k = 0; k < seen_from.size(); ++k) {
        seen_from[k].width = std::array{1, 1, 131, 65, 8}[k];
        seen_from[k].height = std::array{1, 131, 1, 67, 4}[k];
    }
    expect_same(rich_.plain(), lambert(), seen_from);
    expect_same(rich_.plain(), lit(LampSearch::Tree), seen_from);
}

TEST_P(PictureVariants, ShowFurnitureThatNoCellLists) {
    accel::SceneView scene = rich_.plain();
    const std::vector<std::uint32_t> offsets(scene.cells.size() + 1, 0);
    scene.cell_object_offsets = {offsets.data(), offsets.size()};
    scene.cell_objects = {};
    for (const InsideKind inside : {InsideKind::Octree, InsideKind::Bvh})
        expect_same(scene, lambert(), cameras(scene, 20, 6), {.inside = inside});
}

TEST_P(PictureVariants, AreDarkWithoutLamps) {
    accel::SceneView scene = test::RichScene::bare(rich_.plain());
    scene.lights = {};
    for (const LampSearch search : {LampSearch::Naive, LampSearch::Pvs, LampSearch::Tree}) {
        TraceOptions options = lit(search);
        options.look.sky_zenith = options.look.sky_horizon = {0, 0, 0};
        EXPECT_EQ(expect_same(scene, options, cameras(scene, 21, 6)), 0.0);
    }
}

TEST_P(PictureVariants, ShowRoomsBareWhereFurnitureIsNotWanted) {
    const accel::SceneView scene = rich_.plain();
    Pictures pictures(device(), scene, {.has_objects = false});
    const Camera camera = cameras(scene, 22, 1).at(0);
    TraceOptions options = lambert();
    options.tracer = Tracer::Scalar;
    test::SamePictures same(device());
    same.add(render::trace(test::RichScene::bare(scene), camera, options), pictures.trace(camera, options), "bare");
}

/// The rule that an exception names.
std::string rule_of(const auto& throwing) {
    try {
        throwing();
    } catch (const InputError& error) {
        return error.code;
    }
    return "none";
}

TEST_P(PictureVariants, RefuseWhatTheScalarTracerRefuses) {
    const accel::SceneView scene = rich_.plain();
    Pictures pictures(device(), scene);
    const Camera good = cameras(scene, 23, 1).at(0);
    Camera blind = good, buried = good;
    blind.target = blind.eye;
    buried.eye.z = -1000;
    TraceOptions mirror = lambert(), cut = lambert();
    mirror.mirror_floor = 1.5f;
    cut.cut_z = 100;
    const struct {
        Camera camera;
        TraceOptions options;
        const char* rule;
    } cases[] = {{blind, lambert(), "R1"}, {buried, lambert(), "R2"}, {good, cut, "R3"}, {good, mirror, "R4"}};
    for (const auto& each : cases) {
        EXPECT_EQ(rule_of([&] { (void)render::trace(scene, each.camera, each.options); }), each.rule);
        EXPECT_EQ(rule_of([&] { (void)pictures.trace(each.camera, each.options); }), each.rule);
    }
    RayStats stats;
    TraceOptions counted = lambert();
    counted.stats = &stats;
    EXPECT_EQ(rule_of([&] { (void)pictures.trace(good, counted); }), "R4");
}

TEST_P(PictureVariants, AreMadeOfASceneThatIsUploadedForOne) {
    const accel::SceneView scene = rich_.view();
    const Camera camera = cameras(scene, 24, 1).at(0);
    TraceOptions options;
    options.tracer = Tracer::Scalar;
    const accel::SerialExecutor one;
    const auto objects = build_object_accel(scene, ObjectAccelKind::Octree, one);
    const ObjectTracer inside = objects->tracer();
    options.objects = &inside;
    test::SamePictures same(device());
    same.add(render::trace(scene, camera, options), trace_on(device(), scene, camera, options), "one");
}

}  // namespace
}  // namespace enfilade::render::cuda
