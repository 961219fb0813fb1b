// Doors and windows of a home find their walls.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "plans/outline.h"
#include "tests/plans/home_file.h"

namespace enfilade::plans {
namespace {

using testing::door_xml;
using testing::findings_of;
using testing::read_home;
using testing::wall_xml;

const Opening& only_opening(const Plan& plan) {
    if (plan.storeys.at(0).openings.size() != 1) throw std::runtime_error("the plan has not exactly one opening");
    return plan.storeys[0].openings[0];
}

/// Where the middle of an opening is in the plan.
Point place_of(const Plan& plan, const Opening& opening) {
    for (const Wall& wall : plan.storeys.at(0).walls) {
        if (wall.id != opening.wall) continue;
        const WallAxis axis(wall.start, wall.end, wall.arc_extent, 1e-6);
        return axis.at(opening.offset / axis.length());
    }
    throw std::runtime_error("the opening has no wall");
}

TEST(SweetHomeDoors, FindTheWallTheyStandIn) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + wall_xml("b", 400, 0, 400, 300) +
                                door_xml("d", 400, 100, "angle='1.5707964'"));
    const Opening& door = only_opening(plan);
    EXPECT_EQ(door.wall, "b");
    EXPECT_NEAR(door.offset, 1, 1e-6);
    EXPECT_DOUBLE_EQ(door.width, 0.9);
    EXPECT_EQ(door.sill, 0);
    EXPECT_DOUBLE_EQ(door.head, 2);
    EXPECT_EQ(door.kind, OpeningKind::Door);
    EXPECT_EQ(door.depth_left, 0);
    EXPECT_EQ(door.depth_right, 0);
    EXPECT_TRUE(plan.findings.empty());
}

TEST(SweetHomeDoors, MeasureOffsetsFromTheWallsStart) {
    const std::string door = door_xml("d", 100, 0);
    EXPECT_NEAR(only_opening(read_home(wall_xml("w", 0, 0, 400, 0) + door)).offset, 1, 1e-12);
    EXPECT_NEAR(only_opening(read_home(wall_xml("w", 400, 0, 0, 0) + door)).offset, 3, 1e-12);
}

TEST(SweetHomeDoors, StandInArcsAtTheirPlace) {
    // Half a circle of 2 m radius to the north of its chord; a door at its top, and one 45 degrees before it.
    const double side = 200 * std::numbers::sqrt2 / 2;
    const std::string arc = wall_xml("w", 0, 0, 400, 0, "thickness='10' arcExtent='3.141592653589793'");
    const Plan top = read_home(arc + door_xml("d", 200, -200));
    EXPECT_NEAR(only_opening(top).offset, std::numbers::pi, 1e-6);
    EXPECT_NEAR(place_of(top, only_opening(top)).y, 2, 1e-6);
    const Plan before = read_home(arc + door_xml("d", 200 - side, -side, "angle='-0.7853981634'"));
    EXPECT_NEAR(only_opening(before).offset, std::numbers::pi / 2, 1e-6);
    EXPECT_NEAR(place_of(before, only_opening(before)).y, side / 100, 1e-6);
    EXPECT_TRUE(before.findings.empty());
}

TEST(SweetHomeDoors, ChooseTheWallTheyOverlapMost) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + wall_xml("b", 0, 12, 400, 12) + door_xml("d", 200, 8));
    EXPECT_EQ(only_opening(plan).wall, "b");
}

TEST(SweetHomeDoors, CountOnlyThePartThatStandsInTheWall) {
    // An open door: its leaf reaches 70 cm into the room and over another wall; 8 of 72.5 cm are frame, at its back.
    const std::string walls =
        wall_xml("a", 0, 0, 400, 0, "thickness='8'") + wall_xml("b", 0, 40, 400, 40, "thickness='30'");
    const std::string door =
        "<doorOrWindow id='d' name='Open door' x='200' y='31.2' width='90' depth='72.5' height='200' "
        "wallThickness='0.11' wallDistance='0.0147'/>";
    EXPECT_EQ(only_opening(read_home(walls + door)).wall, "a");
}

TEST(SweetHomeDoors, CutWallsThatLieAgainstTheirs) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0, "thickness='10'") +
                                wall_xml("b", 0, 15, 400, 15, "thickness='20'") + door_xml("d", 200, 0));
    const Opening& door = only_opening(plan);
    EXPECT_EQ(door.wall, "a");
    // The second wall lies below on the screen: to the south, the right of a wall to the east.
    EXPECT_EQ(door.depth_left, 0);
    EXPECT_NEAR(door.depth_right, 0.2, 1e-9);
    const Plan turned = read_home(wall_xml("a", 400, 0, 0, 0, "thickness='10'") +
                                  wall_xml("b", 0, 15, 400, 15, "thickness='20'") + door_xml("d", 200, 0));
    EXPECT_NEAR(only_opening(turned).depth_left, 0.2, 1e-9);
    EXPECT_EQ(only_opening(turned).depth_right, 0);
}

