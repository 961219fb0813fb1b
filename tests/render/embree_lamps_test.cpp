// Pictures lit by lamps through Embree: the same light as the scalar tracer's, however Embree is asked.

#include <gtest/gtest.h>

#include "render/embree_lamps.h"
#include "render/trace.h"
#include "tests/support/lit_office.h"

namespace enfilade::render {
namespace {

using test::lit_office;

constexpr int side = 128;

/// A scene with its light trees, a camera in it, and what Embree is given.
struct LitView {
    accel::Scene scene = lit_office();
    accel::SerialExecutor one;
    accel::LightTrees trees = accel::build_light_trees(scene.view(), {}, one);
    LampLists lists = lamp_lists(trees.view());
    EmbreeReference embree{scene.view()};
    CameraFrame frame;
    accel::CellId start;
    std::vector<std::uint32_t> cells = std::vector<std::uint32_t>(std::size_t{side} * side);

    LitView() {
        const accel::Light& lamp = scene.view().lights[2];
        Camera camera;
        camera.eye = {lamp.position[0] - 0.5, lamp.position[1], 1.5};
        camera.target = {lamp.position[0] + 1, lamp.position[1] + 0.4, 1.2};
        camera.width = camera.height = side;
        frame = make_frame(camera);
        start = start_cell(scene.view(), frame);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Vec3f along = frame.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                const RayHit hit = trace_ray(
                    scene.view(), {vec_cast<double>(frame.origin), vec_cast<double>(along), start}, Precision::Float);
                cells[static_cast<std::size_t>(y * side + x)] = static_cast<std::uint32_t>(hit.cell);
            }
    }
    [[nodiscard]] Framebuffer ours(LampSearch search) const {
        const Lamps lamps = {trees.view(), search, exposure};
        Framebuffer image(side, side);
        trace_lambert(scene.view(), frame, start, {.tracer = Tracer::Scalar, .lamps = &lamps}, one, image);
        return image;
    }
    [[nodiscard]] Framebuffer theirs(const LampLists& asked, const EmbreeLitWay& way, const SeenPlaces* seen) const {
        Framebuffer image(side, side);
        embree.trace_lit(frame, {scene.view().lights, &asked, exposure, cells.data(), seen}, way, one, image);
        return image;
    }
    static constexpr float exposure = 0.05f;
};

/// Pixels with a channel that differs by more than a step.
int unlike(const Framebuffer& a, const Framebuffer& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        bool differs = false;
        for (int shift = 0; shift < 24; shift += 8)
            differs = differs || std::abs(static_cast<int>(a.rgba[i] >> shift & 255) -
                                          static_cast<int>(b.rgba[i] >> shift & 255)) > 1;
        count += differs ? 1 : 0;
    }
    return count;
}

/// Pixels along the borders of faces and shadows, of 16,384.
constexpr int few = 40;

TEST(EmbreeLamps, ListsHoldEachLampOnce) {
    const LitView view;
    ASSERT_EQ(view.lists.offsets.size(), view.scene.view().cells.size() + 1);
    for (std::size_t c = 0; c + 1 < view.lists.offsets.size(); ++c)
        for (std::uint32_t k = view.lists.offsets[c]; k + 1 < view.lists.offsets[c + 1]; ++k)
            EXPECT_LT(view.lists.lamps[k], view.lists.lamps[k + 1]);
    EXPECT_LT(view.lists.lamps.size(), all_lamps(view.scene.view()).lamps.size());
}

TEST(EmbreeLamps, LightAsTheScalarTracerDoesInEveryWay) {
    const LitView view;
    const Framebuffer ours = view.ours(LampSearch::Naive);
    EXPECT_GT(unlike(ours, Framebuffer(side, side)), side * side / 2);
    for (const EmbreeLitWay& way : embree_lit_ways())
        EXPECT_LE(unlike(ours, view.theirs(view.lists, way, nullptr)), few) << text(way);
}

TEST(EmbreeLamps, SeeTheSameByListsAndByAllLamps) {
    const LitView view;
    const EmbreeLitWay way = {{.lanes = 16}};
    EXPECT_LE(unlike(view.theirs(view.lists, way, nullptr), view.theirs(all_lamps(view.scene.view()), way, nullptr)),
              4);
}

TEST(EmbreeLamps, LightKnownPlacesAsTheyLightPictures) {
    const LitView view;
    const SeenPlaces seen = view.embree.seen_places(view.frame, side, side, view.one);
    EXPECT_EQ(seen.lit_count, std::size_t{side} * side);
    for (const int lanes : {1, 8, 16}) {
        const EmbreeLitWay way = {{.lanes = lanes}};
        EXPECT_LE(unlike(view.theirs(view.lists, way, nullptr), view.theirs(view.lists, way, &seen)), 4) << lanes;
    }
}

TEST(EmbreeLamps, AreDarkWithoutLists) {
    const LitView view;
    LampLists none;
    none.offsets.assign(view.scene.view().cells.size() + 1, 0);
    const Framebuffer dark = view.theirs(none, {{.lanes = 16}}, nullptr);
    for (const std::uint32_t pixel : dark.rgba) ASSERT_EQ(pixel, 0xff000000u);
}

}  // namespace
}  // namespace enfilade::render
