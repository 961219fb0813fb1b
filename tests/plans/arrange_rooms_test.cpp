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

TEST(ArrangeRooms, PolygonsOnAxesNameTheirRooms) {
    Storey storey = two_rooms();
    storey.rooms = {room("left", box(0, 0, 5, 4)), room("right", box(5, 0, 8, 4))};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    ASSERT_NE(find_room(layout.storeys[0], "left"), nullptr);
    ASSERT_NE(find_room(layout.storeys[0], "right"), nullptr);
    EXPECT_GT(find_room(layout.storeys[0], "left")->area_m2, find_room(layout.storeys[0], "right")->area_m2);
    EXPECT_TRUE(layout.findings.empty());
}

TEST(ArrangeRooms, PolygonsLeaveNoTraceInTheSubdivision) {
    Storey storey = two_rooms();
    const Layout without = arrange(plan_of({storey}));
    storey.rooms = {room("left", box(0.3, 0.2, 4.8, 3.7)), room("right", box(5.1, 0.1, 7.9, 3.9))};
    const Layout with = arrange(plan_of({storey}));
    EXPECT_EQ(with.graph.vertices, without.graph.vertices);
}

TEST(ArrangeRooms, TwoPolygonsOfOnePlaceShareABorderFromWallToWall) {
    Storey storey;
    add_box(storey, "w", 0, 0, 8, 4);
    // 10 cm beside the walls, 4 cm beside each other.
    storey.rooms = {room("kitchen", box(0.225, 0.225, 4.98, 3.775)), room("living", box(5.02, 0.225, 7.775, 3.775))};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan, true), "");
    ASSERT_NE(find_room(layout.storeys[0], "kitchen"), nullptr);
    ASSERT_NE(find_room(layout.storeys[0], "living"), nullptr);
    EXPECT_NEAR(find_room(layout.storeys[0], "kitchen")->area_m2, 4.875 * 3.75, 0.04 * 3.75 + 0.001);
    // One straight border: a single edge between the two.
    std::size_t borders = 0;
    for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
        const Owner l = layout.storeys[0].owner[layout.map.face(2 * e)];
        const Owner r = layout.storeys[0].owner[layout.map.face(2 * e + 1)];
        borders += l.kind == OwnerKind::Room && r.kind == OwnerKind::Room && l != r;
    }
    EXPECT_EQ(borders, 1u);
}

TEST(ArrangeRooms, ACourtyardIsExterior) {
    Storey storey;
    add_box(storey, "outer", 0, 0, 10, 10);
    add_box(storey, "inner", 3, 3, 7, 7);
    storey.rooms = {room("yard", box(3, 3, 7, 7), "courtyard"), room("ring", box(0, 0, 10, 10))};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    ASSERT_EQ(layout.storeys[0].rooms.size(), 1u);
    EXPECT_EQ(layout.storeys[0].rooms[0].id, "ring");
    EXPECT_EQ(layout.storeys[0].rooms[0].area_m2, 9.75 * 9.75 - 4.25 * 4.25);
}

TEST(ArrangeRooms, NestedCourtyardsAlternate) {
    Storey storey;
    for (int k = 0; k < 4; ++k)
        add_box(storey, "box" + std::to_string(k) + "-", k * 2.0, k * 2.0, 20 - k * 2.0, 20 - k * 2.0);
    storey.rooms = {room("yard1", box(2, 2, 18, 18), "courtyard"), room("yard2", box(6, 6, 14, 14), "courtyard")};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
}

TEST(ArrangeRooms, APavilionThatTouchesTheOuterWallInAPointLeavesOneRoom) {
    Storey storey;
    add_box(storey, "w", 0, 0, 8, 8);
    // A closed diamond whose corner meets the inner face of the left wall.
    const Point p[] = {{0.125 + 0.25 / std::numbers::sqrt2, 4}, {2, 2}, {4, 4}, {2, 6}};
    for (int i = 0; i < 4; ++i) storey.walls.push_back(wall("d" + std::to_string(i), p[i], p[(i + 1) % 4]));
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
}

TEST(ArrangeRooms, SaysWhereTheWallsAroundARoomDoNotClose) {
    Storey storey;
    add_box(storey, "w", 0, 0, 8, 4);
    storey.walls[1].end = {8, 3.5};  // half a metre short of the corner
    storey.rooms = {room("hall", box(0, 0, 8, 4))};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_TRUE(layout.storeys[0].rooms.empty());
    const auto found =
        std::find_if(layout.findings.begin(), layout.findings.end(), [](const Finding& f) { return f.code == "P311"; });
    ASSERT_NE(found, layout.findings.end());
    ASSERT_TRUE(found->point.has_value());
    EXPECT_NEAR((*found->point)[0], 8, 0.3);
    EXPECT_NEAR((*found->point)[1], 3.75, 0.3);
}

