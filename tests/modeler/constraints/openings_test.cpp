// S2: doors and windows join two places, and sit in the wall that the plan names.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

using plans::OpeningKind;

std::vector<Finding> findings_of(const plans::Plan& plan) {
    const Building building = build(plan);
    const CheckReport whole = check(building), convex = check(convexify(building));
    EXPECT_EQ(testing::all_of(whole), testing::all_of(convex));
    std::vector<Finding> found;
    for (const Finding& finding : whole.findings)
        if (finding.code == "S2") found.push_back(finding);
    return found;
}

TEST(Openings, FindsEachOpeningThatIsNotWhereThePlanHasIt) { testing::expect_found(testing::inject_s2, 30); }

TEST(Openings, WarnsOfADoorBehindWhichAWallStands) {
    plans::Plan plan = testing::one_room();
    // Against the outer face of the south wall, along all of its door.
    plan.storeys[0].walls.push_back(testing::wall("shield", {0.2, -0.225}, {1.8, -0.225}, 0.2));
    const auto found = findings_of(plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Warning);
    EXPECT_NE(found[0].sentence.find("\"shield\""), std::string::npos) << found[0].sentence;
    EXPECT_EQ(found[0].elements[0].id, "door");
    EXPECT_NEAR((*found[0].point)[0], 1, 1e-9);
    EXPECT_NEAR((*found[0].point)[1], 0, 1e-9);
    EXPECT_NEAR((*found[0].point)[2], 1, 1e-9);
}

/// The plan has nothing before the door: that it is closed is the model's fault, and an error.
TEST(Openings, AnErrorWhereTheModelClosesWhatThePlanLeavesOpen) {
    for (const char* door : {"door", "inner door"}) {
        Building building = build(testing::two_rooms());
        const auto space_of = [&](const std::string& id) {
            for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
                if (building.spaces[s].id == id) return s;
            return UINT32_MAX;
        };
        // A room that only this door and no window touches on one side becomes solid.
        std::uint32_t room = UINT32_MAX;
        for (const Face& face : building.faces)
            for (const auto& [a, b] : {std::pair(face.front, face.back), std::pair(face.back, face.front)})
                if (building.volumes[a].space == space_of(door) && building.volumes[b].label == Label::Room) room = b;
        ASSERT_NE(room, UINT32_MAX);
        building.volumes[room].label = Label::Wall;
        building.volumes[room].space = space_of("n");
        bool is_error = false;
        for (const Finding& finding : check(building).findings)
            is_error = is_error ||
                       (finding.code == "S2" && finding.severity == Severity::Error && finding.elements[0].id == door);
        EXPECT_TRUE(is_error) << door << "\n" << testing::all_of(check(building));
    }
}

TEST(Openings, AcceptsADoorThatAWallHalfCovers) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("shield", {0.2, -0.225}, {1.2, -0.225}, 0.2));
    EXPECT_TRUE(findings_of(plan).empty());
}

TEST(Openings, WarnsOfADoorWithOneRoomOnBothSides) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("spur", {2, 0}, {2, 2}, 0.125));
    plan.storeys[0].openings.push_back(testing::opening("inner", OpeningKind::Door, "spur", 1.2, 0.8, 0, 2));
    const auto found = findings_of(plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Warning);
    EXPECT_NE(found[0].sentence.find("both"), std::string::npos);
}

TEST(Openings, AcceptsAPassageWithoutLeafWithinOneRoom) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("spur", {2, 0}, {2, 2}, 0.125));
    plan.storeys[0].openings.push_back(testing::opening("inner", OpeningKind::Opening, "spur", 1.2, 0.8, 0, 2));
    EXPECT_TRUE(findings_of(plan).empty());
}

TEST(Openings, AcceptsDoorsInArcsAtEndsAndAsHighAsTheirWall) {
    plans::Plan plan = testing::one_room();
    plans::Storey& ground = plan.storeys[0];
    plans::Wall arc = testing::wall("arc", {0, 1.5}, {4, 1.5}, 0.125);
    arc.arc_extent = 0.8;
    ground.walls.push_back(arc);
    ground.openings.push_back(testing::opening("in arc", OpeningKind::Door, "arc", 1.4, 0.8, 0, 2));
    ground.openings.push_back(testing::opening("full", OpeningKind::Door, "e", 2.3, 0.9, 0, 2.5));
    EXPECT_TRUE(findings_of(plan).empty());
}

TEST(Openings, AcceptsAShutDoorAndOpaqueGlass) {
    plans::Plan plan = testing::two_rooms();
    for (plans::Opening& opening : plan.storeys[0].openings) opening.open_angle = 0;
    BuildOptions options;
    options.opaque_glass = true;
    const Building building = build(plan, options);
    EXPECT_EQ(check(building).count("S2"), 0u);
    EXPECT_EQ(check(convexify(building)).count("S2"), 0u);
}

TEST(Openings, SaysNothingAgainOfWhatThePlanStageLeftOut) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].openings.push_back(testing::opening("beyond", OpeningKind::Window, "e", 9, 1, 1, 2));
    EXPECT_TRUE(findings_of(plan).empty());
}

}  // namespace
}  // namespace enfilade::modeler
