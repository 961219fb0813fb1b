// S5: one exterior, and a way to it from every room that people use.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

std::vector<Finding> findings_of(const plans::Plan& plan) {
    const Building building = build(plan);
    const CheckReport whole = check(building);
    EXPECT_EQ(testing::all_of(whole), testing::all_of(check(convexify(building))));
    std::vector<Finding> found;
    for (const Finding& finding : whole.findings)
        if (finding.code == "S5") found.push_back(finding);
    return found;
}

TEST(Access, FindsEachRoomWithoutAWayOutAndEachSecondExterior) { testing::expect_found(testing::inject_s5, 30); }

TEST(Access, WindowsAreNoWayOut) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].openings[0].kind = plans::OpeningKind::Window;
    const auto found = findings_of(plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Warning);
    EXPECT_EQ(found[0].elements[0].kind, "room");
    EXPECT_EQ(found[0].storey, "ground");
}

TEST(Access, ShutDoorsAreAWayOut) {
    plans::Plan plan = testing::two_rooms();
    for (plans::Opening& opening : plan.storeys[0].openings) opening.open_angle = 0;
    EXPECT_TRUE(findings_of(plan).empty());
}

TEST(Access, SmallUnnamedPlacesNeedNone) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("duct", {3, 0}, {3, 3}, 0.1));
    EXPECT_EQ(findings_of(plan).size(), 1u) << "2.3 m2";
    plan.storeys[0].walls.back().start.x = plan.storeys[0].walls.back().end.x = 3.4;
    EXPECT_TRUE(findings_of(plan).empty()) << "1.2 m2";
    plans::Room room;
    room.id = room.name = "larder";
    room.polygon = {{3.5, 0.2}, {3.8, 0.2}, {3.8, 2.8}, {3.5, 2.8}};
    plan.storeys[0].rooms = {room};
    EXPECT_EQ(findings_of(plan).size(), 1u) << "the plan names it";
    plan.storeys[0].rooms[0].kind = "duct";
    EXPECT_TRUE(findings_of(plan).empty()) << "nobody uses it";
}

TEST(Access, OneMissingDoorIsOneWarningForAllRoomsBehindIt) {
    plans::Plan plan = testing::two_rooms();
    plan.storeys[0].openings.erase(plan.storeys[0].openings.begin());
    const auto found = findings_of(plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].elements.size(), 2u);
    EXPECT_NE(found[0].sentence.find("1 room"), std::string::npos) << found[0].sentence;
}

TEST(Access, ALowSillCanBeSteppedOverAHighOneCannot) {
    plans::Plan plan = testing::one_room();
    plans::Opening& hole = plan.storeys[0].openings[0];
    hole.kind = plans::OpeningKind::Opening;
    hole.sill = 0.4;
    EXPECT_TRUE(findings_of(plan).empty());
    hole.sill = 0.9;
    EXPECT_EQ(findings_of(plan).size(), 1u);
}

TEST(Access, CourtyardsAreOneWithTheSky) {
    plans::Plan plan = testing::one_room();
    plans::Storey& ground = plan.storeys[0];
    testing::add_box(ground, "outer ", 20, 20);
    for (plans::Wall& wall : ground.walls)
        if (!wall.id.starts_with("outer")) wall.start.x += 5, wall.end.x += 5, wall.start.y += 5, wall.end.y += 5;
    plans::Room court;
    court.id = court.name = "court";
    court.kind = "courtyard";
    court.polygon = {{5.2, 5.2}, {8.8, 5.2}, {8.8, 7.8}, {5.2, 7.8}};
    ground.rooms = {court};
    EXPECT_TRUE(findings_of(plan).empty());
}

}  // namespace
}  // namespace enfilade::modeler
