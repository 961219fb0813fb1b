// Owners, rooms, borders and lines of whole plans, on numbers that the grid holds exactly.

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
#include "plans/layout.h"

namespace enfilade::plans {
namespace {

Wall wall(std::string id, Point a, Point b, double thickness = 0.25, double arc = 0) {
    Wall result;
    result.id = std::move(id);
    result.start = a;
    result.end = b;
    result.thickness = thickness;
    result.arc_extent = arc;
    return result;
}

Room room(std::string id, std::vector<Point> polygon, std::string kind = "room") {
    Room result;
    result.id = id;
    result.name = std::move(id);
    result.kind = std::move(kind);
    result.polygon = std::move(polygon);
    return result;
}

std::vector<Point> box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

void add_box(Storey& storey, const std::string& prefix, double x0, double y0, double x1, double y1,
             double thickness = 0.25) {
    const std::vector<Point> p = box(x0, y0, x1, y1);
    for (std::size_t i = 0; i < 4; ++i)
        storey.walls.push_back(wall(prefix + std::to_string(i), p[i], p[(i + 1) % 4], thickness));
}

Opening opening(std::string id, std::string host, double offset, double width) {
    Opening result;
    result.id = std::move(id);
    result.wall = std::move(host);
    result.offset = offset;
    result.width = width;
    return result;
}

Plan plan_of(std::vector<Storey> storeys) {
    Plan plan;
    plan.name = "test";
    for (std::size_t s = 0; s < storeys.size(); ++s) {
        storeys[s].id = storeys[s].name = "s" + std::to_string(s);
        storeys[s].elevation = 3.0 * double(s);
        plan.storeys.push_back(std::move(storeys[s]));
    }
    return plan;
}

std::vector<std::int64_t> areas2(const Layout& layout) {
    std::vector<std::int64_t> areas(layout.map.face_count, 0);
    for (std::size_t l = 0; l < layout.map.loop_first.size(); ++l)
        areas[layout.map.face_of_loop[l]] += layout.map.loop_area2[l];
    return areas;
}

/// Square metres that one kind of owner holds in a storey; face 0 left out.
double area_of(const Layout& layout, std::size_t storey, OwnerKind kind) {
    const std::vector<std::int64_t> areas = areas2(layout);
    std::int64_t sum = 0;
    for (std::size_t f = 1; f < areas.size(); ++f)
        if (layout.storeys[storey].owner[f].kind == kind) sum += areas[f];
    return double(sum) / 2 * layout.frame.unit * layout.frame.unit;
}

const FoundRoom* find_room(const StoreyLayout& storey, const std::string& id) {
    for (const FoundRoom& found : storey.rooms)
        if (found.id == id) return &found;
    return nullptr;
}

std::size_t count_findings(const Layout& layout, const std::string& code) {
    return std::count_if(layout.findings.begin(), layout.findings.end(),
                         [&](const Finding& f) { return f.code == code; });
}

/// What holds for every layout: faces fill the site box, each has an owner that exists, and where no polygons
/// share a place, rooms touch solids alone. Returns what is wrong.
std::string defect(const Layout& layout, const Plan& plan, bool borders_allowed = false) {
    const std::vector<std::int64_t> areas = areas2(layout);
    std::int64_t sum = 0;
    for (std::size_t f = 1; f < areas.size(); ++f) {
        if (areas[f] <= 0) return "a face without area";
        sum += areas[f];
    }
    const std::int64_t width = std::int64_t(layout.site_max.x) - layout.site_min.x;
    const std::int64_t height = std::int64_t(layout.site_max.y) - layout.site_min.y;
    if (sum != 2 * width * height) return "faces do not fill the site box";
    if (layout.edge_line.size() != layout.graph.edges.size()) return "edges without a line";
    if (layout.use_line.size() != layout.graph.uses.size()) return "uses without a line";
    for (const LineId line : layout.edge_line)
        if (index(line) >= layout.lines.size()) return "a line that does not exist";
    for (const StoreyLayout& storey : layout.storeys) {
        const Storey& from = plan.storeys[storey.plan_storey];
        if (storey.owner.size() != layout.map.face_count) return "faces without owner";
        const std::map<OwnerKind, std::size_t> counts{{OwnerKind::Exterior, 1},
                                                      {OwnerKind::Room, storey.rooms.size()},
                                                      {OwnerKind::Wall, from.walls.size()},
                                                      {OwnerKind::Opening, from.openings.size()},
                                                      {OwnerKind::Column, from.columns.size()},
                                                      {OwnerKind::Stair, from.stairs.size()},
                                                      {OwnerKind::Shaft, from.shafts.size()}};
        for (const Owner& owner : storey.owner)
            if (owner.element >= counts.at(owner.kind)) return "an owner that does not exist";
        if (storey.owner[0].kind != OwnerKind::Exterior) return "beyond the site is not exterior";
        for (std::uint32_t e = 0; e < layout.graph.edges.size(); ++e) {
            const Owner l = storey.owner[layout.map.face(2 * e)];
            const Owner r = storey.owner[layout.map.face(2 * e + 1)];
            const bool open = (l.kind == OwnerKind::Room || l.kind == OwnerKind::Exterior) &&
                              (r.kind == OwnerKind::Room || r.kind == OwnerKind::Exterior);
            if (open && l != r && !borders_allowed) return "a room that no wall closes";
        }
    }
    return "";
}

/// The layout without the numbers of file order: vertices, edges, lines, and owners by id.
std::vector<std::string> in_words(const Layout& layout, const Plan& plan) {
    std::vector<std::string> words;
    for (const GridPoint p : layout.graph.vertices) words.push_back(std::to_string(p.x) + " " + std::to_string(p.y));
    for (std::size_t e = 0; e < layout.graph.edges.size(); ++e)
        words.push_back(std::to_string(layout.graph.edges[e].a) + "-" + std::to_string(layout.graph.edges[e].b) + " " +
                        std::to_string(index(layout.edge_line[e])));
    for (const StoreyLayout& storey : layout.storeys) {
        const Storey& from = plan.storeys[storey.plan_storey];
        for (const Owner& owner : storey.owner) {
            std::string word = std::to_string(int(owner.kind)) + " ";
            if (owner.kind == OwnerKind::Wall) word += from.walls[owner.element].id;
            if (owner.kind == OwnerKind::Opening) word += from.openings[owner.element].id;
            if (owner.kind == OwnerKind::Room) word += storey.rooms[owner.element].id;
            words.push_back(std::move(word));
        }
    }
    return words;
}

Storey two_rooms() {
    Storey storey;
    add_box(storey, "outer", 0, 0, 8, 4);
    storey.walls.push_back(wall("inner", {5, 0}, {5, 4}, 0.125));
    return storey;
}

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

TEST(Arrange, PolygonsOnAxesNameTheirRooms) {
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

TEST(Arrange, PolygonsLeaveNoTraceInTheSubdivision) {
    Storey storey = two_rooms();
    const Layout without = arrange(plan_of({storey}));
    storey.rooms = {room("left", box(0.3, 0.2, 4.8, 3.7)), room("right", box(5.1, 0.1, 7.9, 3.9))};
    const Layout with = arrange(plan_of({storey}));
    EXPECT_EQ(with.graph.vertices, without.graph.vertices);
}

TEST(Arrange, TwoPolygonsOfOnePlaceShareABorderFromWallToWall) {
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

TEST(Arrange, ACourtyardIsExterior) {
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

TEST(Arrange, NestedCourtyardsAlternate) {
    Storey storey;
    for (int k = 0; k < 4; ++k)
        add_box(storey, "box" + std::to_string(k) + "-", k * 2.0, k * 2.0, 20 - k * 2.0, 20 - k * 2.0);
    storey.rooms = {room("yard1", box(2, 2, 18, 18), "courtyard"), room("yard2", box(6, 6, 14, 14), "courtyard")};
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.storeys[0].rooms.size(), 2u);
}

TEST(Arrange, APavilionThatTouchesTheOuterWallInAPointLeavesOneRoom) {
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

TEST(Arrange, SaysWhereTheWallsAroundARoomDoNotClose) {
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

TEST(Arrange, StairsOpenTheSlabWhereBothStoreysAreFree) {
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

TEST(Arrange, StairsEndAtTheCeilingOfAStoreyBuiltAlone) {
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

TEST(Arrange, ColumnsAreSolidAndSelfIntersectingOnesFilled) {
    Storey storey;
    add_box(storey, "w", 0, 0, 8, 4);
    storey.columns.push_back({"bow-tie", "", {{2, 1}, {4, 3}, {4, 1}, {2, 3}}, 0});
    const Plan plan = plan_of({storey});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(area_of(layout, 0, OwnerKind::Column), 2.0);
}

TEST(Arrange, WallsThinnerThanTheGridAreNamed) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("film", {1, 1}, {1, 2}, 1e-6));
    const Layout layout = arrange(plan_of({storey}));
    ASSERT_EQ(count_findings(layout, "P302"), 1u);
    EXPECT_EQ(layout.findings[0].elements[0].id, "film");
}

TEST(Arrange, AMillionMetresAwayItIsTheSamePlan) {
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

TEST(Arrange, PlansInMillimetresOrKilometresByMistakeStillClose) {
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

TEST(Arrange, RefusesToCoarsenAGridThatTheUserFixed) {
    Storey storey = two_rooms();
    storey.walls.push_back(wall("far", {100000, 0}, {100010, 0}));
    ArrangeOptions options;
    options.snap_fixed = true;
    EXPECT_THROW(static_cast<void>(arrange(plan_of({storey}), options)), InputError);
}

TEST(Arrange, RefusesNumbersThatAreNotFinite) {
    Storey storey = two_rooms();
    storey.walls[0].end.x = std::nan("");
    EXPECT_THROW(static_cast<void>(arrange(plan_of({storey}))), InputError);
}

TEST(Arrange, AnEmptyPlanIsExteriorAlone) {
    const Plan plan = plan_of({Storey{}});
    const Layout layout = arrange(plan);
    EXPECT_EQ(defect(layout, plan), "");
    EXPECT_EQ(layout.map.face_count, 2u);
}

TEST(Arrange, TurnedBuildingsKeepEveryRoom) {
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

RC_GTEST_PROP(Arrange, RandomPlansHaveOneOwnerAFaceAndClosedRooms, ()) {
    const Plan plan = plan_of({random_storey(*rc::gen::inRange(1, 25)), random_storey(*rc::gen::inRange(0, 25))});
    RC_ASSERT(defect(arrange(plan), plan) == "");
}

RC_GTEST_PROP(Arrange, TheOrderOfElementsDoesNotMatter, ()) {
    const Plan plan = plan_of({random_storey(*rc::gen::inRange(1, 25))});
    Plan shuffled = plan;
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::shuffle(shuffled.storeys[0].walls.begin(), shuffled.storeys[0].walls.end(), random);
    std::shuffle(shuffled.storeys[0].openings.begin(), shuffled.storeys[0].openings.end(), random);
    RC_ASSERT(in_words(arrange(plan), plan) == in_words(arrange(shuffled), shuffled));
}

RC_GTEST_PROP(Arrange, RandomPolygonsDivideButNeverOpen, ()) {
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
