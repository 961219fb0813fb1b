// Spaces and their edges: rooms and walls.
#include <gtest/gtest.h>

#include <algorithm>

#include "plans/layout.h"
#include "plans/vector2.h"
#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::floor_findings;
using testing::FloorText;
using testing::read_floor;

/// Areas of the rooms that lie between the walls, largest first.
std::vector<double> found_areas(const Plan& plan) {
    const Layout layout = arrange(clean(plan));
    std::vector<double> areas;
    for (const StoreyLayout& storey : layout.storeys)
        for (const FoundRoom& room : storey.rooms) areas.push_back(room.area_m2);
    std::sort(areas.rbegin(), areas.rend());
    return areas;
}

TEST(FloorspaceWalls, SurroundASpace) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(plan.storeys.size(), 1u);
    const Storey& storey = plan.storeys[0];
    EXPECT_EQ(storey.name, "Ground");
    EXPECT_EQ(storey.walls.size(), 4u);
    ASSERT_EQ(storey.rooms.size(), 1u);
    EXPECT_EQ(storey.rooms[0].name, "Office");
    EXPECT_EQ(storey.rooms[0].id, "s0");
    EXPECT_EQ(storey.rooms[0].polygon.size(), 4u);
    EXPECT_TRUE(plan.findings.empty());
    const std::vector<double> areas = found_areas(plan);
    ASSERT_EQ(areas.size(), 1u);
    EXPECT_NEAR(areas[0], 3.9 * 2.9, 0.01);
}

TEST(FloorspaceWalls, AreSharedBySpacesSideBySide) {
    FloorText text;
    text.box("West", 0, 0, 4, 3);
    text.box("East", 4, 0, 8, 3);
    const Plan plan = read_floor({text.story()});
    EXPECT_EQ(plan.storeys[0].walls.size(), 7u);
    EXPECT_EQ(found_areas(plan).size(), 2u);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(FloorspaceWalls, GoOnStraightWhereNothingEnds) {
    FloorText text;
    text.space("Office", {{0, 0}, {1, 0}, {2.5, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 2}});
    const Plan plan = read_floor({text.story()});
    EXPECT_EQ(plan.storeys[0].walls.size(), 4u);
    EXPECT_EQ(plan.storeys[0].rooms[0].polygon.size(), 7u);
}

TEST(FloorspaceWalls, KeepSlightCorners) {
    // A corner of 3 mm to 2 m is one.
    FloorText text;
    text.space("Bay", {{0, 0}, {2, -0.003}, {4, 0}, {4, 3}, {0, 3}});
    EXPECT_EQ(read_floor({text.story()}).storeys[0].walls.size(), 5u);
}

TEST(FloorspaceWalls, HaveTheThicknessAskedForAndTheHeightOfTheirStorey) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    ReadOptions options;
    options.wall_thickness = 0.25;
    for (const Wall& wall : read_floor({text.story()}, options).storeys[0].walls) {
        EXPECT_EQ(wall.thickness, 0.25);
        EXPECT_EQ(wall.height_at_start, 3);
        EXPECT_EQ(wall.height_at_end, 3);
    }
}

TEST(FloorspaceWalls, AreThinnerAroundNarrowSpaces) {
    FloorText text;
    text.box("Hall", 0, 0, 6, 4);
    text.box("Duct", 6, 0, 6.3, 4);
    ReadOptions options;
    options.wall_thickness = 0.3;  // would fill the duct
    const Plan plan = read_floor({text.story()}, options);
    EXPECT_EQ(found_areas(plan).size(), 2u);
    const std::vector<Finding> findings = floor_findings(plan, "P763");
    ASSERT_EQ(findings.size(), 1u);
    ASSERT_EQ(findings[0].elements.size(), 1u);
    EXPECT_EQ(findings[0].elements[0].name, "Duct");
    std::size_t thick = 0;
    for (const Wall& wall : plan.storeys[0].walls) {
        EXPECT_GE(wall.thickness, 0.02);
        thick += wall.thickness == 0.3 ? 1 : 0;
    }
    EXPECT_EQ(thick, 3u);  // the hall's, but for the one that both share
}

TEST(FloorspaceWalls, OfASpaceTooNarrowForAnyLeaveNoRoom) {
    FloorText text;
    text.box("Hall", 0, 0, 6, 4);
    text.box("Gap", 6, 0, 6.02, 4);
    const Plan plan = read_floor({text.story()});
    EXPECT_EQ(found_areas(plan).size(), 1u);
    EXPECT_EQ(plan.storeys[0].rooms.size(), 1u);
    ASSERT_EQ(floor_findings(plan, "P764").size(), 1u);
    EXPECT_NE(floor_findings(plan, "P764")[0].sentence.find("\"Gap\""), std::string::npos);
}

