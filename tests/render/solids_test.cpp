// Walls and slabs as prisms, and passages that bear their names.

#include "render/solids.h"

#include <gtest/gtest.h>

#include <limits>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "render/crossings.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using accel::Label;
using accel::SpaceId;

constexpr double infinite = std::numeric_limits<double>::infinity();

Ray<double> ray_of(Vec3d origin, Vec3d direction) {
    Ray<double> ray;
    EXPECT_TRUE(make_ray(origin, direction, ray));
    return ray;
}

std::vector<SolidStretch> met(const Solids& solids, Vec3d origin, Vec3d direction, double from = 0,
                              double to = infinite) {
    std::vector<SolidStretch> found = {{7, 7, 7}};
    solids.along(ray_of(origin, direction), from, to, found);
    return found;
}

/// A U of walls, open upwards on the plan, and a slab on it.
Solids court() {
    return Solids({{0, 8, 0, 3, Label::Wall, SpaceId{4}}, {8, 4, 3, 3.5, Label::Slab, SpaceId{5}}},
                  {{0, 0}, {6, 0}, {6, 5}, {5, 5}, {5, 1}, {1, 1}, {1, 5}, {0, 5}, {0, 0}, {6, 0}, {6, 5}, {0, 5}});
}

TEST(Solids, ThatAreConcaveAreMetSeveralTimes) {
    const std::vector<SolidStretch> found = met(court(), {-1, 3, 1}, {1, 0, 0});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0].enter, 1, 1e-12);
    EXPECT_NEAR(found[0].leave, 2, 1e-12);
    EXPECT_NEAR(found[1].enter, 6, 1e-12);
    EXPECT_NEAR(found[1].leave, 7, 1e-12);
}

TEST(Solids, AreCutByTheRangeAskedFor) {
    const std::vector<SolidStretch> found = met(court(), {-1, 3, 1}, {1, 0, 0}, 1.5, 6.25);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].enter, 1.5);
    EXPECT_EQ(found[1].leave, 6.25);
    EXPECT_TRUE(met(court(), {-1, 3, 1}, {1, 0, 0}, 2.5, 5.5).empty());
}

TEST(Solids, AreMetFromBelowOneAfterTheOther) {
    const std::vector<SolidStretch> found = met(court(), {0.5, 3, -1}, {0, 0, 2});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].prism, 0u);
    EXPECT_EQ(found[1].prism, 1u);
    EXPECT_EQ(found[0].leave, found[1].enter);
    EXPECT_EQ(met(court(), {3, 3, -1}, {0, 0, 2}).size(), 1u);  // the court: the slab alone
    EXPECT_TRUE(met(court(), {9, 3, -1}, {0, 0, 2}).empty());
}

// Through corners and along sides: in as often as out, whichever way the tie falls.
TEST(Solids, AlongTheirSidesAreMetWholeOrNotAtAll) {
    for (const double y : {0.0, 1.0, 5.0})
        for (const double dx : {1.0, -1.0}) {
            double length = 0;
            for (const SolidStretch& stretch : met(court(), {dx > 0 ? -1.0 : 7.0, y, 1}, {dx, 0, 0}))
                length += stretch.leave - stretch.enter;
            EXPECT_TRUE(length == 0 || std::abs(length - 6) < 1e-9 || std::abs(length - 2) < 1e-9)
                << y << ' ' << length;
        }
}

TEST(Solids, OfNoBuildingAreNeverMet) { EXPECT_TRUE(met(Solids(), {0, 0, 0}, {1, 1, 1}).empty()); }

/// The gap between two rooms of an office, told apart into the two leaves of a wall and what lies between them.
TEST(Solids, GiveTheirNamesToPassages) {
    const accel::Scene scene = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 2, .doors = false}));
    const accel::SceneView& view = scene.view();
    const RayQuery ray = {{2, 3, 1}, {1, 0, 0}, *accel::locate(view, {2, 3, 1}), 4};
    const PassageTable nameless = all_crossings(view, {&ray, 1});
    ASSERT_EQ(nameless.passages.size(), 3u);
    const Passage gap = nameless.passages[1];
    const double x0 = 2 + gap.enter, x1 = 2 + gap.leave, middle = 0.5 * (x0 + x1);
    const auto prism = [](std::uint32_t first, Label label, std::uint32_t space) {
        return SolidPrism{first, 4, 0, 3, label, SpaceId{space}};
    };
    // The left half in two pieces of one wall; the right half of another.
    const Solids solids({prism(0, Label::Wall, 1), prism(4, Label::Wall, 1), prism(8, Label::Slab, 2)}, {{x0, 0},
                                                                                                         {x0 + 0.01, 0},
                                                                                                         {x0 + 0.01, 6},
                                                                                                         {x0, 6},
                                                                                                         {x0 + 0.01, 0},
                                                                                                         {middle, 0},
                                                                                                         {middle, 6},
                                                                                                         {x0 + 0.01, 6},
                                                                                                         {middle, 0},
                                                                                                         {x1, 0},
                                                                                                         {x1, 6},
                                                                                                         {middle, 6}});
    const PassageTable named = all_crossings(view, {&ray, 1}, {.solids = &solids});
    ASSERT_EQ(named.passages.size(), 4u);
    const Passage &first = named.passages[1], &second = named.passages[2];
    EXPECT_EQ(first.label, Label::Wall);
    EXPECT_EQ(first.space, SpaceId{1});
    EXPECT_EQ(second.label, Label::Slab);
    EXPECT_EQ(second.space, SpaceId{2});
    EXPECT_NEAR(first.length(), 0.5 * gap.length(), 1e-6);
    EXPECT_EQ(first.enter, gap.enter);
    EXPECT_EQ(first.leave, second.enter);
    EXPECT_EQ(second.leave, gap.leave);
    EXPECT_EQ(first.face_in, gap.face_in);
    EXPECT_EQ(first.face_out, none<accel::SourceFaceId>);
    EXPECT_EQ(first.left, Border::Inside);
    EXPECT_EQ(second.entered, Border::Inside);
    EXPECT_EQ(second.face_out, gap.face_out);
}

}  // namespace
}  // namespace enfilade::render
