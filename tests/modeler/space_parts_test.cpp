#include "modeler/space_parts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/convexify.h"
#include "modeler/outline.h"
#include "plans/read.h"
#include "tests/support/random_plan.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

std::vector<SpacePart> parts_of(const Building& building, Label label) {
    std::vector<SpacePart> parts = space_parts(building);
    std::erase_if(parts, [&](const SpacePart& part) { return building.spaces[part.space].label != label; });
    return parts;
}

/// Twice the area of the pieces under some volumes, in grid units.
std::int64_t pieces_area2(const Building& building, const std::vector<std::uint32_t>& volumes) {
    std::int64_t sum = 0;
    for (const std::uint32_t v : volumes) {
        const Piece& piece = building.pieces[building.volumes[v].piece];
        const auto point = [&](std::uint32_t k) {
            return building.points[building.corners[piece.first_corner + k % piece.corner_count].vertex];
        };
        for (std::uint32_t k = 1; k + 1 < piece.corner_count; ++k) sum += orientation(point(0), point(k), point(k + 1));
    }
    return sum;
}

/// A floor of 6 m x 4 m with two columns that touch in a corner, and one whose corner touches a wall.
plans::Plan touching_columns() {
    plans::Plan plan;
    plan.name = "touching columns";
    plans::Storey ground = testing::storey("ground");
    testing::add_box(ground, "", 6, 4);
    ground.columns.push_back({"c1", "", {{2, 1}, {2.5, 1}, {2.5, 1.5}, {2, 1.5}}, 0});
    ground.columns.push_back({"c2", "", {{2.5, 1.5}, {3, 1.5}, {3, 2}, {2.5, 2}}, 0});
    ground.columns.push_back({"c3", "", {{4.5, 0.125}, {5, 0.625}, {4.5, 1.125}, {4, 0.625}}, 0});
    plan.storeys.push_back(ground);
    return plan;
}

void expect_sound_parts(const Building& building) {
    const std::vector<SpacePart> parts = space_parts(building);
    std::set<std::uint32_t> seen;
    for (const SpacePart& part : parts) {
        EXPECT_TRUE(std::is_sorted(part.volumes.begin(), part.volumes.end()));
        for (const std::uint32_t v : part.volumes) {
            EXPECT_TRUE(seen.insert(v).second) << "a volume in two parts";
            EXPECT_EQ(building.volumes[v].space, part.space);
            EXPECT_EQ(building.volumes[v].z_low, part.z_low);
            EXPECT_EQ(building.volumes[v].z_high, part.z_high);
        }
        const double unit = building.frame.unit;
        EXPECT_EQ(area_m2(building, part), double(pieces_area2(building, part.volumes)) / 2 * unit * unit);
        const auto expect_simple = [&](const HalfEdgeRing& ring) {
            std::set<std::uint32_t> visited;
            for (std::size_t k = 0; k < ring.size(); ++k) {
                EXPECT_TRUE(visited.insert(start_of(building, ring[k])).second) << "a ring visits a point twice";
                EXPECT_EQ(start_of(building, ring[k] ^ 1), start_of(building, ring[(k + 1) % ring.size()]));
            }
        };
        expect_simple(part.outer);
        for (const HalfEdgeRing& hole : part.holes) expect_simple(hole);
    }
    EXPECT_EQ(seen.size() + 1, building.volumes.size()) << "all volumes but Outside";
}