TEST(FloorspaceWalls, AreBuiltOnceWhereEdgesLieOverEachOther) {
    // The east side of the hall is one edge, the offices beside it have two of their own.
    FloorText text;
    text.box("Hall", 0, 0, 4, 6);
    text.box("South", 4, 0, 8, 3);
    text.box("North", 4, 3, 8, 6);
    const Plan plan = read_floor({text.story()});
    EXPECT_EQ(plan.storeys[0].walls.size(), 10u);
    EXPECT_EQ(found_areas(plan).size(), 3u);
    ASSERT_EQ(floor_findings(plan, "P762").size(), 1u);
    EXPECT_NE(floor_findings(plan, "P762")[0].sentence.find("1 edge on which others end"), std::string::npos);
    EXPECT_TRUE(floor_findings(plan, "P761").empty());
}

TEST(FloorspaceWalls, AreBuiltOnceWhereAnEdgeIsDrawnTwice) {
    const std::string story = R"({"id":"g","floor_to_ceiling_height":3,"geometry":{"vertices":[
{"id":"1","x":0,"y":0},{"id":"2","x":4,"y":0},{"id":"3","x":4,"y":3},{"id":"4","x":0,"y":3},{"id":"5","x":0,"y":0},
{"id":"6","x":8,"y":0},{"id":"7","x":8,"y":3},{"id":"1","x":0,"y":0}],
"edges":[{"id":"a","vertex_ids":["1","2"]},{"id":"b","vertex_ids":["2","3"]},{"id":"c","vertex_ids":["3","4"]},
{"id":"d","vertex_ids":["4","5"]},{"id":"n","vertex_ids":["5","1"]},{"id":"a","vertex_ids":["1","2"]},
{"id":"e","vertex_ids":["2","6"]},{"id":"f","vertex_ids":["6","7"]},{"id":"g","vertex_ids":["7","3"]},
{"id":"h","vertex_ids":["3","2"]}],
"faces":[{"id":"i","edge_ids":["a","b","c","d","n"],"edge_order":[1,1,1,1,1]},
{"id":"j","edge_ids":["e","f","g","h"],"edge_order":[1,1,1,1]}]},
"spaces":[{"id":"p","name":"West","face_id":"i"},{"id":"q","name":"East","face_id":"j"}]})";
    const Plan plan = read_floor({story});
    EXPECT_EQ(plan.storeys[0].walls.size(), 7u);
    ASSERT_EQ(floor_findings(plan, "P762").size(), 1u);
    const std::string sentence = floor_findings(plan, "P762")[0].sentence;
    EXPECT_NE(sentence.find("1 edge without length"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("1 edge drawn twice"), std::string::npos) << sentence;
    EXPECT_EQ(found_areas(plan).size(), 2u);
}

TEST(FloorspaceWalls, CrossWhereSpacesOverlap) {
    FloorText text;
    text.box("Lying", 0, 2, 9, 5);
    text.box("Standing", 3, 0, 6, 9);
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(floor_findings(plan, "P761").size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P761")[0].elements.size(), 2u);
    EXPECT_NE(floor_findings(plan, "P762")[0].sentence.find("4 crossings"), std::string::npos);
    EXPECT_EQ(found_areas(plan).size(), 5u);
}

TEST(FloorspaceWalls, OfASpaceInsideAnotherAreSaidToOverlap) {
    FloorText text;
    text.box("Outer", 0, 0, 9, 9);
    text.box("Inner", 3, 3, 6, 6);
    EXPECT_EQ(floor_findings(read_floor({text.story()}), "P761").size(), 1u);
}

TEST(FloorspaceWalls, OfSpacesThatOverlapWithoutCrossingAreSaidToo) {
    // Sides on common lines: no edges cross.
    FloorText text;
    text.box("Low", 0, 0, 6, 6);
    text.box("High", 0, 3, 6, 9);
    EXPECT_EQ(floor_findings(read_floor({text.story()}), "P761").size(), 1u);
}

TEST(FloorspaceWalls, OfSpacesSideBySideDoNotOverlap) {
    FloorText text;
    text.box("A", 0, 0, 3, 3);
    text.box("B", 3, 0, 6, 3);
    text.box("C", 0, 3, 6, 6);
    text.box("D", 6, 6, 9, 9);
    EXPECT_TRUE(floor_findings(read_floor({text.story()}), "P761").empty());
}

TEST(FloorspaceWalls, StayFewWhereThousandsOfEdgesCross) {
    // Three million crossings: a small file must not ask for their memory.
    const int count = 2500;
    std::string vertices, edges, ids;
    for (int k = 0; k < count; ++k) {
        const std::string n = std::to_string(k);
        vertices += (k > 0 ? "," : "") + ("{\"id\":\"a" + n) + "\",\"x\":0,\"y\":" + n + "},{\"id\":\"b" + n +
                    "\",\"x\":1000,\"y\":" + std::to_string(count - k) + ".3}";
        edges += (k > 0 ? "," : "") + ("{\"id\":\"" + n) + "\",\"vertex_ids\":[\"a" + n + "\",\"b" + n + "\"]}";
        ids += (k > 0 ? ",\"" : "\"") + n + "\"";
    }
    const Plan plan = read_floor({"{\"id\":\"g\",\"floor_to_ceiling_height\":3,\"geometry\":{\"vertices\":[" +
                                  vertices + "],\"edges\":[" + edges + "],\"faces\":[{\"id\":\"f\",\"edge_ids\":[" +
                                  ids + "]}]},\"spaces\":[{\"face_id\":\"f\"}]}"});
    EXPECT_GT(plan.storeys[0].walls.size(), 2500u);
    EXPECT_LT(plan.storeys[0].walls.size(), 1000000u);
    EXPECT_EQ(floor_findings(plan, "P760").size(), 1u);
}

TEST(FloorspaceWalls, DoNotStandInSlits) {
    // The hall goes around the core: out to it along an edge, and back along the same.
    FloorText text;
    text.space("Hall", {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}, {3, 3}, {3, 6}, {6, 6}, {6, 3}, {3, 3}});
    text.box("Core", 3, 3, 6, 6);
    const Plan plan = read_floor({text.story()});
    EXPECT_EQ(plan.storeys[0].walls.size(), 8u);
    EXPECT_TRUE(floor_findings(plan, "P761").empty());
    const std::vector<double> areas = found_areas(plan);
    ASSERT_EQ(areas.size(), 2u);
    EXPECT_NEAR(areas[0], 8.9 * 8.9 - 3.1 * 3.1, 0.02);
    const Layout layout = arrange(clean(plan));
    for (const FoundRoom& room : layout.storeys[0].rooms) EXPECT_FALSE(room.name.empty());
}

