// Rays on which tracers are compared: they are what their names say.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "accel/locate.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "plans/generate.h"
#include "render/oracle.h"
#include "tools/bench_cells.h"
#include "tools/fill_limit.h"
#include "tools/room_lamps.h"

namespace enfilade::tools {
namespace {

using render::Vec3d;

/// A floor, and the points of it that four views see.
class BenchRays : public testing::Test {
protected:
    static constexpr int side = 128;
    accel::Scene scene_ = [] {
        const modeler::Building building = modeler::convexify(modeler::build(plans::generate({.rooms = 20})));
        return modeler::export_scene(building, modeler::check(building), "{}");
    }();
    const accel::SceneView& view_ = scene_.view();
    std::vector<PreparedView> views_ = prepared(view_, floor_views(view_, 4, side));
    SurfacePoints seen_ = seen_points(view_, views_, side, 1);

    [[nodiscard]] static Vec3d place(const PointColumns& points, std::size_t i) {
        return {points.x[i], points.y[i], points.z[i]};
    }
};

TEST_F(BenchRays, PointsLieOnSurfacesOfTheirCells) {
    ASSERT_GT(seen_.points.x.size(), 50'000u);
    const double band = render::error_band(view_);
    for (std::size_t i = 0; i < seen_.points.x.size(); i += 97) {
        const Vec3d normal = {seen_.normal_x[i], seen_.normal_y[i], seen_.normal_z[i]};
        EXPECT_NEAR(length(normal), 1, 1e-6);
        // A little off the surface lies in the cell, a little behind it does not.
        const Vec3d before = place(seen_.points, i) + 2 * band * normal;
        const Vec3d behind = place(seen_.points, i) - 2 * band * normal;
        const auto cell = accel::locate(view_, {before.x, before.y, before.z});
        EXPECT_TRUE(cell.has_value()) << i;
        EXPECT_FALSE(accel::contains(view_, seen_.points.cell[i], {behind.x, behind.y, behind.z})) << i;
    }
}

TEST_F(BenchRays, SixteenInARowAreNeighboursInTheImage) {
    double near = 0, far = 0;
    for (std::size_t i = 0; i + 2000 < seen_.points.x.size(); i += 160) {
        near += length(place(seen_.points, i + 15) - place(seen_.points, i));
        far += length(place(seen_.points, i + 2000) - place(seen_.points, i));
    }
    EXPECT_LT(near * 5, far);
}

TEST_F(BenchRays, BouncesLeaveTheirSurfacesAsTheCosine) {
    const OwnedRays rays = bounces(seen_);
    ASSERT_EQ(rays.size(), seen_.points.x.size());
    double sum = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const double cosine = double(rays.direction_x[i]) * seen_.normal_x[i] +
                              double(rays.direction_y[i]) * seen_.normal_y[i] +
                              double(rays.direction_z[i]) * seen_.normal_z[i];
        ASSERT_GT(cosine, -1e-6);
        sum += cosine;
    }
    // The mean of a cosine spread as itself.
    EXPECT_NEAR(sum / double(rays.size()), 2.0 / 3, 0.01);
}

TEST_F(BenchRays, ShufflingKeepsEveryRay) {
    const OwnedRays rays = bounces(seen_), mixed = shuffled(rays);
    const auto sorted = [](const OwnedRays& all) {
        std::vector<std::array<float, 4>> numbers;
        for (std::size_t i = 0; i < all.size(); ++i)
            numbers.push_back({all.origins.x[i], all.direction_x[i], all.direction_z[i],
                               static_cast<float>(index(all.origins.cell[i]))});
        std::sort(numbers.begin(), numbers.end());
        return numbers;
    };
    EXPECT_EQ(sorted(rays), sorted(mixed));
    EXPECT_NE(rays.direction_x, mixed.direction_x);
}

TEST_F(BenchRays, LampsHangInTheirCellsAndFewAreForgotten) {
    const RoomLamps lamps = room_lamps(view_, 4096);
    ASSERT_GE(lamps.places.x.size(), 15u);
    for (std::size_t lamp = 0; lamp < lamps.places.x.size(); ++lamp) {
        const Vec3d p = place(lamps.places, lamp);
        EXPECT_TRUE(accel::contains(view_, lamps.places.cell[lamp], {p.x, p.y, p.z}));
    }
    // Every lamp to every hundredth point: those that are seen are on the list of the point's cell.
    PointColumns points;
    for (std::size_t i = 0; i < seen_.points.x.size(); i += 100) {
        points.x.push_back(seen_.points.x[i]);
        points.y.push_back(seen_.points.y[i]);
        points.z.push_back(seen_.points.z[i]);
        points.cell.push_back(seen_.points.cell[i]);
    }
    RoomLamps all = lamps;
    for (auto& list : all.seen_from) {
        list.clear();
        for (std::uint32_t lamp = 0; lamp < lamps.places.x.size(); ++lamp) list.push_back(lamp);
    }
    const OwnedSegments segments = shadow_rays(points, all);
    ASSERT_EQ(segments.size(), points.x.size() * lamps.places.x.size());
    std::vector<std::uint8_t> visible(segments.size());
    render::visible(view_, segments.view(), visible, {.tracer = render::Tracer::Scalar});
    std::size_t seen = 0, forgotten = 0;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (visible[i] == 0) continue;
        ++seen;
        const auto& list = lamps.seen_from[index(segments.from.cell[i])];
        const bool is_listed = std::any_of(list.begin(), list.end(), [&](std::uint32_t lamp) {
            return place(lamps.places, lamp) == place(segments.to, i);
        });
        forgotten += is_listed ? 0 : 1;
    }
    EXPECT_GT(seen, points.x.size() / 2);
    EXPECT_LE(forgotten * 1000, seen);
}

TEST_F(BenchRays, ShadowRaysGoFromPointsToLampsOnTheirLists) {
    const RoomLamps lamps = room_lamps(view_, 512);
    const OwnedSegments segments = shadow_rays(seen_.points, lamps);
    std::size_t expected = 0;
    for (const accel::CellId cell : seen_.points.cell) expected += lamps.seen_from[index(cell)].size();
    EXPECT_EQ(segments.size(), expected);
    // Sixteen neighbours go to one lamp before they go to the next.
    std::size_t changes = 0;
    for (std::size_t i = 1; i < segments.size(); ++i)
        changes += place(segments.to, i) == place(segments.to, i - 1) ? 0 : 1;
    EXPECT_LT(changes * 12, segments.size());
}

TEST_F(BenchRays, TheFillLimitWritesEveryPixel) {
    if (!has_fill_limit()) GTEST_SKIP() << "built without lanes";
    render::Framebuffer image(side, side);
    fill_limit(view_, views_[0], accel::SerialExecutor(), image);
    EXPECT_EQ(std::count(image.rgba.begin(), image.rgba.end(), 0u), 0);
}

TEST(FastestWay, IsTheOneThatTakesLeastTime) {
    volatile double sink = 0;
    const render::EmbreeWay way = fastest_way(render::embree_ways, 3, [&](render::EmbreeWay asked) {
        for (int i = 0; i < (asked.lanes == 8 && asked.coherent ? 1'000 : 300'000); ++i) sink = sink + 1;
    });
    EXPECT_EQ(way.lanes, 8);
    EXPECT_TRUE(way.coherent);
}

}  // namespace
}  // namespace enfilade::tools
