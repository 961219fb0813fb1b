#include "plans/layout.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "base/id.h"
#include "plans/generate.h"
#include "tests/plans/arrangement.h"

namespace enfilade::plans {
namespace {

using namespace testing;

TEST(Arrange, AreasOfABoxAreExact) {
    Storey storey;
    add_box(storey, "w", 0, 0, 4, 3);
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Room), 3.75 * 2.75);
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Wall), 4.25 * 3.25 - 3.75 * 2.75);
    ASSERT_EQ(layout.storeys[0].rooms.size(), 1u);
    EXPECT_EQ(layout.storeys[0].rooms[0].id, "room@s0/0");
    EXPECT_EQ(layout.storeys[0].rooms[0].area_m2, 3.75 * 2.75);
}

TEST(Arrange, CornersOfABoxAreMitred) {
    Storey storey;
    add_box(storey, "w", 0, 0, 4, 3);
    const Layout layout = arrange(plan_of({storey}));
    // Four walls, the room, the exterior, and what lies beyond.
    EXPECT_EQ(layout.map.face_count, 7u);
}

TEST(Arrange, AWallThatEndsInAnotherSeparatesRooms) {
    const Plan plan = plan_of({two_rooms()});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    ASSERT_EQ(layout.storeys[0].rooms.size(), 2u);
    const double depth = 3.75;
    EXPECT_EQ(layout.storeys[0].rooms[0].area_m2 + layout.storeys[0].rooms[1].area_m2, depth * (7.75 - 0.125));
}

TEST(Arrange, CrossingWallsMakeFourRooms) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("across", {0, 2}, {8, 2}, 0.125));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.storeys[0].rooms.size(), 4u);
}

TEST(Arrange, ThickerWallsOwnTheCrossing) {
    Storey storey;
    storey.walls = {wall("a-thin", {-2, 0}, {2, 0}, 0.25), wall("b-thick", {0, -2}, {0, 2}, 0.5)};
    const Layout layout = arrange(plan_of({storey}));
    const std::vector<std::int64_t> areas = areas2(layout);
    double thick = 0;
    for (std::size_t f = 1; f < areas.size(); ++f)
        if (layout.storeys[0].owner[f] == Owner{OwnerKind::Wall, 1}) thick += double(areas[f]) / 2;
    EXPECT_EQ(thick * layout.frame.unit * layout.frame.unit, 4 * 0.5);
}

TEST(Arrange, ADoorSharesItsEdgesWithItsWall) {
    Storey storey;
    add_box(storey, "w", 0, 0, 4, 3);
    storey.openings.push_back(opening("door", "w0", 2, 1));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Opening), 0.25);
    // Four vertices alone: the door's corners lie on the wall's faces.
    EXPECT_EQ(layout.map.face_count, 9u);
    for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
        const Owner l = layout.storeys[0].owner[layout.map.face(2 * e)];
        const Owner r = layout.storeys[0].owner[layout.map.face(2 * e + 1)];
        if (l.kind != OwnerKind::Opening && r.kind != OwnerKind::Opening) continue;
        const OwnerKind other = l.kind == OwnerKind::Opening ? r.kind : l.kind;
        EXPECT_TRUE(other == OwnerKind::Wall || other == OwnerKind::Room || other == OwnerKind::Exterior);
    }
}

TEST(Arrange, ADoorGoesOnThroughWallsThatLieAgainstItsHost) {
    Storey storey;
    add_box(storey, "w", 0, 0, 4, 3);
    storey.walls.push_back(wall("lining", {1, -0.25}, {3, -0.25}, 0.25));
    storey.openings.push_back(opening("door", "w0", 2, 1));
    storey.openings.back().depth_right = 0.25;
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Opening), 0.5);
}