TEST(SweetHomeDoors, CutThreeLayersAndACavityTheyAreDrawnThrough) {
    const std::string three =
        wall_xml("a", 0, 0, 400, 0) + wall_xml("b", 0, 10, 400, 10) + wall_xml("c", 0, -10, 400, -10);
    EXPECT_NEAR(only_opening(read_home(three + door_xml("d", 200, 0))).depth_left, 0.1, 1e-9);
    EXPECT_NEAR(only_opening(read_home(three + door_xml("d", 200, 0))).depth_right, 0.1, 1e-9);
    const std::string cavity = wall_xml("a", 0, 0, 400, 0) + wall_xml("b", 0, 20, 400, 20);
    EXPECT_EQ(only_opening(read_home(cavity + door_xml("d", 200, 0))).depth_right, 0);
    const std::string deep = "<doorOrWindow id='d' name='Door' x='200' y='9' width='90' depth='30' height='200'/>";
    EXPECT_NEAR(only_opening(read_home(cavity + deep)).depth_left + only_opening(read_home(cavity + deep)).depth_right,
                0.2, 1e-9);
}

TEST(SweetHomeDoors, LeaveWallsAcrossAndAsideAlone) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + wall_xml("across", 200, 0, 200, 300) +
                                wall_xml("aside", 0, 60, 400, 60) + door_xml("d", 200, 0));
    EXPECT_EQ(only_opening(plan).depth_left, 0);
    EXPECT_EQ(only_opening(plan).depth_right, 0);
}

TEST(SweetHomeDoors, TurnIntoTheWallTheyStandAcross) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 0, 400) + door_xml("d", 0, 100));
    EXPECT_EQ(only_opening(plan).wall, "a");
    EXPECT_NEAR(only_opening(plan).offset, 1, 1e-12);
    EXPECT_DOUBLE_EQ(only_opening(plan).width, 0.9);
    const std::vector<Finding> findings = findings_of(plan, "P173");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].severity, Severity::Warning);
    EXPECT_NE(findings[0].sentence.find("90 degrees"), std::string::npos);
}

TEST(SweetHomeDoors, MoveIntoAWallBesideThemAndSayHowFar) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + door_xml("d", 150, 50));
    EXPECT_EQ(only_opening(plan).wall, "a");
    EXPECT_NEAR(only_opening(plan).offset, 1.5, 1e-12);
    const std::vector<Finding> findings = findings_of(plan, "P178");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].severity, Severity::Warning);
    EXPECT_NEAR(findings[0].moved_mm, 500, 1e-6);
    ASSERT_TRUE(findings[0].point);
    EXPECT_NEAR((*findings[0].point)[1], -0.5, 1e-12);
}

TEST(SweetHomeDoors, FarFromAnyWallAreErrorsWithNameAndPlace) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + door_xml("d", 150, 75));
    EXPECT_TRUE(plan.storeys.at(0).openings.empty());
    const std::vector<Finding> findings = findings_of(plan, "P172");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].severity, Severity::Error);
    EXPECT_NE(findings[0].sentence.find("\"Door d\" at (1.5, -0.75)"), std::string::npos) << findings[0].sentence;
    EXPECT_EQ(findings[0].elements.at(0).id, "d");
    // Beside the end of a wall is not beside the wall.
    EXPECT_EQ(findings_of(read_home(wall_xml("a", 0, 0, 400, 0) + door_xml("d", 450, 30)), "P172").size(), 1u);
}

TEST(SweetHomeDoors, CloseTheGapBetweenTwoWallEnds) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 100, 0, "thickness='10' height='240'") +
                                wall_xml("b", 200, 0, 400, 0, "thickness='10' height='240'") + door_xml("d", 145, 3));
    const Opening& door = only_opening(plan);
    const Wall& wall = plan.storeys[0].walls.at(2);
    EXPECT_EQ(door.wall, wall.id);
    EXPECT_EQ(wall.start, (Point{1, 0}));
    EXPECT_EQ(wall.end, (Point{2, 0}));
    EXPECT_DOUBLE_EQ(wall.thickness, 0.1);
    EXPECT_DOUBLE_EQ(wall.height_at_start, 2.4);
    EXPECT_NEAR(door.width, 0.9, 1e-12);
    EXPECT_NEAR(door.offset, 0.47, 1e-9);  // 2 cm of wall are left beside it
    const std::vector<Finding> findings = findings_of(plan, "P174");
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].severity, Severity::Warning);
    EXPECT_NEAR(findings[0].moved_mm, std::hypot(20, 30), 1e-6);
}

