// Stretches of wall, what is between them, and where they end.

#include "plans/dxf/wall_runs.h"

#include "tests/plans/dxf/dxf_text.h"
#include "tests/plans/dxf/wall_strokes.h"

namespace enfilade::plans {
namespace {

using namespace wall_strokes;
using Axes = std::vector<Axis>;

/// Two walls of 0.2 m on one axis, from 0 to 3 and from 4 to 7, their ends closed by lines across.
Strokes broken_wall(double from = 3, double to = 4) { return box({0, 0}, {from, 0.2}) + box({to, 0}, {7, 0.2}); }

/// Of the one run there is: its openings as "door 3-4", from left to right.
std::vector<std::string> openings_of(const WallRun& run) {
    std::vector<std::string> found;
    for (const RunOpening& o : run.openings) {
        const bool backward = run.start.x > run.end.x;
        const double a = backward ? run.start.x - o.u1 : run.start.x + o.u0;
        const double b = backward ? run.start.x - o.u0 : run.start.x + o.u1;
        char text[64];
        std::snprintf(text, sizeof text, "%s %.2f-%.2f",
                      o.kind == OpeningKind::Door     ? "door"
                      : o.kind == OpeningKind::Window ? "window"
                                                      : "opening",
                      a, b);
        found.emplace_back(text);
    }
    std::sort(found.begin(), found.end());
    return found;
}

using Found = std::vector<std::string>;

/// Of the one wall along y = 0.1.
Found openings_along(const std::vector<WallRun>& runs) {
    Found found = {"no wall"};
    for (const WallRun& run : runs)
        if (std::abs(run.start.y - 0.1) < 0.01 && std::abs(run.end.y - 0.1) < 0.01) found = openings_of(run);
    return found;
}

/// \pre one wall from 0 to 7
Found openings_in(const Strokes& strokes) {
    const std::vector<WallRun> runs = runs_of(strokes);
    EXPECT_EQ(axes_of(runs), (Axes{{{0, 0.1}, {7, 0.1}, 0.2}}));
    return runs.empty() ? Found{} : openings_of(runs[0]);
}

TEST(WallRuns, AGapWithASwingIsADoor) {
    EXPECT_EQ(openings_in(broken_wall() + Strokes{arc({3, 0.2}, 1, 0, 90, Role::Door)}), (Found{"door 3.00-4.00"}));
    // Hinge on the other side, the arc drawn clockwise, and swings on a layer for doors and windows alike.
    EXPECT_EQ(openings_in(broken_wall() + Strokes{arc({4, 0}, 1, 270, 180, Role::Opening)}), (Found{"door 3.00-4.00"}));
}

TEST(WallRuns, AGapWithTwoSwingsIsOneDoor) {
    EXPECT_EQ(openings_in(broken_wall(3, 5) +
                          Strokes{arc({3, 0.2}, 1, 0, 90, Role::Door), arc({5, 0.2}, 1, 180, 90, Role::Door)}),
              (Found{"door 3.00-5.00"}));
}

TEST(WallRuns, AGapWithLinesOfWindowsIsAWindow) {
    EXPECT_EQ(openings_in(broken_wall() + faces({3, 0.05}, {4, 0.15}, Role::Window)), (Found{"window 3.00-4.00"}));
}

TEST(WallRuns, AGapNeedsNoJambsWhereSomethingIsDrawn) {
    EXPECT_EQ(openings_in(faces({0, 0}, {3, 0.2}) + faces({4, 0}, {7, 0.2}) + faces({3, 0}, {4, 0.2}, Role::Window)),
              (Found{"window 3.00-4.00"}));
}

TEST(WallRuns, AGapBetweenJambsIsAnOpening) { EXPECT_EQ(openings_in(broken_wall()), (Found{"opening 3.00-4.00"})); }

TEST(WallRuns, AGapWithoutAnythingIsTheEndOfTwoWalls) {
    EXPECT_EQ(axes_of(runs_of(faces({0, 0}, {3, 0.2}) + faces({4, 0}, {7, 0.2}))),
              (Axes{{{0, 0.1}, {3, 0.1}, 0.2}, {{4, 0.1}, {7, 0.1}, 0.2}}));
}

TEST(WallRuns, AWideGapBetweenJambsIsTheEndOfTwoWalls) {
    EXPECT_EQ(runs_of(box({0, 0}, {3, 0.2}) + box({5.9, 0}, {9, 0.2})).size(), 1u);
    EXPECT_EQ(runs_of(box({0, 0}, {3, 0.2}) + box({6.1, 0}, {9, 0.2})).size(), 2u);
    // A shop's front is wider, but drawn.
    const Strokes front = box({0, 0}, {3, 0.2}) + box({9, 0}, {12, 0.2}) + faces({3, 0.05}, {9, 0.15}, Role::Window);
    const std::vector<WallRun> runs = runs_of(front);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(openings_of(runs[0]), (Found{"window 3.00-9.00"}));
}

TEST(WallRuns, TwoWallsOnBothSidesOfACorridorAreTwo) {
    // Walls from 0 to 3 and from 5.2 to 8 end on walls across, between which a corridor of 1.8 m runs.
    const Strokes across = {stroke({3, -3}, {3, 0}),     stroke({3, 0.2}, {3, 3}),     stroke({3.2, -3}, {3.2, 3}),
                            stroke({5.2, -3}, {5.2, 0}), stroke({5.2, 0.2}, {5.2, 3}), stroke({5, -3}, {5, 3})};
    const std::vector<WallRun> runs = runs_of(faces({0, 0}, {3, 0.2}) + faces({5.2, 0}, {8, 0.2}) + across);
    EXPECT_EQ(axes_of(runs), (Axes{{{0, 0.1}, {3.1, 0.1}, 0.2},
                                   {{3.1, -3}, {3.1, 3}, 0.2},
                                   {{5.1, -3}, {5.1, 3}, 0.2},
                                   {{5.1, 0.1}, {8, 0.1}, 0.2}}));
    for (const WallRun& run : runs) EXPECT_TRUE(run.openings.empty());
}

TEST(WallRuns, APocketDoorReachesIntoTheWall) {
    EXPECT_EQ(openings_in(broken_wall() + box({2.6, 0.08}, {3.7, 0.12}, Role::Door)), (Found{"door 3.00-4.00"}));
}

TEST(WallRuns, PanesOnPlainLayersAreAWindowToTheOpenAndAHoleInside) {
    const Strokes plain = broken_wall() + faces({3, 0.05}, {4, 0.15}, Role::Unknown);
    EXPECT_EQ(openings_in(plain), (Found{"window 3.00-4.00"}));
    // Walls on both sides: rooms.
    const std::vector<WallRun> inside = runs_of(plain + box({0, 3}, {7, 3.2}) + box({0, -3.2}, {7, -3}));
    ASSERT_EQ(inside.size(), 3u);
    EXPECT_EQ(openings_along(inside), (Found{"opening 3.00-4.00"}));
}

TEST(WallRuns, PanesOfALayerForBothAreAWindowToTheOpenAndADoorInside) {
    const Strokes sliding = broken_wall() + faces({3, 0.05}, {4, 0.15}, Role::Opening);
    EXPECT_EQ(openings_in(sliding), (Found{"window 3.00-4.00"}));
    EXPECT_EQ(openings_along(runs_of(sliding + box({0, 3}, {7, 3.2}) + box({0, -3.2}, {7, -3}))),
              (Found{"door 3.00-4.00"}));
}

TEST(WallRuns, DoorsAndWindowsOverAWallThatGoesOnAreInIt) {
    const Strokes wall = box({0, 0}, {7, 0.2});
    EXPECT_EQ(openings_in(wall + Strokes{arc({3, 0.1}, 1, 0, 90, Role::Door)}), (Found{"door 3.00-4.00"}));
    EXPECT_EQ(openings_in(wall + faces({5, 0.05}, {6, 0.15}, Role::Window)), (Found{"window 5.00-6.00"}));
    EXPECT_EQ(openings_in(wall + Strokes{arc({3, 0.1}, 1, 0, 90, Role::Door)} + faces({5, 0}, {6, 0.2}, Role::Window)),
              (Found{"door 3.00-4.00", "window 5.00-6.00"}));
}

TEST(WallRuns, WhatIsDrawnAsideOfAWallIsNotInIt) {
    const Strokes wall = box({0, 0}, {7, 0.2});
    EXPECT_TRUE(openings_in(wall + faces({5, 0.5}, {6, 0.6}, Role::Window)).empty());
    EXPECT_TRUE(openings_in(wall + Strokes{arc({3, 0.5}, 1, 0, 90, Role::Door)}).empty());
    EXPECT_TRUE(openings_in(wall + Strokes{arc({3, 0.1}, 3, 0, 90, Role::Door)}).empty());  // no leaf of 3 m
}

TEST(WallRuns, MirroredAndTurnedDoorBlocksAreDoors) {
    using namespace dxf_text;
    // Hinge at the base point, the leaf 1 m, as wide as the gap.
    const std::string leaf =
        block("leaf", line(0, 0, 0, 1, "A-DOOR") +
                          entity("ARC", {{8, "A-DOOR"}, {10, 0}, {20, 0}, {40, 1}, {50, 0}, {51, 90}}));
    struct Inserted {
        double x, y, scale_x, scale_y, turned;
    };
    for (const Inserted& i : {Inserted{3, 0.2, 1, 1, 0}, {4, 0.2, -1, 1, 0}, {3, 0, 1, -1, 0}, {4, 0, 1, 1, 180}}) {
        SCOPED_TRACE(std::to_string(i.x) + ' ' + std::to_string(i.scale_x) + ' ' + std::to_string(i.scale_y));
        const Drawing drawing = read(File{
            entity("INSERT",
                   {{8, "0"}, {2, "leaf"}, {10, i.x}, {20, i.y}, {41, i.scale_x}, {42, i.scale_y}, {50, i.turned}}),
            leaf});
        const Roles roles = assign_roles(drawing, {});
        EXPECT_EQ(openings_in(broken_wall() + sheet_strokes(drawing, roles, 1)), (Found{"door 3.00-4.00"}));
    }
}

TEST(WallRuns, RulesGiveSillAndHead) {
    RoleRule rule;
    rule.sill = 0.6;
    rule.head = 2.3;
    for (const Strokes& wall : {broken_wall(), box({0, 0}, {7, 0.2})}) {
        Strokes panes = faces({3, 0.05}, {4, 0.15}, Role::Window);
        for (SheetStroke& s : panes) s.rule = &rule;
        const std::vector<WallRun> runs = runs_of(wall + panes);
        ASSERT_EQ(runs.size(), 1u);
        ASSERT_EQ(runs[0].openings.size(), 1u);
        EXPECT_EQ(runs[0].openings[0].sill, 0.6);
        EXPECT_EQ(runs[0].openings[0].head, 2.3);
    }
}

TEST(WallRuns, WallsOfAnElbowMeetOnTheirAxes) {
    const Strokes corner = {stroke({0, 0}, {5, 0}), stroke({0.2, 0.2}, {5, 0.2}), stroke({0, 0}, {0, 4}),
                            stroke({0.2, 0.2}, {0.2, 4})};
    const std::vector<WallRun> runs = runs_of(corner);
    EXPECT_EQ(axes_of(runs), (Axes{{{0.1, 0.1}, {0.1, 4}, 0.2}, {{0.1, 0.1}, {5, 0.1}, 0.2}}));
    for (const WallRun& run : runs) EXPECT_NE(run.start_joined, run.end_joined);
}

TEST(WallRuns, ATeeIsAWallThatGoesOnAndOneThatReachesItsAxis) {
    const Strokes tee = {stroke({0, 4.2}, {10, 4.2}), stroke({0, 4}, {4.9, 4}), stroke({5.1, 4}, {10, 4}),
                         stroke({4.9, 0}, {4.9, 4}), stroke({5.1, 0}, {5.1, 4})};
    EXPECT_EQ(axes_of(runs_of(tee)), (Axes{{{0, 4.1}, {10, 4.1}, 0.2}, {{5, 0}, {5, 4.1}, 0.2}}));
}

TEST(WallRuns, CrossingWallsGoOn) {
    Strokes strokes;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1}) {
            strokes.push_back(stroke({0.1 * x, 0.1 * y}, {3 * x, 0.1 * y}));
            strokes.push_back(stroke({0.1 * x, 0.1 * y}, {0.1 * x, 3 * y}));
        }
    EXPECT_EQ(axes_of(runs_of(strokes)), (Axes{{{-3, 0}, {3, 0}, 0.2}, {{0, -3}, {0, 3}, 0.2}}));
}

