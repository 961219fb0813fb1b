// Numbers of pixels, and their colours.

#include "render/ray_counts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/assemble.h"
#include "base/error.h"
#include "render/colour_scale.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

TEST(ColourScale, GetsLighterEvenly) {
    constexpr int steps = 200;
    const double first = oklab_lightness(scale_colour(0)), last = oklab_lightness(scale_colour(1));
    EXPECT_LT(first, 0.3);
    EXPECT_GT(last, 0.9);
    for (int k = 0; k <= steps; ++k) {
        const double t = double(k) / steps;
        EXPECT_NEAR(oklab_lightness(scale_colour(t)), first + t * (last - first), 1e-3) << t;
    }
}

TEST(ColourScale, StaysWithinWhatScreensShow) {
    for (int k = -10; k <= 110; ++k) {
        const Vec3f c = scale_colour(k / 100.0);
        for (const float channel : {c.x, c.y, c.z}) {
            EXPECT_GE(channel, 0);
            EXPECT_LE(channel, 1);
        }
    }
    EXPECT_EQ(scale_colour(-1), scale_colour(0));
    EXPECT_EQ(scale_colour(7), scale_colour(1));
}

TEST(ColourScale, GreyMeansNoNumber) {
    const Vec3f grey = scale_colour(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(grey.x, grey.y);
    EXPECT_EQ(grey.y, grey.z);
    const Vec3f middle = scale_colour(0.5);
    EXPECT_GT(std::abs(middle.y - middle.x), 0.1f) << "numbers have colours";
}

TEST(RayCounts, CountWhatTheWalkCrosses) {
    // A row of rooms, seen along it: the middle ray crosses all of them and the doors between.
    const accel::Scene scene = accel::assemble(test::synthetic_corridor(10));
    const accel::SceneView& view = scene.view();
    const accel::Cell& first = view.cells[0];
    Camera camera;
    camera.eye = {0, 0, first.z_floor + 1.0};
    for (std::uint32_t k = first.first_section; k < first.first_section + first.section_count; ++k)
        camera.eye = camera.eye + (1.0 / first.section_count) * Vec3d{view.section_x[k], view.section_y[k], 0};
    camera.target = camera.eye + Vec3d{1, 0, 0};
    camera.width = camera.height = 33;
    camera.fov_deg = 90;
    const PixelNumbers cells = count_by_pixel(scene.view(), camera, RayCount::Cells);
    const PixelNumbers sides = count_by_pixel(scene.view(), camera, RayCount::SideTests);
    ASSERT_EQ(cells.of_pixel.size(), 33u * 33u);
    float most = 0;
    for (std::size_t k = 0; k < cells.of_pixel.size(); ++k) {
        EXPECT_GE(cells.of_pixel[k], 1);
        EXPECT_GE(sides.of_pixel[k], 3 * cells.of_pixel[k]);
        most = std::max(most, cells.of_pixel[k]);
    }
    EXPECT_GE(most, 19) << "ten rooms and nine doors";
    EXPECT_LT(cells.of_pixel[0], most) << "upwards, into a ceiling";
}

TEST(RayCounts, RefuseACameraInAWall) {
    const accel::Scene scene = accel::assemble(test::synthetic_corridor(3));
    Camera camera;
    camera.eye = {1000, 0, 0};
    camera.target = {0, 0, 0};
    EXPECT_THROW((void)count_by_pixel(scene.view(), camera, RayCount::Cells), InputError);
    EXPECT_THROW((void)count_by_pixel(scene.view(), camera, RayCount::Cells, 5.0), InputError) << "below the cut";
}

}  // namespace
}  // namespace enfilade::render