TEST(ArrangeRooms, StairsOpenTheSlabWhereBothStoreysAreFree) {
    Storey ground = two_rooms();
    Stair stair;
    stair.id = "stair";
    stair.polygon = box(6, 0, 7, 2);  // reaches into the wall along y = 0
    ground.stairs.push_back(stair);
    const Plan plan = plan_of({ground, two_rooms()});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    const std::vector<std::int64_t> areas = areas2(layout);
    double open = 0;
    for (std::size_t f = 1; f < areas.size(); ++f)
        if (layout.storeys[0].opens_up[f] == 0) open += double(areas[f]) / 2 * std::pow(layout.frame.unit, 2);
    EXPECT_EQ(open, 1 * (2 - 0.125));
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Stair), 1 * (2 - 0.125));
    EXPECT_EQ(area_of(layout, 1, OwnerKind::Stair), 0);
    EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
}

TEST(ArrangeRooms, StairsEndAtTheCeilingOfAStoreyBuiltAlone) {
    Storey ground = two_rooms();
    ground.stairs.push_back({"stair", "", box(6, 1, 7, 2)});
    ArrangeOptions options;
    options.storeys = {0};
    const Layout layout = arrange(plan_of({ground, two_rooms()}), options);
    ASSERT_EQ(layout.storeys.size(), 1u);
    EXPECT_EQ(count_findings(layout, "P330"), 1u);
    EXPECT_TRUE(std::all_of(layout.storeys[0].opens_up.begin(), layout.storeys[0].opens_up.end(),
                            [](std::uint32_t hole) { return hole == UINT32_MAX; }));
}

TEST(ArrangeRooms, ColumnsAreSolidAndSelfIntersectingOnesFilled) {
    Storey storey;
    add_box(storey, "w", 0, 0, 8, 4);
    storey.columns.push_back({"bow-tie", "", {{2, 1}, {4, 3}, {4, 1}, {2, 3}}, 0});
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Column), 2.0);
}

TEST(ArrangeRooms, WallsThinnerThanTheGridAreNamed) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("film", {1, 1}, {1, 2}, 1e-6));
    const Layout layout = arrange(plan_of({storey}));
    ASSERT_EQ(count_findings(layout, "P302"), 1u);
    EXPECT_EQ(layout.findings[0].elements[0].id, "film");
}

TEST(ArrangeRooms, AMillionMetresAwayItIsTheSamePlan) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("oblique", {1, 0}, {3, 4}, 0.125));
    storey.walls.push_back(wall("arc", {5, 1}, {8, 3}, 0.125, 1));
    Plan near = plan_of({storey});
    Plan far = near;
    for (Wall& w : far.storeys[0].walls) {
        w.start = {w.start.x + 1e6, w.start.y - 1e6};
        w.end = {w.end.x + 1e6, w.end.y - 1e6};
    }
    const Layout a = arrange(near);
    const Layout b = arrange(far);
    EXPECT_EQ(defect(b, far), "");
    EXPECT_EQ(b.frame.unit, a.frame.unit);
    EXPECT_EQ(b.frame.origin_x, a.frame.origin_x + 1e6);
    EXPECT_EQ(b.map.face_count, a.map.face_count);
    EXPECT_EQ(b.storeys[0].rooms.size(), a.storeys[0].rooms.size());
}

TEST(ArrangeRooms, PlansInMillimetresOrKilometresByMistakeStillClose) {
    for (const double scale : {0.001, 1000.0}) {
        Storey storey = two_rooms();
        for (Wall& w : storey.walls) {
            w.start = {w.start.x * scale, w.start.y * scale};
            w.end = {w.end.x * scale, w.end.y * scale};
            w.thickness *= scale;
        }
        const Plan plan = plan_of({storey});
        const Layout layout = arrange(plan);
        EXPECT_EQ(defect(layout, plan), "") << scale;
        if (scale > 1) {
            EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
            EXPECT_EQ(count_findings(layout, "P301"), 1u);
        }
    }
}

TEST(ArrangeRooms, RefusesToCoarsenAGridThatTheUserFixed) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("far", {100000, 0}, {100010, 0}));
    ArrangeOptions options;
    options.snap_fixed = true;
    EXPECT_THROW(static_cast<void>(arrange(plan_of({storey}), options)), InputError);
}