TEST(Arrange, ACircleOfFourArcsEnclosesOneRoom) {
    Storey storey;
    const Point p[] = {{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
    for (int i = 0; i < 4; ++i)
        storey.walls.push_back(wall("arc" + std::to_string(i), p[i], p[(i + 1) % 4], 0.25, std::numbers::pi / 2));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    ASSERT_EQ(layout.storeys[0].rooms.size(), 1u);
    const double exact = std::numbers::pi * 1.875 * 1.875;
    EXPECT_LT(layout.storeys[0].rooms[0].area_m2, exact);
    // Chords miss at most the sagitta of 2 mm over two thirds of their length.
    EXPECT_GT(layout.storeys[0].rooms[0].area_m2, exact - 2 * std::numbers::pi * 1.875 * 0.002);
}

TEST(Arrange, ArcsOfMoreThanHalfATurnMakeLobes) {
    Storey storey;
    add_box(storey, "w", -4, -4, 4, 4);
    storey.walls.push_back(wall("lobe", {4, -1}, {4, 1}, 0.25, 1.5 * std::numbers::pi));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    ASSERT_EQ(layout.storeys[0].rooms.size(), 2u);
    const double lobe = std::min(layout.storeys[0].rooms[0].area_m2, layout.storeys[0].rooms[1].area_m2);
    EXPECT_GT(lobe, 0.5 * std::numbers::pi);
}

TEST(Arrange, AWindowInACurvedWallFollowsItsFaces) {
    Storey storey;
    storey.walls = {wall("arc", {2, 0}, {-2, 0}, 0.25, std::numbers::pi), wall("chord", {-2, 0}, {2, 0}, 0.25)};
    storey.openings.push_back(opening("window", "arc", std::numbers::pi, 1.5));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_NEAR(area_of(layout, 0, OwnerKind::Opening), 1.5 * 0.25, 0.001);
}

class Joint : public ::testing::TestWithParam<double> {};

TEST_P(Joint, ClosesATriangleAtAnyAngle) {
    const double angle = GetParam() * std::numbers::pi / 180;
    Storey storey;
    const Point apex{6 * std::cos(angle), 6 * std::sin(angle)};
    storey.walls = {wall("a", {0, 0}, {6, 0}), wall("b", {0, 0}, apex, 0.125), wall("c", {6, 0}, apex, 0.25)};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    if (GetParam() >= 10 && GetParam() <= 170) {
        EXPECT_EQ(layout.storeys[0].rooms.size(), 1u);
    }
}

INSTANTIATE_TEST_SUITE_P(Angles, Joint,
                         ::testing::Values(0.01, 0.5, 3, 10, 30, 45, 60, 89.99, 90.01, 120, 150, 170, 179, 179.99));

TEST(Arrange, CollinearWallsOfDifferentThicknessAreStepped) {
    Storey storey;
    storey.walls = {wall("a", {0, 0}, {2, 0}, 0.25), wall("b", {2, 0}, {4, 0}, 0.5)};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Wall), 2 * 0.25 + 2 * 0.5);
}

TEST(Arrange, WallsDrawnInPiecesAreOneLine) {
    Storey storey;
    storey.walls = {wall("a", {0, 0}, {2, 0}), wall("b", {4, 0}, {2, 0}), wall("c", {4, 0}, {5, 0})};
    const Layout layout = arrange(plan_of({storey}));
    std::set<std::uint32_t> upper;
    for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
        const auto y = [&](std::uint32_t v) { return layout.frame.world_y(layout.graph.vertices[v].y); };
        if (y(layout.graph.edges[e].a) == 0.125 && y(layout.graph.edges[e].b) == 0.125)
            upper.insert(std::uint32_t(index(layout.edge_line[e])));
    }
    EXPECT_EQ(upper.size(), 1u);
}

TEST(Arrange, APolylineAlmostStraightIsNotOneLine) {
    // Each joint bends by a third of a unit, all together by many.
    Storey storey;
    const double bend = 1.0 / 8192 / 3;
    std::vector<Point> p;
    for (int i = 0; i <= 40; ++i) p.push_back({double(i), bend * i * i / 2});
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        storey.walls.push_back(wall("w" + std::to_string(100 + i), p[i], p[i + 1]));
    const Layout layout = arrange(plan_of({storey}));
    std::map<std::uint32_t, std::vector<GridPoint>> on_line;
    for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e)
        for (const std::uint32_t v : {layout.graph.edges[e].a, layout.graph.edges[e].b})
            on_line[std::uint32_t(index(layout.edge_line[e]))].push_back(layout.graph.vertices[v]);
    for (auto& [line, points] : on_line) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end());
        const double span = std::hypot(double(high->x) - low->x, double(high->y) - low->y);
        for (const GridPoint q : points) EXPECT_LE(std::abs(double(orientation(*low, *high, q))), 2.5 * span);
    }
}

TEST(Arrange, WallsAHairApartLeaveASplinterNotARoom) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("twin", {5.125 + 0.001, 0}, {5.125 + 0.001, 4}, 0.125));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
    EXPECT_EQ(count_findings(layout, "P320") + count_findings(layout, "P321"), 1u);
}

}  // namespace
}  // namespace enfilade::plans