/// What does not change with the cuts: space, levels, area and drawn outlines of each part, sorted.
using Shape = std::tuple<std::uint32_t, std::int32_t, std::int32_t, double, std::vector<std::set<plans::GridPoint>>>;
std::vector<Shape> shapes(const Building& building) {
    std::vector<Shape> all;
    for (const SpacePart& part : space_parts(building)) {
        std::vector<std::set<plans::GridPoint>> rings;
        const auto add = [&](const HalfEdgeRing& ring) {
            rings.emplace_back();
            for (const std::uint32_t p : drawn_corners(building, ring)) rings.back().insert(building.points[p]);
        };
        add(part.outer);
        for (const HalfEdgeRing& hole : part.holes) add(hole);
        std::sort(rings.begin(), rings.end());
        all.push_back({part.space, part.z_low, part.z_high, area_m2(building, part), rings});
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Crossing number, in metres.
bool is_inside(const Building& building, const SpacePart& part, std::array<double, 2> at) {
    bool inside = false;
    const auto cross = [&](const HalfEdgeRing& ring) {
        for (const std::uint32_t h : ring) {
            const plans::GridPoint p = building.points[start_of(building, h)];
            const plans::GridPoint q = building.points[start_of(building, h ^ 1)];
            const double px = building.frame.world_x(p.x), py = building.frame.world_y(p.y);
            const double qx = building.frame.world_x(q.x), qy = building.frame.world_y(q.y);
            if ((py > at[1]) != (qy > at[1]) && at[0] < (qx - px) * (at[1] - py) / (qy - py) + px) inside = !inside;
        }
    };
    cross(part.outer);
    for (const HalfEdgeRing& hole : part.holes) cross(hole);
    return inside;
}

TEST(SpaceParts, ARoomIsOnePrismWithFourCorners) {
    const Building building = build(testing::one_room());
    const std::vector<SpacePart> rooms = parts_of(building, Label::Room);
    ASSERT_EQ(rooms.size(), 1u);
    EXPECT_EQ(area_m2(building, rooms[0]), 3.75 * 2.75);
    EXPECT_TRUE(rooms[0].holes.empty());
    EXPECT_GT(rooms[0].outer.size(), 4u) << "the door's jambs end there";
    EXPECT_EQ(drawn_corners(building, rooms[0].outer).size(), 4u);
    EXPECT_EQ(label_point(building, rooms[0]), (std::array<double, 2>{2, 1.5}));
}

TEST(SpaceParts, AColumnIsAHoleInItsRoom) {
    const Building building = convexify(build(testing::ring_room()));
    const std::vector<SpacePart> rooms = parts_of(building, Label::Room);
    ASSERT_EQ(rooms.size(), 1u);
    ASSERT_EQ(rooms[0].holes.size(), 1u);
    EXPECT_EQ(drawn_corners(building, rooms[0].holes[0]).size(), 4u);
    EXPECT_EQ(area_m2(building, rooms[0]), 3.75 * 2.75 - 0.25);
    EXPECT_TRUE(is_inside(building, rooms[0], label_point(building, rooms[0])));
}

TEST(SpaceParts, RingsThatTouchInAPointStayApart) {
    for (const Building& building : {build(touching_columns()), convexify(build(touching_columns()))}) {
        const std::vector<SpacePart> rooms = parts_of(building, Label::Room);
        ASSERT_EQ(rooms.size(), 1u);
        EXPECT_EQ(rooms[0].holes.size(), 3u);
        EXPECT_EQ(drawn_corners(building, rooms[0].outer).size(), 4u);
        EXPECT_EQ(area_m2(building, rooms[0]), 5.75 * 3.75 - 0.25 - 0.25 - 0.5);
        expect_sound_parts(building);
    }
}

TEST(SpaceParts, AWallCutByADoorHasItsPartsAboveAndBeside) {
    const Building building = build(testing::one_room());
    std::vector<double> areas;
    for (const SpacePart& part : parts_of(building, Label::Wall))
        if (building.spaces[part.space].id == "s") areas.push_back(area_m2(building, part));
    ASSERT_EQ(areas.size(), 3u) << "left of the door, right of it, above it";
    EXPECT_EQ(std::count(areas.begin(), areas.end(), 0.25), 1) << "the lintel over 1 m x 0.25 m";
}

TEST(SpaceParts, AreTheSameBeforeAndAfterTheCutsIntoCells) {
    for (const plans::Plan& plan : {testing::one_room(), testing::two_rooms(), testing::ring_room(),
                                    testing::two_storeys(), touching_columns()}) {
        const Building whole = build(plan);
        EXPECT_EQ(shapes(whole), shapes(convexify(whole))) << plan.name;
    }
}

TEST(SpaceParts, ComeInOrder) {
    const Building building = convexify(build(testing::two_storeys()));
    const std::vector<SpacePart> parts = space_parts(building);
    EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end(), [](const SpacePart& a, const SpacePart& b) {
        return std::tuple(a.space, a.z_low, a.volumes[0]) < std::tuple(b.space, b.z_low, b.volumes[0]);
    }));
    expect_sound_parts(building);
}

TEST(SpaceParts, PiecesThatDoNotCloseAreRefused) {
    Building building = build(testing::one_room());
    for (Corner& corner : building.corners)
        if (building.edges[corner.half_edge / 2].a == corner.vertex || corner.half_edge % 2 == 1) {
            corner.half_edge = building.corners[&corner == &building.corners[0] ? 1 : 0].half_edge;
            break;
        }
    EXPECT_THROW((void)space_parts(building), InputError);
}

TEST(SpaceParts, CurvedWallsKeepTheirPoints) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls[2].arc_extent = 2;
    const Building building = convexify(build(plan));
    const std::vector<SpacePart> rooms = parts_of(building, Label::Room);
    ASSERT_EQ(rooms.size(), 1u);
    double drawn = 0;
    const std::vector<std::uint32_t> corners = drawn_corners(building, rooms[0].outer);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
        drawn += 0.5 * building.frame.unit * building.frame.unit *
                 double(orientation(building.points[corners[0]], building.points[corners[k]],
                                    building.points[corners[k + 1]]));
    EXPECT_GT(corners.size(), 15u);
    EXPECT_NEAR(drawn, area_m2(building, rooms[0]), 0.01);
}

TEST(SpaceParts, OfRealHomesAreSound) {
    const std::filesystem::path folder = std::filesystem::path(ENFILADE_SOURCE_DIR) / "../shared/data/sh3d";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no ../shared/data/sh3d beside the repository";
    for (const char* name : {"andijcr_ristrutturazione_default.sh3d", "abesalomi_v1.sh3d"}) {
        SCOPED_TRACE(name);
        const Building whole = build(plans::read(folder / name));
        expect_sound_parts(whole);
        const Building cells = convexify(whole);
        expect_sound_parts(cells);
        for (const SpacePart& room : parts_of(cells, Label::Room))
            EXPECT_TRUE(is_inside(cells, room, label_point(cells, room))) << cells.spaces[room.space].id;
    }
}

RC_GTEST_PROP(SpaceParts, OfAnyPlanAreSound, ()) {
    const plans::Plan plan = testing::any_plan();
    Building building;
    try {
        building = build(plan);
    } catch (const InputError&) {
        RC_DISCARD("nothing to build");
    }
    expect_sound_parts(building);
    const Building cells = convexify(building);
    expect_sound_parts(cells);
    for (const SpacePart& part : space_parts(cells)) RC_ASSERT(is_inside(cells, part, label_point(cells, part)));
    RC_ASSERT(!::testing::Test::HasFailure());
}

}  // namespace
}  // namespace enfilade::modeler