TEST(ArrangeRooms, RefusesNumbersThatAreNotFinite) {
    Storey storey = two_rooms();
    storey.walls[0].end.x = std::nan("");
    EXPECT_THROW(static_cast<void>(arrange(plan_of({storey}))), InputError);
}

TEST(ArrangeRooms, AnEmptyPlanIsExteriorAlone) {
    const Plan plan = plan_of({Storey{}});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.map.face_count, 2u);
}

TEST(ArrangeRooms, TurnedBuildingsKeepEveryRoom) {
    for (int k = 0; k < 6; ++k) {
        GenerateOptions options;
        options.rooms = 120;
        options.curved = options.oblique = 0.3;
        options.seed = std::uint64_t(k);
        Plan plan = generate(options);
        const double angle = 0.1 + 0.37 * k;
        const auto turn = [&](Point& p) {
            p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y};
        };
        std::size_t closed_rooms = 0;
        for (Storey& storey : plan.storeys) {
            for (Wall& w : storey.walls) {
                turn(w.start);
                turn(w.end);
            }
            for (Column& column : storey.columns) std::for_each(column.polygon.begin(), column.polygon.end(), turn);
            for (Room& r : storey.rooms) {
                std::for_each(r.polygon.begin(), r.polygon.end(), turn);
                closed_rooms += r.kind != "courtyard" && r.kind != "terrace";
            }
        }
        const Layout layout = arrange(plan);
        EXPECT_EQ(defect(layout, plan), "") << angle;
        EXPECT_EQ(layout.storeys[0].rooms.size(), closed_rooms) << angle;
        EXPECT_TRUE(layout.findings.empty()) << angle;
    }
}

/// Walls between random places of a coarse raster, and some anywhere: joints of every kind.
Storey random_storey(int wall_count) {
    Storey storey;
    const auto snapped = [&] { return *rc::gen::inRange(0, 9) * 1.0; };
    const auto loose = [&] { return *rc::gen::inRange(0, 80000) * 0.0001; };
    for (int i = 0; i < wall_count; ++i) {
        const bool on_raster = *rc::gen::inRange(0, 4) != 0;
        const Point a = on_raster ? Point{snapped(), snapped()} : Point{loose(), loose()};
        const Point b = on_raster ? Point{snapped(), snapped()} : Point{loose(), loose()};
        const double arc = *rc::gen::element(0.0, 0.0, 0.0, 0.7, -1.6, 3.5);
        storey.walls.push_back(wall("w" + std::to_string(100 + i), a, b, *rc::gen::element(0.1, 0.2, 0.35), arc));
        if (*rc::gen::inRange(0, 3) == 0)
            storey.openings.push_back(
                opening("o" + std::to_string(100 + i), storey.walls.back().id, *rc::gen::inRange(0, 40) * 0.1, 0.9));
    }
    return storey;
}

RC_GTEST_PROP(ArrangeRooms, RandomPlansHaveOneOwnerAFaceAndClosedRooms, ()) {
    const Plan plan = plan_of({random_storey(*rc::gen::inRange(1, 25)), random_storey(*rc::gen::inRange(0, 25))});
    RC_ASSERT(defect(arrange(plan), plan) == "");
}

RC_GTEST_PROP(ArrangeRooms, TheOrderOfElementsDoesNotMatter, ()) {
    const Plan plan = plan_of({random_storey(*rc::gen::inRange(1, 25))});
    Plan shuffled = plan;
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::shuffle(shuffled.storeys[0].walls.begin(), shuffled.storeys[0].walls.end(), random);
    std::shuffle(shuffled.storeys[0].openings.begin(), shuffled.storeys[0].openings.end(), random);
    RC_ASSERT(in_words(arrange(plan), plan) == in_words(arrange(shuffled), shuffled));
}

RC_GTEST_PROP(ArrangeRooms, RandomPolygonsDivideButNeverOpen, ()) {
    Storey storey = two_rooms();
    const int count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) {
        const double x = *rc::gen::inRange(0, 60) * 0.1;
        const double y = *rc::gen::inRange(0, 30) * 0.1;
        storey.rooms.push_back(room("r" + std::to_string(i),
                                    box(x, y, x + *rc::gen::inRange(5, 50) * 0.1, y + *rc::gen::inRange(5, 40) * 0.1)));
    }
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    RC_ASSERT(defect(layout, plan, true) == "");
    double area = 0;
    for (const FoundRoom& found : layout.storeys[0].rooms) area += found.area_m2;
    RC_ASSERT(std::abs(area - 3.75 * (7.75 - 0.125)) < 1e-9);
}

}  // namespace
}  // namespace enfilade::plans