TEST(SweetHomeDoors, CloseTheGapToAWallAcross) {
    // The gap reaches from the end of a wall to the face of one across: the new wall joins the axis of that.
    const Plan plan =
        read_home(wall_xml("a", 0, 0, 100, 0) + wall_xml("b", 205, -200, 205, 200) + door_xml("d", 150, 0));
    const Wall& wall = plan.storeys.at(0).walls.at(2);
    EXPECT_EQ(wall.start, (Point{1, 0}));
    EXPECT_NEAR(wall.end.x, 2.05, 1e-12);
    EXPECT_NEAR(wall.end.y, 0, 1e-12);
    EXPECT_NEAR(only_opening(plan).offset, 0.5, 1e-12);
}

TEST(SweetHomeDoors, NarrowToTheGapTheyStandIn) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 100, 0) + wall_xml("b", 170, 0, 400, 0) + door_xml("d", 135, 0));
    EXPECT_NEAR(only_opening(plan).width, 0.66, 1e-9);
    EXPECT_NEAR(only_opening(plan).offset, 0.35, 1e-9);
    EXPECT_NEAR(findings_of(plan, "P174").at(0).moved_mm, 240, 1e-6);
}

TEST(SweetHomeDoors, LeaveWideGapsOpen) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 100, 0) + wall_xml("b", 260, 0, 400, 0) + door_xml("d", 180, 0));
    EXPECT_EQ(plan.storeys.at(0).walls.size(), 2u);
    EXPECT_EQ(findings_of(plan, "P172").size(), 1u);
}

TEST(SweetHomeDoors, AreNoHolesAboveTheirWall) {
    const std::string low = wall_xml("low", 0, 0, 400, 0, "thickness='30' height='75'");
    const std::string high = wall_xml("high", 0, 0, 400, 0, "thickness='10' height='250'");
    const std::string window =
        "<doorOrWindow id='w' name='Window' x='200' y='0' elevation='90' width='90' depth='30' "
        "height='100'/>";
    EXPECT_EQ(only_opening(read_home(low + high + window)).wall, "high");
}

TEST(SweetHomeDoors, DoNotHangOnHiddenPieces) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + door_xml("d", 200, 0, "visible='false'"));
    EXPECT_TRUE(plan.storeys.at(0).openings.empty());
    EXPECT_EQ(findings_of(plan, "P176").size(), 1u);
}

TEST(SweetHomeDoors, WithoutSizeAreErrors) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 400, 0) + "<doorOrWindow id='d' name='Gate' x='100' y='0'/>");
    ASSERT_EQ(findings_of(plan, "P170").size(), 1u);
    EXPECT_EQ(findings_of(plan, "P170")[0].severity, Severity::Error);
}

TEST(SweetHomeDoors, TakeTheirKindFromCatalogueNameAndSill) {
    const auto kind = [](const std::string& catalogue, const std::string& name, double elevation,
                         const std::string& more = "") {
        return only_opening(read_home(wall_xml("a", 0, 0, 400, 0) + "<doorOrWindow catalogId='" + catalogue +
                                      "' name='" + name + "' x='200' y='0' elevation='" + std::to_string(elevation) +
                                      "' width='90' depth='10' height='100' " + more + "/>"))
            .kind;
    };
    EXPECT_EQ(kind("eTeks#door", "Входная дверь", 0), OpeningKind::Door);
    EXPECT_EQ(kind("", "门", 0), OpeningKind::Door);
    EXPECT_EQ(kind("eTeks#window85x123", "Small window", 87), OpeningKind::Window);
    EXPECT_EQ(kind("eTeks#doubleWindow126x163", "Double window", 0), OpeningKind::Window);
    EXPECT_EQ(kind("eTeks#frenchWindow85x200", "Porte-fenêtre", 10.8), OpeningKind::Door);
    EXPECT_EQ(kind("eTeks#sliderWindow126x200", "Slider window", 90), OpeningKind::Window);
    EXPECT_EQ(kind("eTeks#doorFrame", "Door frame", 0), OpeningKind::Opening);
    EXPECT_EQ(kind("", "Thing", 0), OpeningKind::Door);
    EXPECT_EQ(kind("", "Thing", 90), OpeningKind::Window);
    EXPECT_EQ(kind("WINDOW", "Hatch", 90, "isDoor='true'"), OpeningKind::Door);
    EXPECT_EQ(kind("DOOR", "Gate", 0, "isDoor='false'"), OpeningKind::Window);
}