TEST(WallRuns, WallsOfOtherThicknessOrHeightAreOthers) {
    EXPECT_EQ(runs_of(box({0, 0}, {3, 0.2}) + box({3, -0.1}, {7, 0.3})).size(), 2u);
    EXPECT_EQ(runs_of(faces({0, 0}, {3, 0.2}) + faces({3, 0}, {7, 0.2}, Role::LowWall)).size(), 2u);
    EXPECT_EQ(runs_of(faces({0, 0}, {3, 0.2}) + faces({3, 0}, {7, 0.2})).size(), 1u);
}

/// A wall from 0 to 3 towards one across whose near face is at 3.9; its axis at 4.
Strokes wall_towards_another() { return box({0, 0}, {3, 0.2}) + box({3.9, -3}, {4.1, 3}); }

TEST(WallRuns, ADoorLeadsTheWallToTheNextOne) {
    const std::vector<WallRun> runs = runs_of(wall_towards_another() + Strokes{arc({3, 0.2}, 0.9, 0, 90, Role::Door)});
    EXPECT_EQ(axes_of(runs), (Axes{{{0, 0.1}, {4, 0.1}, 0.2}, {{4, -3}, {4, 3}, 0.2}}));
    EXPECT_EQ(openings_along(runs), (Found{"door 3.00-3.90"}));
}

