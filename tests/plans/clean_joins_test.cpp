#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "plans/generate.h"
#include "plans/layout.h"
#include "tests/plans/clean_support.h"

namespace enfilade::plans {
namespace {

using testing::add_box;
using testing::codes_of;
using testing::one_room;
using testing::opening;
using testing::opening_of;
using testing::plan_of;
using testing::storey;
using testing::wall;
using testing::wall_of;

std::size_t closed_rooms(const Plan& plan) { return arrange(plan).storeys[0].rooms.size(); }

TEST(CleanJoins, CloseTheCornersOfARoom) {
    Plan plan = plan_of({});
    // Four thin walls that miss each other by 2 to 4 cm: the room leaks.
    plan.storeys[0].walls = {wall("s", {0.03, 0}, {4, 0}, 0.01), wall("e", {4.02, 0.03}, {4.02, 3}, 0.01),
                             wall("n", {4, 3.02}, {0, 3.02}, 0.01), wall("w", {0, 3}, {0, 0.02}, 0.01)};
    ASSERT_EQ(closed_rooms(plan), 0u);
    const Plan cleaned = clean(plan);
    EXPECT_EQ(closed_rooms(cleaned), 1u);
    for (const Finding& finding : cleaned.findings) EXPECT_EQ(finding.code, "P215");
    const auto& walls = cleaned.storeys[0].walls;
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(walls[k].end, walls[(k + 1) % 4].start);
}

TEST(CleanJoins, MeetWhereTheWallsWouldCross) {
    const Plan cleaned = clean(plan_of({wall("s", {0, 0}, {3.97, 0}, 0.01), wall("e", {4, 0.04}, {4, 3}, 0.01)}));
    EXPECT_EQ(codes_of(cleaned), "P215 P215");
    EXPECT_EQ(wall_of(cleaned, "s")->end, (Point{4, 0}));
    EXPECT_EQ(wall_of(cleaned, "e")->start, (Point{4, 0}));
}

TEST(CleanJoins, GoHalfWayBetweenWallsInALine) {
    const Plan cleaned = clean(plan_of({wall("a", {0, 0}, {2, 0}), wall("b", {2.03, 0}, {4, 0})}));
    ASSERT_EQ(codes_of(cleaned), "P215 P215");
    EXPECT_NEAR(cleaned.findings[0].moved_mm, 15, 1e-9);
    EXPECT_NEAR(wall_of(cleaned, "a")->end.x, 2.015, 1e-12);
    EXPECT_EQ(wall_of(cleaned, "a")->end, wall_of(cleaned, "b")->start);
}

TEST(CleanJoins, LeaveWiderGapsOpen) {
    const Plan plan = plan_of({wall("a", {0, 0}, {2, 0}), wall("b", {2.06, 0}, {4, 0})});
    EXPECT_EQ(codes_of(clean(plan)), "");
    CleanOptions wide;
    wide.join_gap = 0.07;
    EXPECT_EQ(codes_of(clean(plan, wide)), "P215 P215");
}

TEST(CleanJoins, AWallThatStopsShortReachesTheAxis) {
    Plan plan = one_room();
    // The inner face of the north wall is at y = 2.875.
    plan.storeys[0].walls.push_back(wall("m", {2, 0}, {2, 2.845}, 0.125));
    ASSERT_EQ(closed_rooms(plan), 1u);
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P216");
    EXPECT_NEAR(wall_of(cleaned, "m")->end.y, 3, 1e-9);
    EXPECT_NEAR(cleaned.findings[0].moved_mm, 155, 1e-6);
    EXPECT_NE(cleaned.findings[0].sentence.find("ended 30 mm short"), std::string::npos);
    EXPECT_EQ(closed_rooms(cleaned), 2u);
}

TEST(CleanJoins, AWallThatStopsInsideAnotherIsFine) {
    Plan plan = one_room();
    plan.storeys[0].walls.push_back(wall("m", {2, 0.1}, {2, 2.9}, 0.125));
    EXPECT_EQ(codes_of(clean(plan)), "");
}

TEST(CleanJoins, StaggeredWallsOnBothSidesOfAWallAreFine) {
    Plan plan = one_room();
    plan.storeys[0].walls.push_back(wall("m", {2, 0}, {2, 3}, 0.125));
    plan.storeys[0].walls.push_back(wall("out", {2.03, 0}, {2.03, -3}, 0.125));
    EXPECT_EQ(codes_of(clean(plan)), "");
}

TEST(CleanJoins, ParallelWallsStayApart) {
    // Two boxes within each other, 3 cm apart: their corners are near, but each is tight.
    Plan plan = plan_of({});
    add_box(plan.storeys[0], "", 4, 3);
    for (Wall& w : plan.storeys[0].walls) w.thickness = 0.01;
    plan.storeys[0].walls.push_back(wall("is", {0.03, 0.03}, {3.97, 0.03}, 0.01));
    plan.storeys[0].walls.push_back(wall("ie", {3.97, 0.03}, {3.97, 2.97}, 0.01));
    plan.storeys[0].walls.push_back(wall("in", {3.97, 2.97}, {0.03, 2.97}, 0.01));
    plan.storeys[0].walls.push_back(wall("iw", {0.03, 2.97}, {0.03, 0.03}, 0.01));
    EXPECT_EQ(codes_of(clean(plan)), "");
    EXPECT_EQ(codes_of(clean(plan_of({wall("a", {0, 0}, {4, 0}, 0.01), wall("b", {0, 0.03}, {4, 0.03}, 0.01)}))), "");
}

TEST(CleanJoins, ObliqueWallsAreExtendedAlongThemselves) {
    const Plan cleaned = clean(plan_of({wall("host", {0, 0}, {6, 0}), wall("slanted", {3, 2}, {1.15, 0.15}, 0.1)}));
    ASSERT_EQ(codes_of(cleaned), "P216");
    EXPECT_NEAR(wall_of(cleaned, "slanted")->end.x, 1, 1e-9);
    EXPECT_NEAR(wall_of(cleaned, "slanted")->end.y, 0, 1e-9);
}

TEST(CleanJoins, ArcsAreExtendedAlongTheirCircle) {
    // A quarter of a circle of 2 m around (0, 0), from (2, 0) up to 4 cm short of the face of a wall along x = 0.
    Plan plan = plan_of({wall("host", {0, -3}, {0, 3}, 0.2), wall("arc", {2, 0}, {}, 0.1)});
    const double extent = std::acos(0.14 / 2);
    plan.storeys[0].walls[1].arc_extent = extent;
    plan.storeys[0].walls[1].end = {2 * std::cos(extent), 2 * std::sin(extent)};
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P216");
    const Wall& arc = *wall_of(cleaned, "arc");
    EXPECT_NEAR(arc.end.x, 0, 1e-9);
    EXPECT_NEAR(arc.end.y, 2, 1e-9);
    EXPECT_NEAR(arc.arc_extent, 1.5707963267948966, 1e-9);
}

TEST(CleanJoins, WallsReachArcs) {
    Plan plan = plan_of({wall("arc", {2, 0}, {-2, 0}, 0.2), wall("spoke", {0, 0}, {0, 1.87}, 0.1)});
    plan.storeys[0].walls[0].arc_extent = 3.141592653589793;
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P216");
    EXPECT_NEAR(wall_of(cleaned, "spoke")->end.y, 2, 1e-9);
}

TEST(CleanJoins, OpeningsStayInPlaceWhenTheStartMoves) {
    Plan plan = plan_of({wall("host", {0, -3}, {0, 3}, 0.2), wall("m", {0.13, 0}, {4, 0}, 0.1)});
    plan.storeys[0].openings.push_back(opening("door", OpeningKind::Door, "m", 1, 0.9, 0, 2));
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P216");
    EXPECT_NEAR(wall_of(cleaned, "m")->start.x, 0, 1e-9);
    EXPECT_NEAR(opening_of(cleaned, "door")->offset, 1.13, 1e-9);
}

TEST(CleanJoins, WallsAreDrawnThroughTheGapInWhichADoorStands) {
    Plan plan = plan_of({});
    // The south wall is two walls with a gap of 1 m between them, and a door bound to the first.
    plan.storeys[0].walls = {wall("s1", {0, 0}, {1, 0}), wall("s2", {2, 0}, {4, 0}), wall("e", {4, 0}, {4, 3}),
                             wall("n", {4, 3}, {0, 3}), wall("w", {0, 3}, {0, 0})};
    plan.storeys[0].openings.push_back(opening("door", OpeningKind::Door, "s1", 1.5, 0.9, 0, 2));
    ASSERT_EQ(closed_rooms(plan), 0u);
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P219");
    EXPECT_EQ(wall_of(cleaned, "s1")->end, (Point{2, 0}));
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "door")->offset, 1.5);
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "door")->width, 0.9);
    EXPECT_EQ(closed_rooms(cleaned), 1u);
}