TEST(SweetHomeDoors, OpenAsFarAsTheirSashesTurn) {
    const std::string door = "<doorOrWindow id='d' name='Door' x='200' y='0' width='90' depth='10' height='200'>";
    const std::string wall = wall_xml("a", 0, 0, 400, 0);
    const Plan plan = read_home(wall + door +
                                "<sash xAxis='0' yAxis='0' width='1' startAngle='0.5' endAngle='-0.75'/>"
                                "</doorOrWindow>");
    EXPECT_DOUBLE_EQ(only_opening(plan).open_angle, 1.25);
    EXPECT_DOUBLE_EQ(only_opening(read_home(wall + door + "</doorOrWindow>")).open_angle, std::numbers::pi / 2);
}

TEST(SweetHomeDoors, CutTheRectangleAroundTheirShapeAndSaySo) {
    const auto shaped = [](const std::string& shape, const std::string& more = "") {
        return read_home(wall_xml("a", 0, 0, 400, 0) + door_xml("d", 200, 0, "cutOutShape='" + shape + "' " + more));
    };
    EXPECT_TRUE(findings_of(shaped("M0,0 v1 h1 v-1 z"), "P175").empty());
    EXPECT_EQ(findings_of(shaped("M0,1 v-0.8 a0.5,0.2 0 1,1 1,0 v0.8 z"), "P175").size(), 1u);
    EXPECT_EQ(findings_of(shaped("&lt;?xml version=&quot;1.0&quot;?&gt;&lt;svg/&gt;"), "P175").size(), 1u);
    const Plan half = shaped("M0,0.5 v0.5 h0.5 v-0.5 z");
    EXPECT_NEAR(only_opening(half).offset, 1.775, 1e-9);
    EXPECT_NEAR(only_opening(half).width, 0.45, 1e-12);
    EXPECT_NEAR(only_opening(half).head, 1, 1e-12);
    EXPECT_NEAR(only_opening(shaped("M0,0.5 v0.5 h0.5 v-0.5 z", "modelMirrored='true'")).offset, 2.225, 1e-9);
    EXPECT_NEAR(only_opening(shaped("M0,0 v1 h1 v-1 z", "wallLeft='0.5' wallWidth='0.5'")).offset, 2.225, 1e-9);
}

TEST(SweetHomeDoors, StandOnTheirOwnLevel) {
    const Plan plan = read_home(
        "<level id='a' elevation='0' height='250' floorThickness='12'/>"
        "<level id='b' elevation='262' height='250' floorThickness='12'/>" +
        wall_xml("wa", 0, 0, 400, 0, "thickness='10' level='a'") +
        wall_xml("wb", 0, 0, 400, 0, "thickness='10' level='b'") + door_xml("d", 200, 0, "level='b'"));
    EXPECT_TRUE(plan.storeys.at(0).openings.empty());
    EXPECT_EQ(plan.storeys.at(1).openings.at(0).wall, "wb");
}

TEST(SweetHomeDoors, SurviveWallsWithoutLength) {
    const Plan plan =
        read_home(wall_xml("point", 200, 0, 200, 0) + wall_xml("a", 0, 0, 400, 0) + door_xml("d", 200, 0));
    EXPECT_EQ(only_opening(plan).wall, "a");
}

RC_GTEST_PROP(SweetHomeDoorsProperties, StayAtTheirPlaceHoweverTheHouseIsTurned, ()) {
    const double angle = *rc::gen::inRange(-314, 314) / 100.0;
    const double extent = *rc::gen::inRange(-300, 300) / 100.0;
    const double share = *rc::gen::inRange(15, 85) / 100.0;
    const double cx = *rc::gen::inRange(-1000, 1000);
    const double cy = *rc::gen::inRange(-1000, 1000);
    // An arc in the plan's own terms, written as the file would have it.
    const Point start{cx / 100, cy / 100};
    const Point end{start.x + 4 * std::cos(angle), start.y + 4 * std::sin(angle)};
    const WallAxis axis(start, end, extent, 1e-5);
    const Point middle = axis.at(share);
    const Point normal = axis.normal(share);
    const double down_angle = -std::atan2(-normal.x, normal.y);
    const Plan plan =
        read_home(wall_xml("w", start.x * 100, -start.y * 100, end.x * 100, -end.y * 100,
                           "thickness='10' arcExtent='" + std::to_string(-extent) + "'") +
                  door_xml("d", middle.x * 100, -middle.y * 100, "angle='" + std::to_string(down_angle) + "'"));
    RC_ASSERT(plan.findings.empty());
    const Point place = place_of(plan, only_opening(plan));
    RC_ASSERT(std::hypot(place.x - middle.x, place.y - middle.y) < 1e-4);
}

}  // namespace
}  // namespace enfilade::plans
