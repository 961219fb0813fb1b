// Walls from pairs of lines.

#include "plans/dxf/wall_bodies.h"

#include "tests/plans/dxf/wall_strokes.h"

namespace enfilade::plans {
namespace {

using namespace wall_strokes;
using Axes = std::vector<Axis>;

Axes straight(const Strokes& strokes) {
    const WallBodies bodies = bodies_of(strokes);
    return axes_of(bodies, bodies.straight);
}
Axes single(const Strokes& strokes) {
    const WallBodies bodies = bodies_of(strokes);
    return axes_of(bodies, bodies.single);
}

TEST(WallBodies, TwoParallelLinesAreAWall) {
    const WallBodies bodies = bodies_of(faces({0, 0}, {5, 0.2}));
    EXPECT_EQ(axes_of(bodies, bodies.straight), (Axes{{{0, 0.1}, {5, 0.1}, 0.2}}));
    EXPECT_TRUE(bodies.single.empty());
    EXPECT_NEAR(bodies.paired_length, 10, 1e-9);
    EXPECT_NEAR(bodies.total_length, 10, 1e-9);
    EXPECT_NEAR(bodies.usual_thickness, 0.2, 0.006);
}

TEST(WallBodies, AWallMayStandInAnyDirection) {
    const Point d = {std::cos(0.5), std::sin(0.5)}, n = turned_left(d);
    const Point at = {70, -30};
    const Axes found = straight({stroke(at, at + d * 5), stroke(at + d * 5 + n * 0.3, at + n * 0.3)});
    EXPECT_EQ(found, (Axes{{at + n * 0.15, at + d * 5 + n * 0.15, 0.3}}));
}

TEST(WallBodies, OnlyWhatBothFacesShareIsAWall) {
    const Strokes strokes = {stroke({0, 0}, {5, 0}), stroke({1, 0.2}, {6, 0.2})};
    EXPECT_EQ(straight(strokes), (Axes{{{1, 0.1}, {5, 0.1}, 0.2}}));
    EXPECT_EQ(single(strokes), (Axes{{{0, 0}, {1, 0}, 0}, {{5, 0.2}, {6, 0.2}, 0}}));
}

TEST(WallBodies, LinesTooCloseOrTooFarAreNone) {
    EXPECT_TRUE(straight(faces({0, 0}, {5, 0.02})).empty());
    EXPECT_TRUE(straight(faces({0, 0}, {5, 0.7})).empty());
    EXPECT_EQ(straight(faces({0, 0}, {5, 0.64})).size(), 1u);
}

TEST(WallBodies, LinesDrawnTwiceCountOnce) {
    const Strokes strokes = faces({0, 0}, {5, 0.2}) + faces({0, 0}, {5, 0.2}) + faces({1, 0.001}, {4, 0.201});
    const WallBodies bodies = bodies_of(strokes);
    ASSERT_EQ(bodies.straight.size(), 1u);
    EXPECT_NEAR(bodies.straight[0].thickness, 0.2, 0.002);
    EXPECT_NEAR(bodies.total_length, 10, 1e-9);
    EXPECT_TRUE(bodies.single.empty());
}

TEST(WallBodies, LinesThatTouchAreOne) {
    const Strokes strokes = {stroke({0, 0}, {2, 0}), stroke({5, 0}, {2.001, 0}), stroke({0, 0.2}, {5, 0.2})};
    EXPECT_EQ(straight(strokes), (Axes{{{0, 0.1}, {5, 0.1}, 0.2}}));
    const Strokes apart = {stroke({0, 0}, {2, 0}), stroke({2.5, 0}, {5, 0}), stroke({0, 0.2}, {5, 0.2})};
    EXPECT_EQ(straight(apart), (Axes{{{0, 0.1}, {2, 0.1}, 0.2}, {{2.5, 0.1}, {5, 0.1}, 0.2}}));
}

TEST(WallBodies, SlightlyCrookedLinesPair) {
    const auto leaning = [](double degrees) {
        return Strokes{stroke({0, 0}, {8, 0}), stroke({0, 0.2}, {5, 0.2 + 5 * std::tan(degrees * 0.0174532925)})};
    };
    EXPECT_EQ(straight(leaning(0.3)).size(), 1u);
    EXPECT_TRUE(straight(leaning(2)).empty());
}

TEST(WallBodies, OfThreeLinesTheUsualThicknessIsTheWall) {
    const Strokes three = {stroke({0, 0}, {5, 0}), stroke({0, 0.1}, {5, 0.1}), stroke({0, 0.25}, {5, 0.25})};
    EXPECT_EQ(straight(three), (Axes{{{0, 0.05}, {5, 0.05}, 0.1}}));
    EXPECT_EQ(single(three), (Axes{{{0, 0.25}, {5, 0.25}, 0}}));
    // Where walls of 15 cm are usual, so is this one.
    const Strokes among = three + faces({0, 10}, {20, 10.15});
    EXPECT_EQ(straight(among), (Axes{{{0, 0.175}, {5, 0.175}, 0.15}, {{0, 10.075}, {20, 10.075}, 0.15}}));
}

TEST(WallBodies, ALineInTheMiddleOfAWallIsNoFace) {
    EXPECT_EQ(straight(faces({0, 0}, {5, 0.25}) + Strokes{stroke({0.2, 0.125}, {5.2, 0.125})}),
              (Axes{{{0, 0.125}, {5, 0.125}, 0.25}}));
    // For less than its length it may be one all the same.
    const Strokes longer = faces({0, 0}, {5, 0.25}) + Strokes{stroke({0, 0.125}, {12, 0.125})};
    EXPECT_EQ(bodies_of(longer).groups[0].lines.size(), 3u);
}

TEST(WallBodies, TheFacesOfOneWallStayInOneGroup) {
    // Lines of other directions around them, 0.1 degrees from each other: wherever the groups fall, pairs do not part.
    for (int k = 0; k < 40; ++k) {
        Strokes strokes;
        const auto wall_at = [&](double degrees, double y, double length) {
            const double a = degrees * std::acos(-1.0) / 180;
            const Point d{std::cos(a), std::sin(a)}, n = turned_left(d), at{0, y};
            // The second face is askew by a rounding of coordinates.
            strokes.push_back(stroke(at, at + d * length));
            strokes.push_back(stroke(at + n * 0.2, at + n * 0.2 + d * (length * 0.8) + n * 0.0001));
        };
        wall_at(10, 0, 9);
        wall_at(10.7, 20, 8);
        wall_at(10 + 0.0175 * k, 40, 2);
        EXPECT_EQ(straight(strokes).size(), 3u) << k;
    }
}

TEST(WallBodies, AJambAcrossFromTheFaceOfAnotherWallIsNoWall) {
    // A wall of 20 cm along y, and one of 16 that leaves it and ends at a door 0.33 m away.
    const Strokes strokes = {stroke({-0.1, 0}, {-0.1, 6}),       stroke({0.1, 0}, {0.1, 3}),
                             stroke({0.1, 3.16}, {0.1, 6}),      stroke({0.1, 3}, {0.432, 3}),
                             stroke({0.1, 3.16}, {0.432, 3.16}), stroke({0.432, 3}, {0.432, 3.16})};
    for (const WallBody& body : bodies_of(strokes).straight) EXPECT_LT(body.thickness, 0.25);
}

TEST(WallBodies, TwoWallsSideBySideLeaveTheSpaceBetween) {
    // Their faces towards each other are 0.3 m apart: a wall's distance too.
    EXPECT_EQ(straight(faces({0, 0}, {5, 0.1}) + faces({0, 0.4}, {5, 0.5})),
              (Axes{{{0, 0.05}, {5, 0.05}, 0.1}, {{0, 0.45}, {5, 0.45}, 0.1}}));
}

TEST(WallBodies, AStretchOfAFaceBelongsToOneWall) {
    // A long face with a thin wall on one side of its first half, a thick one on the other side of all of it.
    const Strokes strokes = {stroke({0, 0}, {8, 0}), stroke({0, 0.1}, {4, 0.1}), stroke({0, -0.3}, {8, -0.3})};
    const WallBodies bodies = bodies_of(strokes);
    double length = 0;
    for (const WallBody& body : bodies.straight) length += body.u1 - body.u0;
    EXPECT_LE(length, 8 + 1e-9);
    EXPECT_NEAR(bodies.paired_length, 2 * length, 1e-9);
}

/// Corner of two walls of 0.2 m, outside at (0, 0).
Strokes corner() {
    return {stroke({0, 0}, {5, 0}), stroke({0.2, 0.2}, {5, 0.2}), stroke({0, 0}, {0, 4}), stroke({0.2, 0.2}, {0.2, 4})};
}

TEST(WallBodies, AnElbowIsTwo) {
    EXPECT_EQ(straight(corner()), (Axes{{{0.1, 0.2}, {0.1, 4}, 0.2}, {{0.2, 0.1}, {5, 0.1}, 0.2}}));
}

TEST(WallBodies, ATeeIsThree) {
    const Strokes strokes = {stroke({0, 4.2}, {10, 4.2}), stroke({0, 4}, {4.9, 4}), stroke({5.1, 4}, {10, 4}),
                             stroke({4.9, 0}, {4.9, 4}), stroke({5.1, 0}, {5.1, 4})};
    EXPECT_EQ(straight(strokes),
              (Axes{{{0, 4.1}, {4.9, 4.1}, 0.2}, {{5, 0}, {5, 4}, 0.2}, {{5.1, 4.1}, {10, 4.1}, 0.2}}));
}

TEST(WallBodies, ACrossingIsFour) {
    Strokes strokes;
    for (const double x : {-1, 1})
        for (const double y : {-1, 1}) {
            strokes.push_back(stroke({0.1 * x, 0.1 * y}, {3 * x, 0.1 * y}));
            strokes.push_back(stroke({0.1 * x, 0.1 * y}, {0.1 * x, 3 * y}));
        }
    EXPECT_EQ(
        straight(strokes),
        (Axes{{{-3, 0}, {-0.1, 0}, 0.2}, {{0, -3}, {0, -0.1}, 0.2}, {{0, 0.1}, {0, 3}, 0.2}, {{0.1, 0}, {3, 0}, 0.2}}));
    EXPECT_TRUE(single(strokes).empty());
}

TEST(WallBodies, OrderAndDirectionOfTheLinesDoNotMatter) {
    Strokes strokes = corner() + faces({0, 7}, {5, 7.1}) + faces({0, 7.4}, {5, 7.5});
    const Axes found = straight(strokes);
    std::reverse(strokes.begin(), strokes.end());
    for (SheetStroke& s : strokes) std::swap(s.stroke.a, s.stroke.b);
    EXPECT_EQ(straight(strokes), found);
}

TEST(WallBodies, ALoneLineIsLeft) {
    const WallBodies bodies = bodies_of({stroke({0, 0}, {5, 0}), stroke({0, 3}, {0.08, 3})});
    EXPECT_TRUE(bodies.straight.empty());
    EXPECT_EQ(bodies.paired_length, 0);
    EXPECT_NEAR(bodies.total_length, 5.08, 1e-9);
    // The short one is no more than the end of a wall.
    EXPECT_EQ(axes_of(bodies, bodies.single), (Axes{{{0, 0}, {5, 0}, 0}}));
}

TEST(WallBodies, LowWallsAreAMetreHighUnlessTheirRuleSaysElse) {
    Strokes strokes = faces({0, 0}, {5, 0.1}, Role::LowWall);
    EXPECT_EQ(bodies_of(strokes).straight.at(0).height, 1.0);
    RoleRule rule;
    rule.height = 1.3;
    for (SheetStroke& s : strokes) s.rule = &rule;
    EXPECT_EQ(bodies_of(strokes).straight.at(0).height, 1.3);
    EXPECT_FALSE(bodies_of(faces({0, 0}, {5, 0.1})).straight.at(0).height.has_value());
}

const double degree = std::acos(-1.0) / 180;

void expect_curve(const CurvedBody& body, double radius, double start, double sweep, double thickness) {
    EXPECT_NEAR(distance(body.centre, {2, 1}), 0, 1e-9);
    EXPECT_NEAR(body.radius, radius, 1e-9);
    EXPECT_NEAR(std::remainder(body.start - start * degree, 360 * degree), 0, 1e-9);
    EXPECT_NEAR(body.sweep, sweep * degree, 1e-9);
    EXPECT_NEAR(body.thickness, thickness, 1e-9);
}

TEST(WallBodies, TwoArcsAboutOneCentreAreACurvedWall) {
    for (const bool turned : {false, true}) {
        const SheetStroke outer = turned ? arc({2, 1}, 3.2, 100, 10) : arc({2, 1}, 3.2, 10, 100);
        const WallBodies bodies = bodies_of({arc({2, 1}, 3, 10, 100), outer});
        ASSERT_EQ(bodies.curved.size(), 1u);
        expect_curve(bodies.curved[0], 3.1, 10, 90, 0.2);
        EXPECT_NEAR(bodies.paired_length, bodies.total_length, 1e-9);
    }
}

TEST(WallBodies, ArcsShareWhatTheyShare) {
    const WallBodies bodies = bodies_of({arc({2, 1}, 3, 300, 400), arc({2, 1}, 3.2, 20, 90)});
    ASSERT_EQ(bodies.curved.size(), 1u);
    expect_curve(bodies.curved[0], 3.1, 20, 20, 0.2);
}

TEST(WallBodies, OneArcMayBeTheFaceOfSeveralCurvedWalls) {
    // The inner face is broken by a wall that leads up to it.
    const WallBodies bodies = bodies_of({arc({2, 1}, 3.2, 0, 90), arc({2, 1}, 3, 0, 40), arc({2, 1}, 3, 44, 90)});
    ASSERT_EQ(bodies.curved.size(), 2u);
    const bool swapped = bodies.curved[0].start > bodies.curved[1].start;
    expect_curve(bodies.curved[swapped ? 1 : 0], 3.1, 0, 40, 0.2);
    expect_curve(bodies.curved[swapped ? 0 : 1], 3.1, 44, 46, 0.2);
}

TEST(WallBodies, AStretchOfAnArcBelongsToOneWall) {
    const WallBodies bodies = bodies_of({arc({2, 1}, 3, 0, 90), arc({2, 1}, 3.1, 0, 90), arc({2, 1}, 3.4, 0, 90)});
    ASSERT_EQ(bodies.curved.size(), 1u);
    expect_curve(bodies.curved[0], 3.05, 0, 90, 0.1);
}

TEST(WallBodies, ArcsAboutDifferentCentresOrOnDifferentSidesAreNoWall) {
    EXPECT_TRUE(bodies_of({arc({2, 1}, 3, 0, 90), arc({2.1, 1}, 3.2, 0, 90)}).curved.empty());
    EXPECT_TRUE(bodies_of({arc({2, 1}, 3, 0, 90), arc({2, 1}, 3.2, 100, 190)}).curved.empty());
}

}  // namespace
}  // namespace enfilade::plans
