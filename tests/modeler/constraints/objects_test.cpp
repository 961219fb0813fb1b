// S6: objects lie inside one room, are disjoint and keep out of door sweeps.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

plans::Furniture piece(std::string id, double x, double y, double width, double depth, double height) {
    plans::Furniture result;
    result.id = std::move(id);
    result.position = {x, y};
    result.width = width;
    result.depth = depth;
    result.height = height;
    return result;
}

/// One room of 4 m x 3 m between axes, a door around (1, 0), with furniture.
std::vector<Finding> findings_of(std::vector<plans::Furniture> furniture) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].furniture = std::move(furniture);
    const Building building = build(plan);
    const CheckReport whole = check(building);
    EXPECT_EQ(testing::all_of(whole), testing::all_of(check(convexify(building))));
    std::vector<Finding> found;
    for (const Finding& finding : whole.findings)
        if (finding.code == "S6") found.push_back(finding);
    return found;
}

TEST(Objects, FindsEachPieceThatCannotStandWhereItDoes) { testing::expect_found(testing::inject_s6, 30); }

TEST(Objects, NamesThePieceInTheWallAndHowDeepItStandsThere) {
    const auto found = findings_of({piece("cupboard", 3.7, 2, 0.6, 1, 1.8)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Warning);
    // Its right side at 4.0, the inner face of the wall at 3.875.
    EXPECT_NE(found[0].sentence.find("125 mm in wall \"e\""), std::string::npos) << found[0].sentence;
    EXPECT_EQ(found[0].elements[0].id, "cupboard");
    EXPECT_NEAR((*found[0].point)[0], 3.94, 0.07);
    EXPECT_NEAR((*found[0].point)[1], 2, 0.01);
    EXPECT_EQ(found[0].storey, "ground");
}

TEST(Objects, AcceptsWhatPeopleDraw) {
    plans::Furniture turned = piece("turned", 2, 1.5, 0.8, 0.6, 0.75);
    turned.angle = 0.7;
    plans::Furniture lamp = piece("lamp", 2, 1.5, 0.4, 0.4, 0.4);
    lamp.elevation = 2;
    plans::Furniture vase = piece("vase", 2, 1.5, 0.2, 0.2, 0.3);
    vase.elevation = 0.75;
    EXPECT_TRUE(findings_of({turned, lamp, vase}).empty());
    EXPECT_TRUE(findings_of({piece("cupboard", 3.6, 2, 0.6, 1, 1.8)}).empty()) << "25 mm in the wall";
    EXPECT_TRUE(findings_of({piece("picture", 3.9, 2, 0.05, 1, 0.8)}).empty()) << "thin";
    EXPECT_TRUE(findings_of({piece("window", 4, 2, 0.25, 1, 1)}).empty()) << "built into the wall";
    EXPECT_TRUE(findings_of({piece("table", 2, 2, 1.6, 0.8, 0.75), piece("chair", 2, 1.5, 0.5, 0.5, 0.9)}).empty());
    EXPECT_TRUE(findings_of({piece("worktop", 2, 2.5, 2, 0.6, 0.9), piece("sink", 2, 2.5, 0.6, 0.5, 0.95)}).empty());
    EXPECT_TRUE(findings_of({piece("rug", 1, 0.5, 1, 0.7, 0.01)}).empty()) << "the door goes over it";
}

TEST(Objects, NamesOnePiecePlacedTwice) {
    const auto found = findings_of({piece("a", 2, 1.5, 0.6, 0.6, 0.5), piece("b", 2.05, 1.5, 0.6, 0.6, 0.5)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].elements[0].id, "a");
    EXPECT_EQ(found[0].elements[1].id, "b");
}

TEST(Objects, NamesTallPiecesThatStandInEachOther) {
    const auto found = findings_of({piece("a", 2, 2, 1, 0.6, 2), piece("b", 2.8, 2, 1, 0.6, 2)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].sentence.find("200 mm"), std::string::npos) << found[0].sentence;
}

TEST(Objects, NamesThePieceBehindTheDoor) {
    const auto found = findings_of({piece("sofa", 1, 0.6, 1.8, 0.8, 0.8)});
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].elements[0].id, "sofa");
    EXPECT_EQ(found[0].elements[1].id, "door");
    EXPECT_TRUE(findings_of({piece("sofa", 2.6, 0.6, 1.8, 0.8, 0.8)}).empty()) << "beside it";
}

TEST(Objects, AWallPartsAPieceFromADoor) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("screen", {0, 0.6}, {3, 0.6}, 0.1));
    plan.storeys[0].furniture = {piece("shelf", 1, 0.9, 1, 0.4, 1)};
    EXPECT_EQ(check(build(plan)).count("S6"), 0u);
}

/// The building with the volumes of a column, or one of a wall, as an object of their own.
Building with_object(const plans::Plan& plan, const std::string& id) {
    Building building = build(plan);
    Space object;
    object.label = Label::Object;
    object.id = object.name = "box";
    object.storey = 0;
    building.spaces.push_back(object);
    for (Volume& volume : building.volumes) {
        if (building.spaces[volume.space].id != id) continue;
        volume.label = Label::Object;
        volume.space = std::uint32_t(building.spaces.size() - 1);
        break;
    }
    return building;
}

TEST(Objects, OfRulesMayStandFreeInARoom) {
    const CheckReport report = check(with_object(testing::ring_room(), "column"));
    EXPECT_EQ(testing::all_of(report), "");
}

TEST(Objects, OfRulesMayNotStandInADoorsSweep) {
    plans::Plan plan = testing::ring_room();
    plan.storeys[0].columns[0].polygon = {{0.8, 0.4}, {1.2, 0.4}, {1.2, 0.8}, {0.8, 0.8}};
    const CheckReport report = check(with_object(plan, "column"));
    ASSERT_EQ(report.findings.size(), 1u) << testing::all_of(report);
    EXPECT_EQ(report.findings[0].code, "S6");
    EXPECT_EQ(report.findings[0].severity, Severity::Error);
    EXPECT_NEAR((*report.findings[0].point)[0], 1, 0.01);
    EXPECT_NEAR((*report.findings[0].point)[1], 0.6, 0.01);
}

TEST(Objects, OfRulesLieInsideOneRoom) {
    const CheckReport report = check(with_object(testing::two_rooms(), "m"));  // between the two
    ASSERT_EQ(report.findings.size(), 1u) << testing::all_of(report);
    EXPECT_EQ(report.findings[0].code, "S6");
    EXPECT_EQ(report.findings[0].severity, Severity::Error);
}

}  // namespace
}  // namespace enfilade::modeler