TEST(FloorspaceRooms, AreCourtyardsWhereSpacesSurroundNone) {
    FloorText text;
    text.box("S", 0, 0, 9, 3);
    text.box("N", 0, 6, 9, 9);
    text.box("W", 0, 3, 3, 6);
    text.box("E", 6, 3, 9, 6);
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(plan.storeys[0].rooms.size(), 5u);
    const Room& courtyard = plan.storeys[0].rooms.back();
    EXPECT_EQ(courtyard.kind, "courtyard");
    EXPECT_EQ(courtyard.polygon.size(), 4u);
    for (const Point p : courtyard.polygon) {
        EXPECT_TRUE(p.x == 3 || p.x == 6);
        EXPECT_TRUE(p.y == 3 || p.y == 6);
    }
    ASSERT_EQ(floor_findings(plan, "P768").size(), 1u);
    EXPECT_NE(floor_findings(plan, "P768")[0].sentence.find("9 m2"), std::string::npos);
}

TEST(FloorspaceRooms, AreNoCourtyardsWhereAnotherSpaceLies) {
    FloorText text;
    text.box("S", 0, 0, 9, 3);
    text.box("N", 0, 6, 9, 9);
    text.box("W", 0, 3, 3, 6);
    text.box("E", 6, 3, 9, 6);
    text.box("Middle", 3, 3, 6, 6);
    text.box("Apart", 20, 0, 23, 3);
    EXPECT_EQ(read_floor({text.story()}).storeys[0].rooms.size(), 6u);
}

/// Four spaces around 3..6 in both directions.
FloorText ring_of_spaces() {
    FloorText text;
    text.box("S", 0, 0, 9, 3);
    text.box("N", 0, 6, 9, 9);
    text.box("W", 0, 3, 3, 6);
    text.box("E", 6, 3, 9, 6);
    return text;
}

std::size_t courtyards(const Storey& storey) {
    return std::size_t(std::count_if(storey.rooms.begin(), storey.rooms.end(),
                                     [](const Room& room) { return room.kind == "courtyard"; }));
}

TEST(FloorspaceRooms, AreNoCourtyardsUnderStoreysThatCoverThem) {
    FloorText above;
    above.box("All", 0, 0, 9, 9);
    const Plan plan = read_floor({ring_of_spaces().story(), above.story()});
    EXPECT_EQ(courtyards(plan.storeys[0]), 0u);
    ASSERT_EQ(floor_findings(plan, "P768").size(), 1u);
    EXPECT_NE(floor_findings(plan, "P768")[0].sentence.find("without a name"), std::string::npos);
}

