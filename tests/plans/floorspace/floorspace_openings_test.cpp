// Doors and windows: where they stand, and how large they are.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plans/vector2.h"
#include "tests/plans/floorspace/floor_text.h"

namespace enfilade::plans {
namespace {

using testing::floor_findings;
using testing::FloorText;
using testing::read_floor;

/// One office of 6 x 4 m, walls 10 cm: e0 along y = 0, e1 along x = 6, e2 along y = 4, e3 along x = 0.
FloorText office() {
    FloorText text;
    text.box("Office", 0, 0, 6, 4);
    return text;
}

/// The middle of an opening in the plan.
Point place(const Storey& storey, const Opening& opening) {
    for (const Wall& wall : storey.walls)
        if (wall.id == opening.wall)
            return wall.start + (wall.end - wall.start) * (opening.offset / distance(wall.start, wall.end));
    ADD_FAILURE() << "no wall " << opening.wall;
    return {};
}

TEST(FloorspaceOpenings, StandAtTheirShareOfTheEdge) {
    FloorText text = office();
    text.window("w", "single", "e0", "0.25");
    text.door("d", "door", "e2", "0.25");  // runs from (6, 4) to (0, 4)
    const Plan plan = read_floor({text.story()});
    const Storey& storey = plan.storeys[0];
    ASSERT_EQ(storey.openings.size(), 2u);
    const Opening& window = storey.openings[0];
    EXPECT_EQ(window.id, "w");
    EXPECT_EQ(window.name, "Single");
    EXPECT_EQ(window.kind, OpeningKind::Window);
    EXPECT_NEAR(distance(place(storey, window), {1.5, 0}), 0, 1e-9);
    EXPECT_NEAR(window.width, 2, 1e-12);
    EXPECT_NEAR(window.sill, 0.9, 1e-12);
    EXPECT_NEAR(window.head, 2.4, 1e-12);
    const Opening& door = storey.openings[1];
    EXPECT_EQ(door.kind, OpeningKind::Door);
    EXPECT_EQ(door.name, "Oak door");
    EXPECT_NEAR(distance(place(storey, door), {4.5, 4}), 0, 1e-9);
    EXPECT_EQ(door.sill, 0);
    EXPECT_NEAR(door.head, 2.1, 1e-12);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(FloorspaceOpenings, StandInTheMiddleWithoutAShare) {
    FloorText text = office();
    text.window("w", "single", "e0", "null");
    const Plan plan = read_floor({text.story()});
    EXPECT_NEAR(place(plan.storeys[0], plan.storeys[0].openings[0]).x, 3, 1e-9);
}

TEST(FloorspaceOpenings, FindTheirPlaceInWallsOfSeveralEdges) {
    // The south side is three edges and one wall; the edge in the middle runs 2..4.
    FloorText text;
    text.space("Office", {{0, 0}, {2, 0}, {4, 0}, {6, 0}, {6, 4}, {0, 4}});
    text.door("d", "door", "e1", "0.75");
    const Plan plan = read_floor({text.story()});
    const Storey& storey = plan.storeys[0];
    EXPECT_EQ(storey.walls.size(), 4u);
    ASSERT_EQ(storey.openings.size(), 1u);
    EXPECT_NEAR(distance(place(storey, storey.openings[0]), {3.5, 0}), 0, 1e-9);
}

TEST(FloorspaceOpenings, FindTheirWallWhereTheirEdgeIsCutByOthers) {
    // One side of the hall, 0..6, beside two offices: two walls.
    FloorText text;
    text.box("Hall", 0, 0, 4, 6);
    text.box("South", 4, 0, 8, 3);
    text.box("North", 4, 3, 8, 6);
    text.door("low", "door", "e1", "0.25");
    text.door("high", "door", "e1", "0.75");
    const Plan plan = read_floor({text.story()});
    const Storey& storey = plan.storeys[0];
    ASSERT_EQ(storey.openings.size(), 2u);
    EXPECT_NEAR(distance(place(storey, storey.openings[0]), {4, 1.5}), 0, 1e-9);
    EXPECT_NEAR(distance(place(storey, storey.openings[1]), {4, 4.5}), 0, 1e-9);
    EXPECT_NE(storey.openings[0].wall, storey.openings[1].wall);
}

TEST(FloorspaceOpenings, RepeatAtThePlacesThatTheFileGives) {
    FloorText text = office();
    text.window("w", "row", "e0", "[0.25, 0.5, 0.75]");
    const Plan plan = read_floor({text.story()});
    const Storey& storey = plan.storeys[0];
    ASSERT_EQ(storey.openings.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(place(storey, storey.openings[k]).x, 1.5 * double(k + 1), 1e-9);
    EXPECT_EQ(storey.openings[0].id, "w");
    EXPECT_EQ(storey.openings[1].id, "w-2");
}

TEST(FloorspaceOpenings, RepeatEvenlyWithoutPlaces) {
    // 1 m wide and 1 m apart on 6 m: as FloorspaceJS counts, 0.5, 2.5 and 4.5 fit; moved to the middle by 0.5.
    FloorText text = office();
    text.window("w", "row", "e0", "0.5");
    const Plan plan = read_floor({text.story()});
    const Storey& storey = plan.storeys[0];
    ASSERT_EQ(storey.openings.size(), 3u);
    EXPECT_NEAR(place(storey, storey.openings[0]).x, 1, 1e-9);
    EXPECT_NEAR(place(storey, storey.openings[1]).x, 3, 1e-9);
    EXPECT_NEAR(place(storey, storey.openings[2]).x, 5, 1e-9);
}

TEST(FloorspaceOpenings, OfARowWithoutRoomAreLeftOut) {
    FloorText text;
    text.box("Booth", 0, 0, 0.9, 3);
    text.window("w", "row", "e0", "0.5");
    const Plan plan = read_floor({text.story()});
    EXPECT_TRUE(plan.storeys[0].openings.empty());
    ASSERT_EQ(floor_findings(plan, "P769").size(), 1u);
}

TEST(FloorspaceOpenings, MeetTheirRatioOfGlass) {
    FloorText text = office();
    text.window("w", "half", "e0", "0.5");
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(plan.storeys[0].openings.size(), 1u);
    const Opening& window = plan.storeys[0].openings[0];
    EXPECT_NEAR(window.width * (window.head - window.sill), 0.5 * 6 * 3, 1e-9);
    EXPECT_LT(window.width, 5.9);  // clear of the walls beside
    EXPECT_NEAR(window.sill, 0.8, 1e-12);
    EXPECT_NEAR(window.offset, 3, 1e-9);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(FloorspaceOpenings, MeetTheirRatioInEachWallOfTheirEdge) {
    FloorText text;
    text.box("Hall", 0, 0, 4, 6);
    text.box("South", 4, 0, 8, 2);
    text.box("North", 4, 2, 8, 6);
    text.window("w", "half", "e1", "0.5");
    const Plan plan = read_floor({text.story()});
    ASSERT_EQ(plan.storeys[0].openings.size(), 2u);
    double glass = 0;
    for (const Opening& window : plan.storeys[0].openings) glass += window.width * (window.head - window.sill);
    EXPECT_NEAR(glass, 0.5 * 6 * 3, 1e-9);
}

TEST(FloorspaceOpenings, LowerTheirSillToMeetTheirRatio) {
    FloorText text = office();
    text.window("w", "half", "e0", "0.5");
    std::string plan_text = testing::floor_plan({text.story()});
    plan_text.replace(plan_text.find("\"wwr\":0.5"), 9, "\"wwr\":0.8");
    const Plan plan = read_floorspace(plan_text, "floor.json");
    const Opening& window = plan.storeys[0].openings.at(0);
    EXPECT_NEAR(window.width * (window.head - window.sill), 0.8 * 6 * 3, 1e-9);
    EXPECT_LT(window.sill, 0.8);
    EXPECT_NEAR(window.head, 3 - 0.0254, 1e-9);
}

TEST(FloorspaceOpenings, SayWhereTheirRatioCannotBeMet) {
    FloorText text = office();
    text.window("w", "half", "e0", "0.5");
    std::string plan_text = testing::floor_plan({text.story()});
    plan_text.replace(plan_text.find("\"wwr\":0.5"), 9, "\"wwr\":0.999");
    const Plan plan = read_floorspace(plan_text, "floor.json");
    ASSERT_EQ(plan.storeys[0].openings.size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P769").size(), 1u);
}

TEST(FloorspaceOpenings, KeepClearOfTheWallsBeside) {
    FloorText text = office();
    text.door("d", "door", "e0", "0.07");  // 0.42 m from the corner: its edge is on the axis of the wall beside
    const Plan plan = read_floor({text.story()});
    const Opening& door = plan.storeys[0].openings.at(0);
    EXPECT_NEAR(door.width, 0.9, 1e-12);
    EXPECT_GT(door.offset - door.width / 2, 0.05);
    ASSERT_EQ(floor_findings(plan, "P766").size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P766")[0].severity, Severity::Note);
    EXPECT_NEAR(floor_findings(plan, "P766")[0].moved_mm, 90, 1);
}

TEST(FloorspaceOpenings, HaveRoomBesideBluntCorners) {
    // The sides of a round hall meet at 174 degrees: its windows reach almost from corner to corner.
    FloorText text;
    std::vector<std::pair<double, double>> ring;
    for (int k = 0; k < 60; ++k)
        ring.emplace_back(10 * std::cos(k * std::numbers::pi / 30), 10 * std::sin(k * std::numbers::pi / 30));
    text.space("Hall", ring);
    for (int k = 0; k < 60; ++k) text.window("w" + std::to_string(k), "half", "e" + std::to_string(k), "0.5");
    const Plan plan = clean(read_floor({text.story()}));
    EXPECT_TRUE(plan.findings.empty());
    EXPECT_EQ(plan.storeys[0].openings.size(), 60u);
}

TEST(FloorspaceOpenings, KeepClearOfSharpCorners) {
    // 30 degrees: the inner faces of walls of 10 cm meet 19 cm from the corner.
    FloorText text;
    text.space("Wedge", {{0, 0}, {8, 0}, {8 * std::cos(std::numbers::pi / 6), 4}});
    text.door("d", "door", "e0", "0");
    const Plan plan = read_floor({text.story()});
    const Opening& door = plan.storeys[0].openings.at(0);
    EXPECT_NEAR(door.offset - door.width / 2, 0.05 * (1 + std::cos(std::numbers::pi / 6)) / 0.5 + 0.01, 1e-3);
}

TEST(FloorspaceOpenings, AreMadeNarrowerThanTheirWall) {
    FloorText text;
    text.box("Booth", 0, 0, 1.5, 3);
    text.window("w", "single", "e0", "0.5");
    const Plan plan = read_floor({text.story()});
    const Opening& window = plan.storeys[0].openings.at(0);
    EXPECT_LT(window.width, 1.4);
    EXPECT_GT(window.width, 1.3);
    ASSERT_EQ(floor_findings(plan, "P766").size(), 1u);
    EXPECT_EQ(floor_findings(plan, "P766")[0].severity, Severity::Warning);
}

TEST(FloorspaceOpenings, WithoutAPlaceAreErrors) {
    FloorText text = office();
    text.window("lost-definition", "nowhere", "e0", "0.5");
    text.window("lost-edge", "single", "nowhere", "0.5");
    text.door("no-space", "door", "loose", "0.5");
    std::string story = text.story();
    story.insert(story.find("\"edges\":[") + 9, R"({"id":"loose","vertex_ids":["v0","v2"]},)");
    const Plan plan = read_floor({story});
    EXPECT_TRUE(plan.storeys[0].openings.empty());
    const std::vector<Finding> findings = floor_findings(plan, "P765");
    ASSERT_EQ(findings.size(), 3u);
    for (const Finding& finding : findings) EXPECT_EQ(finding.severity, Severity::Error);
    EXPECT_NE(findings[0].sentence.find("definition"), std::string::npos);
    EXPECT_NE(findings[1].sentence.find("edge"), std::string::npos);
    EXPECT_NE(findings[2].sentence.find("without a space"), std::string::npos);
    EXPECT_EQ(findings[2].elements.at(0).id, "no-space");
}

TEST(FloorspaceOpenings, WithoutSizeAreErrors) {
    FloorText text = office();
    text.window("w", "single", "e0", "0.5");
    std::string plan_text = testing::floor_plan({text.story()});
    plan_text.replace(plan_text.find("\"width\":2"), 9, "\"width\":null");
    const Plan plan = read_floorspace(plan_text, "floor.json");
    EXPECT_TRUE(plan.storeys[0].openings.empty());
    EXPECT_EQ(floor_findings(plan, "P765").size(), 1u);
}

TEST(FloorspaceOpenings, InRowsAreBounded) {
    FloorText text;
    text.box("Long", 0, 0, 9e6, 4);
    text.window("w", "row", "e0", "0.5");
    const Plan plan = read_floor({text.story()});
    EXPECT_TRUE(plan.storeys[0].openings.empty());
    EXPECT_EQ(floor_findings(plan, "P765").size(), 1u);
}

TEST(FloorspaceOpenings, OfVersionThreeNameTheirDefinitionOtherwise) {
    FloorText text = office();
    std::string story = text.story();
    story.replace(story.find("\"windows\":[]"), 12, R"("windows":[{"window_id":1,"edge_id":"e0","alpha":0.5}])");
    const Plan plan = read_floorspace(
        R"({"windows":[{"id":1,"window_definition_type":"Single Window","width":2,"height":1,"sill_height":1}],
"project":{"config":{"units":"m"}},"stories":[)" +
            story + "]}",
        "floor.json");
    ASSERT_EQ(plan.storeys[0].openings.size(), 1u);
    EXPECT_EQ(plan.storeys[0].openings[0].id, "e0-window");
}

TEST(FloorspaceOpenings, AreLeftAloneByCleaning) {
    FloorText text = office();
    text.window("a", "half", "e0", "0.5");
    text.window("b", "row", "e2", "0.5");
    text.door("c", "door", "e3", "0.02");
    const Plan plan = clean(read_floor({text.story()}));
    for (const Finding& finding : plan.findings) EXPECT_EQ(finding.code, "P766") << finding.sentence;
    EXPECT_EQ(plan.storeys[0].openings.size(), 5u);
}

}  // namespace
}  // namespace enfilade::plans