TEST(CleanJoins, AGapBeforeTheStartIsClosedToo) {
    Plan plan = plan_of({wall("s1", {0, 0}, {1, 0}), wall("s2", {2, 0}, {4, 0})});
    plan.storeys[0].openings.push_back(opening("door", OpeningKind::Door, "s2", -0.5, 0.9, 0, 2));
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P219");
    EXPECT_EQ(wall_of(cleaned, "s2")->start, (Point{1, 0}));
    EXPECT_DOUBLE_EQ(opening_of(cleaned, "door")->offset, 0.5);
}

TEST(CleanJoins, AnOfficeOfThinWallsDrawnByHandGetsAllItsRoomsBack) {
    Plan plan = generate({.rooms = 200, .curved = 0.2, .oblique = 0.2});
    std::mt19937 random(1);
    const auto shaken = [&](double x) { return x + (double(random() % 3001) - 1500) / 100000; };
    for (Wall& w : plan.storeys[0].walls) {
        w.thickness = 0.01;
        for (Point* p : {&w.start, &w.end}) *p = {shaken(p->x), shaken(p->y)};
    }
    ASSERT_LT(closed_rooms(plan), 180u);
    EXPECT_EQ(closed_rooms(clean(plan)), 200u);
}

TEST(CleanJoins, FarFromTheOriginTheRepairsAreTheSame) {
    Plan plan = one_room();
    plan.storeys[0].walls.push_back(wall("m", {2, 0}, {2, 2.845}, 0.125));
    for (Wall& w : plan.storeys[0].walls)
        for (Point* p : {&w.start, &w.end}) *p = {p->x + 1048576, p->y - 4194304};
    const Plan cleaned = clean(plan);
    ASSERT_EQ(codes_of(cleaned), "P216");
    EXPECT_NEAR(wall_of(cleaned, "m")->end.y, 3 - 4194304.0, 1e-6);
}

}  // namespace
}  // namespace enfilade::plans