TEST(WallRuns, TheWindowOfAnotherWallLeadsNoWallIntoIt) {
    // A thin wall comes up to a corner of thick ones, whose window is on its axis.
    const Strokes strokes = faces({0, 0}, {1, 0.3}) + faces({2.5, 0}, {4, 0.3}) + faces({3.7, 0.3}, {4, 4}) +
                            Strokes{stroke({4, 0}, {4, 0.3}), stroke({0, 0}, {0, 0.3})} +
                            faces({1, 0.1}, {2.5, 0.2}, Role::Window) + faces({4.2, 0.075}, {7, 0.225});
    std::size_t windows = 0;
    for (const WallRun& run : runs_of(strokes)) windows += run.openings.size();
    EXPECT_EQ(windows, 1u);
}

TEST(WallRuns, NothingDrawnLeadsTheWallNowhere) {
    EXPECT_EQ(axes_of(runs_of(wall_towards_another())), (Axes{{{0, 0.1}, {3, 0.1}, 0.2}, {{4, -3}, {4, 3}, 0.2}}));
}

TEST(WallRuns, ADoorAtTheBeginningMovesTheOpeningsAlong) {
    // The next wall lies before the start: openings are measured from there.
    const Strokes strokes = box({-1.1, -3}, {-0.9, 3}) + box({0, 0}, {7, 0.2}) +
                            Strokes{arc({0, 0.2}, 0.9, 90, 180, Role::Door)} +
                            faces({5, 0.05}, {6, 0.15}, Role::Window);
    const std::vector<WallRun> runs = runs_of(strokes);
    EXPECT_EQ(axes_of(runs), (Axes{{{-1, -3}, {-1, 3}, 0.2}, {{-1, 0.1}, {7, 0.1}, 0.2}}));
    EXPECT_EQ(openings_along(runs), (Found{"door -0.90-0.00", "window 5.00-6.00"}));
}

TEST(WallRuns, OrderAndDirectionOfTheStrokesDoNotMatter) {
    Strokes strokes = broken_wall() + wall_towards_another() + faces({3, 0.05}, {4, 0.15}, Role::Window) +
                      Strokes{arc({6, 5}, 0.9, 0, 90, Role::Door)} + box({0, 5}, {7, 5.1});
    const Axes found = axes_of(runs_of(strokes));
    std::reverse(strokes.begin(), strokes.end());
    for (SheetStroke& s : strokes) std::swap(s.stroke.a, s.stroke.b), s.stroke.bulge = -s.stroke.bulge;
    EXPECT_EQ(axes_of(runs_of(strokes)), found);
}

}  // namespace
}  // namespace enfilade::plans