TEST(FloorspaceRooms, AreCourtyardsThroughSeveralStoreysUpToTheSky) {
    const std::string ring = ring_of_spaces().story();
    const Plan open = read_floor({ring, ring, ring});
    for (const Storey& storey : open.storeys) EXPECT_EQ(courtyards(storey), 1u);
    FloorText roof;
    roof.box("All", 0, 0, 9, 9);
    const Plan closed = read_floor({ring, ring, ring, roof.story()});
    for (const Storey& storey : closed.storeys) EXPECT_EQ(courtyards(storey), 0u);
}

TEST(FloorspaceRooms, AreCourtyardsUnderStoreysThatLeaveThemASmallSky) {
    // The ring above is narrower, or covers but a part.
    FloorText above;
    above.box("S", 0, 0, 9, 4);
    above.box("N", 0, 5, 9, 9);
    above.box("W", 0, 4, 4, 5);
    above.box("E", 5, 4, 9, 5);
    EXPECT_EQ(courtyards(read_floor({ring_of_spaces().story(), above.story()}).storeys[0]), 1u);
    FloorText half;
    half.box("Half", 0, 0, 9, 4);
    EXPECT_EQ(courtyards(read_floor({ring_of_spaces().story(), half.story()}).storeys[0]), 1u);
}

TEST(FloorspaceRooms, TakeTheirKindFromTheirNameOrSpaceType) {
    FloorText text;
    text.box("Corridor 2", 0, 0, 9, 2);
    text.box("B-17", 0, 2, 9, 5, "\"space_type_id\":\"t\"");
    std::string plan_text = testing::floor_plan({text.story()});
    plan_text.insert(1, R"("space_types":[{"id":"t","name":"Restroom - Office"}],)");
    const Plan plan = read_floorspace(plan_text, "floor.json");
    EXPECT_EQ(plan.storeys[0].rooms[0].kind, "corridor");
    EXPECT_EQ(plan.storeys[0].rooms[1].kind, "bathroom");
}

TEST(FloorspaceRooms, OfSpacesWithoutOutlineAreListed) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    std::string story = text.story();
    story.insert(story.find("\"spaces\":[") + 10, R"({"id":"x","name":"Lost","face_id":null},
{"id":"y","name":"Gone","face_id":"nowhere"},{"id":"z","name":"Copy","face_id":"f0"},)");
    const Plan plan = read_floor({story});
    EXPECT_EQ(plan.storeys[0].rooms.size(), 1u);
    ASSERT_EQ(floor_findings(plan, "P759").size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P759")[0].elements.size(), 2u);
    EXPECT_EQ(floor_findings(plan, "P761").size(), 1u);  // whoever comes second
}

TEST(FloorspaceRooms, LoseTheirNameWhereTheirEdgesDoNotGoAround) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    std::string story = text.story();
    const std::string edges = R"(["e0","e1","e2","e3"])";
    story.replace(story.find(edges), edges.size(), R"(["e0","e2","e1","e3"])");
    const Plan plan = read_floor({story});
    EXPECT_EQ(plan.storeys[0].walls.size(), 4u);
    EXPECT_TRUE(plan.storeys[0].rooms.empty());
    ASSERT_EQ(floor_findings(plan, "P760").size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P760")[0].severity, Severity::Error);
}

TEST(FloorspaceRooms, DoNotNeedTheRightEdgeOrder) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3);
    std::string story = text.story();
    const std::size_t at = story.find("[1,1,1,1]");
    story.replace(at, 9, "[1,0,1,0]");
    const Plan plan = read_floor({story});
    ASSERT_EQ(plan.storeys[0].rooms.size(), 1u);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(FloorspaceRooms, LeaveOutWhatHasNoPlaceInAPlan) {
    FloorText text;
    text.box("Office", 0, 0, 4, 3, "\"pitched_roof_id\":\"r\"");
    std::string story = text.story();
    story.replace(story.find("\"shading\":[]"), 12, "\"shading\":[{\"id\":\"sh\",\"face_id\":\"f0\"}]");
    story.insert(story.find("\"edges\":[") + 9, R"({"id":"loose","vertex_ids":["v0","v2"]},)");
    const Plan plan = read_floorspace(
        testing::floor_plan({story}, R"({"config":{"units":"si"},"north_axis":12.5,"ground":{"tilt_slope":0.1}})"),
        "floor.json");
    EXPECT_EQ(plan.storeys[0].walls.size(), 4u);
    const std::vector<Finding> findings = floor_findings(plan, "P767");
    ASSERT_EQ(findings.size(), 2u);
    for (const char* what : {"1 shading surface", "1 pitched roof", "1 edge of no face"})
        EXPECT_NE(findings[0].sentence.find(what), std::string::npos) << findings[0].sentence;
    for (const char* what : {"12.5 degrees", "slope"})
        EXPECT_NE(findings[1].sentence.find(what), std::string::npos) << findings[1].sentence;
}

}  // namespace
}  // namespace enfilade::plans
