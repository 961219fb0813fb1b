// Home.xml as a plan: units, axes, defaults, refusals.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "plans/colour.h"
#include "plans/outline.h"
#include "tests/plans/home_file.h"

namespace enfilade::plans {
namespace {

using testing::archive;
using testing::findings_of;
using testing::read_archive;
using testing::read_home;
using testing::wall_xml;

constexpr double pi = std::numbers::pi;

InputError refusal(const std::string& bytes) {
    try {
        (void)read_archive(bytes);
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << "the archive was not refused";
    return {"", "", ""};
}
InputError refusal_of_xml(const std::string& xml) { return refusal(archive({{"Home.xml", xml}})); }

bool inside(const std::vector<Point>& polygon, Point p) {
    bool in = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point a = polygon[k];
        const Point b = polygon[(k + 1) % polygon.size()];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) in = !in;
    }
    return in;
}

std::string room_xml(const std::vector<Point>& corners, const std::string& more = "") {
    std::string xml = "<room id='room' " + more + ">";
    for (const Point p : corners) xml += "<point x='" + std::to_string(p.x) + "' y='" + std::to_string(p.y) + "'/>";
    return xml + "</room>";
}

const char* const two_levels =
    "<level id='a' elevation='0' height='250' floorThickness='12'/>"
    "<level id='b' elevation='262' height='250' floorThickness='12'/>";

TEST(SweetHome, KeepsAnLShapedPlanUnmirrored) {
    // On the screen, where y points down, the L lacks its upper right quarter: the north-east one.
    const Plan plan = read_home(room_xml({{0, 0}, {300, 0}, {300, 300}, {600, 300}, {600, 600}, {0, 600}}));
    const std::vector<Point>& polygon = plan.storeys.at(0).rooms.at(0).polygon;
    ASSERT_EQ(polygon.size(), 6u);
    EXPECT_TRUE(inside(polygon, {1.5, -1.5}));
    EXPECT_FALSE(inside(polygon, {4.5, -1.5}));
    EXPECT_TRUE(inside(polygon, {1.5, -4.5}));
    EXPECT_TRUE(inside(polygon, {4.5, -4.5}));
}

TEST(SweetHome, TurnsCentimetresIntoMetres) {
    const Plan plan = read_home(wall_xml("w", 12.5, 100, 350, 100, "thickness='7.5' height='243.84' heightAtEnd='20'"));
    const Wall& wall = plan.storeys.at(0).walls.at(0);
    EXPECT_EQ(wall.id, "w");
    EXPECT_DOUBLE_EQ(wall.start.x, 0.125);
    EXPECT_DOUBLE_EQ(wall.start.y, -1);
    EXPECT_DOUBLE_EQ(wall.end.x, 3.5);
    EXPECT_DOUBLE_EQ(wall.thickness, 0.075);
    EXPECT_DOUBLE_EQ(wall.height_at_start, 2.4384);
    EXPECT_DOUBLE_EQ(wall.height_at_end, 0.2);
}

TEST(SweetHome, BendsArcsToTheSideTheyBendInTheFile) {
    // Wall.getArcCircleCenter of Sweet Home 3D: a positive extent has its centre below a wall drawn to the right on
    // the screen, so the wall rises: to the north of its chord.
    for (const double extent : {1.0, pi, 1.5 * pi, -1.0, -pi, -1.5 * pi}) {
        const Plan plan =
            read_home(wall_xml("w", 0, 0, 200, 0, "thickness='10' arcExtent='" + std::to_string(extent) + "'"));
        const Wall& wall = plan.storeys.at(0).walls.at(0);
        const Point middle = WallAxis(wall.start, wall.end, wall.arc_extent, 1e-6).at(0.5);
        EXPECT_NEAR(middle.x, 1, 1e-9);
        EXPECT_NEAR(middle.y, std::tan(extent / 4), 1e-5) << extent;
    }
}

TEST(SweetHome, KeepsTheSidesOfWalls) {
    const Plan plan =
        read_home(wall_xml("w", 0, 0, 200, 0, "thickness='10' leftSideColor='FFFF0000' rightSideColor='000000FF'"));
    const Wall& wall = plan.storeys.at(0).walls.at(0);
    ASSERT_TRUE(wall.left_colour && wall.right_colour);
    EXPECT_EQ(*wall.left_colour, (Colour{1, 0, 0}));
    EXPECT_EQ(*wall.right_colour, (Colour{0, 0, 1}));
}

TEST(SweetHome, KeepsTheTexturesOfWallsAndFloors) {
    const auto child = [](const std::string& attribute, const std::string& more) {
        return "<texture attribute='" + attribute + "' name='brick' image='7' width='80' height='40' " + more + "/>";
    };
    std::string wall = wall_xml("w", 0, 0, 200, 0, "thickness='10' leftSideColor='FFFF0000'");
    wall.replace(wall.size() - 2, 2, ">" + child("leftSideTexture", "scale='0.5'") + "</wall>");
    std::string room = room_xml({{0, 0}, {9, 0}, {9, 9}});
    const std::string turned = child("floorTexture", "angle='0.5' xOffset='0.25' yOffset='-0.5'");
    room.replace(room.find("</room>"), 0,
                 turned + "<texture attribute='ceilingTexture' image='8' width='0' height='4'/>");
    const Plan plan = read_home(wall + room);
    const Wall& read = plan.storeys.at(0).walls.at(0);
    EXPECT_EQ(read.left_texture, (SurfaceTexture{"7", 0.4, 0.2, 0, 0, 0}));
    EXPECT_EQ(read.left_colour, (Colour{1, 0, 0}));
    EXPECT_FALSE(read.right_texture);
    EXPECT_EQ(plan.storeys.at(0).rooms.at(0).floor_texture, (SurfaceTexture{"7", 0.8, 0.4, -0.5, 0.25, -0.5}));
    EXPECT_FALSE(plan.storeys.at(0).rooms.at(0).ceiling_texture) << "it has no size";
}

TEST(SweetHome, ReadsColoursInDecimalToo) {
    const Plan plan = read_home(room_xml({{0, 0}, {9, 0}, {9, 9}}, "floorColor='4291344794' ceilingColor='FFC8AD7F'"));
    const Room& room = plan.storeys.at(0).rooms.at(0);
    EXPECT_EQ(room.floor_colour, colour_from_rgb(4291344794u));
    EXPECT_EQ(room.ceiling_colour, colour_from_rgb(0xC8AD7F));
}

TEST(SweetHome, TakesTheHomesHeightForWallsWithoutOne) {
    const Plan plan = read_home(wall_xml("w", 0, 0, 200, 0), "wallHeight='270'");
    EXPECT_DOUBLE_EQ(plan.storeys.at(0).height, 2.7);
    EXPECT_DOUBLE_EQ(plan.storeys.at(0).walls.at(0).height_at_start, 2.7);
    EXPECT_DOUBLE_EQ(plan.storeys.at(0).walls.at(0).height_at_end, 2.7);
}

TEST(SweetHome, ReadsAnyVersionText) {
    const std::string wall = wall_xml("w", 0, 0, 200, 0);
    for (const char* version : {"7.2", "7", "", "one"}) {
        const std::string xml = "<home version='" + std::string(version) + "'>" + wall + "</home>";
        EXPECT_EQ(read_archive(archive({{"Home.xml", xml}})).storeys.at(0).walls.size(), 1u) << version;
    }
}

TEST(SweetHome, SortsLevelsByElevationThenIndex) {
    const Plan plan = read_home(
        "<level id='roof' elevation='534' elevationIndex='1' height='250' floorThickness='2'/>"
        "<level id='attic' elevation='534' elevationIndex='0' height='250' floorThickness='2'/>"
        "<level id='cellar' name='Cellar' elevation='-262' height='240' floorThickness='12' visible='false'/>" +
        wall_xml("w", 0, 0, 200, 0, "thickness='10' level='attic'"));
    ASSERT_EQ(plan.storeys.size(), 3u);
    EXPECT_EQ(plan.storeys[0].id, "cellar");
    EXPECT_EQ(plan.storeys[0].name, "Cellar");
    EXPECT_DOUBLE_EQ(plan.storeys[0].elevation, -2.62);
    EXPECT_DOUBLE_EQ(plan.storeys[0].height, 2.4);
    EXPECT_DOUBLE_EQ(plan.storeys[0].slab_thickness, 0.12);
    EXPECT_EQ(plan.storeys[1].id, "attic");
    EXPECT_EQ(plan.storeys[1].walls.size(), 1u);
    EXPECT_EQ(plan.storeys[2].id, "roof");
}

TEST(SweetHome, StacksLevelsWithoutElevationAndSaysSo) {
    const Plan plan = read_home(
        "<level id='a' elevation='0' height='250' floorThickness='12'/><level id='b' height='250' "
        "floorThickness='30'/>");
    EXPECT_DOUBLE_EQ(plan.storeys.at(1).elevation, 2.8);
    EXPECT_EQ(findings_of(plan, "P165").size(), 1u);
}

TEST(SweetHome, PlacesElementsOfUnknownLevelsAndSaysSo) {
    const Plan plan = read_home(
        "<level id='a' elevation='-300' height='250' floorThickness='12'/>"
        "<level id='b' elevation='0' height='250' floorThickness='12'/>" +
        wall_xml("w", 0, 0, 200, 0, "thickness='10' level='gone'"));
    EXPECT_EQ(plan.storeys.at(1).walls.size(), 1u);
    ASSERT_EQ(findings_of(plan, "P161").size(), 1u);
    EXPECT_NE(findings_of(plan, "P161")[0].sentence.find("\"gone\""), std::string::npos);
}

TEST(SweetHome, MakesIdsUnique) {
    const Plan plan = read_home(wall_xml("a", 0, 0, 1, 0) + wall_xml("a", 0, 0, 2, 0) + wall_xml("", 0, 0, 3, 0) +
                                wall_xml("a-2", 0, 0, 4, 0) + wall_xml("wall-1", 0, 0, 5, 0));
    std::vector<std::string> ids;
    for (const Wall& wall : plan.storeys.at(0).walls) ids.push_back(wall.id);
    EXPECT_EQ(ids, (std::vector<std::string>{"a", "a-3", "wall-2", "a-2", "wall-1"}));
}

TEST(SweetHome, LeavesOutWhatHasNoPlaceAndNamesIt) {
    for (const char* bad : {"NaN", "Infinity", "1e400", "", "ten", "1e12", "5cm"}) {
        const Plan plan = read_home("<wall id='bad' xStart='0' yStart='0' xEnd='" + std::string(bad) +
                                    "' yEnd='0' thickness='10'/>" + wall_xml("good", 0, 0, 1, 1));
        ASSERT_EQ(plan.storeys.at(0).walls.size(), 1u) << bad;
        EXPECT_EQ(plan.storeys[0].walls[0].id, "good");
        const std::vector<Finding> findings = findings_of(plan, "P162");
        ASSERT_EQ(findings.size(), 1u) << bad;
        EXPECT_EQ(findings[0].severity, Severity::Error);
        EXPECT_EQ(findings[0].elements.at(0).id, "bad");
    }
}

TEST(SweetHome, TakesDefaultsForUnusableSizesAndSaysSo) {
    const Plan plan = read_home(wall_xml("w", 0, 0, 1, 1, "thickness='-3' height='tall' arcExtent='7'"));
    const Wall& wall = plan.storeys.at(0).walls.at(0);
    EXPECT_DOUBLE_EQ(wall.thickness, 0.075);
    EXPECT_DOUBLE_EQ(wall.height_at_start, 2.5);
    EXPECT_EQ(wall.arc_extent, 0);
    EXPECT_EQ(findings_of(plan, "P160").size(), 3u);
}

TEST(SweetHome, KeepsWithinWhatOurOwnFormatHolds) {
    const Plan plan = read_home(
        two_levels +
        std::string("<light id='l' x='999999999' y='0' elevation='499999' width='99999' depth='9' height='99999'>"
                    "<lightSource x='4' y='-4' z='4'/></light>"
                    "<pieceOfFurniture id='s' level='a' x='998999999' y='-998999999' width='99999' depth='99999' "
                    "height='99999' angle='0.8' staircaseCutOutShape='M0,0 v1 h1 v-1 z'/>") +
        wall_xml("w", -999999999, 999999999, 999999999, -999999999, "thickness='99999' height='999999'") +
        "<doorOrWindow id='d' x='990000000' y='-990000000' elevation='499999' width='99999' depth='99999' "
        "height='99999' angle='-0.7853981634'/>");
    const std::string json = write_json(plan);
    EXPECT_EQ(write_json(read_json(json, "plan.json")), json);
    EXPECT_EQ(plan.storeys.at(0).stairs.size(), 1u);
    EXPECT_EQ(plan.storeys.at(0).openings.size(), 1u);
}

TEST(SweetHome, RefusesRoomsWithoutExtent) {
    const Plan plan = read_home(room_xml({{0, 0}, {1, 1}}, "name='Thin'"));
    EXPECT_TRUE(plan.storeys.at(0).rooms.empty());
    ASSERT_EQ(findings_of(plan, "P163").size(), 1u);
    EXPECT_EQ(findings_of(plan, "P163")[0].elements.at(0).name, "Thin");
}

TEST(SweetHome, GuessesKindsOfRoomsFromTheirNames) {
    const auto kind = [](const std::string& name) {
        return read_home(room_xml({{0, 0}, {9, 0}, {9, 9}}, "name='" + name + "'")).storeys.at(0).rooms.at(0).kind;
    };
    EXPECT_EQ(kind("Hallway"), "corridor");
    EXPECT_EQ(kind("Flur"), "corridor");
    EXPECT_EQ(kind("WC"), "bathroom");
    EXPECT_EQ(kind("ВАННАЯ"), "bathroom");
    EXPECT_EQ(kind("KÜCHE"), "kitchen");
    EXPECT_EQ(kind("Bedroom #2"), "bedroom");
    EXPECT_EQ(kind("Balcony"), "room");
}

TEST(SweetHome, ReadsPiecesInsideGroups) {
    const Plan plan = read_home(
        "<level id='a' elevation='0' height='250' floorThickness='12'/>"
        "<furnitureGroup level='a' name='g'><furnitureGroup name='h'>"
        "<pieceOfFurniture id='p' model='1/bed.obj' x='100' y='50' angle='1.5707964' elevation='10' width='90' "
        "depth='200' "
        "height='60' modelMirrored='true' color='00FF00'/></furnitureGroup></furnitureGroup>");
    const Furniture& piece = plan.storeys.at(0).furniture.at(0);
    EXPECT_EQ(piece.model, "1/bed.obj");
    EXPECT_EQ(piece.position, (Point{1, -0.5}));
    EXPECT_NEAR(piece.angle, -pi / 2, 1e-6);
    EXPECT_DOUBLE_EQ(piece.elevation, 0.1);
    EXPECT_DOUBLE_EQ(piece.width, 0.9);
    EXPECT_DOUBLE_EQ(piece.depth, 2);
    EXPECT_DOUBLE_EQ(piece.height, 0.6);
    EXPECT_TRUE(piece.mirrored);
    EXPECT_EQ(piece.colour, (Colour{0, 1, 0}));
}

TEST(SweetHome, ReadsHowAModelIsTurnedAndTilted) {
    const Plan plan = read_home(
        "<pieceOfFurniture id='p' catalogId='eTeks#roof' model='1/roof.obj' x='0' y='0' width='100' depth='50' "
        "height='20' widthInPlan='100' depthInPlan='53.5' heightInPlan='42' pitch='0.5' "
        "modelRotation='0 0 -1 0 1 0 1 0 0'><material name='Tiles' color='FFFF0000'/><material name='Felt'/>"
        "</pieceOfFurniture>"
        "<pieceOfFurniture id='q' model='q' x='0' y='0' width='100' depth='50' height='20' pitch='0' roll='0' "
        "modelRotation='1 0 0 0 1 0 0 0 1'/>"
        "<pieceOfFurniture id='r' model='r' x='0' y='0' width='100' depth='50' height='20' "
        "modelRotation='1 0 0 0 1 0 0 0'/>"
        "<pieceOfFurniture id='s' model='s' x='0' y='0' width='100' depth='50' height='20' "
        "modelRotation='0 0 0 0 1 0 0 0 1'/>");
    const std::vector<Furniture>& pieces = plan.storeys.at(0).furniture;
    ASSERT_EQ(pieces.size(), 4u);
    EXPECT_EQ(pieces[0].catalogue, "eTeks#roof");
    // The file's x axis becomes its z axis, to the front: in ours that is -y.
    EXPECT_EQ(pieces[0].model_rotation, (std::array<double, 9>{0, 1, 0, -1, 0, 0, 0, 0, 1}));
    EXPECT_EQ(pieces[0].model_size, (std::array<double, 3>{1, 0.5, 0.2}));
    EXPECT_DOUBLE_EQ(pieces[0].depth, 0.535);
    EXPECT_DOUBLE_EQ(pieces[0].height, 0.42);
    EXPECT_DOUBLE_EQ(pieces[0].pitch, 0.5);
    ASSERT_EQ(pieces[0].materials.size(), 1u);
    EXPECT_EQ(pieces[0].materials[0], (FurnitureMaterial{"Tiles", {1, 0, 0}}));
    for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_FALSE(pieces[k].model_rotation);
        EXPECT_FALSE(pieces[k].model_size);
    }
    EXPECT_EQ(findings_of(plan, "P160").size(), 2u) << "of r and s";
}

TEST(SweetHome, SaysHowManyPiecesAreHiddenOrWithoutSize) {
    const Plan plan = read_home(
        "<pieceOfFurniture name='p' x='0' y='0' width='9' depth='9' height='9' visible='false'/>"
        "<pieceOfFurniture name='Sofa' x='0' y='0'/>");
    EXPECT_TRUE(plan.storeys.at(0).furniture.empty());
    EXPECT_EQ(findings_of(plan, "P176").size(), 1u);
    ASSERT_EQ(findings_of(plan, "P179").size(), 1u);
    EXPECT_NE(findings_of(plan, "P179")[0].sentence.find("Sofa"), std::string::npos);
    EXPECT_FALSE(has_errors(plan.findings));
}

TEST(SweetHome, PlacesLightSourcesInTheirLamp) {
    const Plan plan = read_home(
        "<light id='l' x='100' y='100' angle='1.5707963267948966' elevation='50' width='20' depth='40' height='100' "
        "power='0.25'><lightSource x='1' y='0.5' z='0.9' color='FFFFFFFF'/></light>");
    ASSERT_EQ(plan.storeys.at(0).lights.size(), 1u);
    const Light& light = plan.storeys[0].lights[0];
    // The lamp's right side, turned clockwise on the screen by a right angle, looks down.
    EXPECT_NEAR(light.position.x, 1, 1e-12);
    EXPECT_NEAR(light.position.y, -1.1, 1e-12);
    EXPECT_NEAR(light.elevation, 1.4, 1e-12);
    EXPECT_NEAR(light.power_lumen, 200, 1e-4) << "a quarter of the power of 800 lumen, as its pictures have it";
    EXPECT_EQ(light.furniture, "l");
    EXPECT_DOUBLE_EQ(light.radius, 0.0325);
    EXPECT_EQ(plan.storeys[0].furniture.size(), 1u);
}

TEST(SweetHome, GivesEachSourceTheLampsPowerInItsOwnColourAndSize) {
    const Plan plan = read_home(
        "<light id='l' x='0' y='0' elevation='50' width='20' depth='20' height='10' power='0.5'>"
        "<lightSource x='0' y='0' z='0' color='FFFFFFFF' diameter='0.5'/>"
        "<lightSource x='1' y='0' z='0' color='FF00FF00' diameter='0'/></light>");
    ASSERT_EQ(plan.storeys.at(0).lights.size(), 2u);
    const auto& lights = plan.storeys[0].lights;
    EXPECT_NEAR(lights[0].power_lumen, 800, 1e-3);
    EXPECT_DOUBLE_EQ(lights[0].radius, 0.05);
    EXPECT_EQ(lights[1].id, "l/source-2");
    EXPECT_NEAR(lights[1].power_lumen, 800 * 0.7152, 1e-3) << "green alone is the darker part of white";
    EXPECT_EQ(lights[1].radius, 0);
    EXPECT_EQ(lights[1].colour, (Colour{0, 1, 0}));
}

TEST(SweetHome, LampsThatAreSwitchedOffShineNot) {
    const Plan plan = read_home(
        "<light id='l' x='0' y='0' elevation='50' width='20' depth='20' height='10' power='0'>"
        "<lightSource x='0' y='0' z='0' color='FFFFFFFF'/></light>");
    EXPECT_TRUE(plan.storeys.at(0).lights.empty());
    EXPECT_EQ(plan.storeys[0].furniture.size(), 1u);
}

std::string stair_xml(const std::string& level, const std::string& shape, const std::string& more = "") {
    return "<pieceOfFurniture id='s' level='" + level + "' x='200' y='100' width='200' depth='100' height='262' " +
           more + " staircaseCutOutShape='" + shape + "'/>";
}

TEST(SweetHome, CutsStairsAsTheirShapeSays) {
    // The shape lacks the lower right quarter of its box.
    const Plan plan = read_home(two_levels + stair_xml("a", "M0,0 H1 V.5 h-.5 v.5 L0,1z"));
    const std::vector<Point>& polygon = plan.storeys.at(0).stairs.at(0).polygon;
    ASSERT_EQ(polygon.size(), 6u);
    EXPECT_TRUE(inside(polygon, {2.9, -0.6}));
    EXPECT_TRUE(inside(polygon, {1.1, -1.4}));
    EXPECT_FALSE(inside(polygon, {2.9, -1.4}));
    EXPECT_TRUE(plan.storeys[0].furniture.empty());
}

TEST(SweetHome, MirrorsAndTurnsStairs) {
    const Plan mirrored = read_home(two_levels + stair_xml("a", "M0,0 H1 V.5 h-.5 v.5 L0,1z", "modelMirrored='true'"));
    EXPECT_FALSE(inside(mirrored.storeys.at(0).stairs.at(0).polygon, {1.1, -1.4}));
    EXPECT_TRUE(inside(mirrored.storeys.at(0).stairs.at(0).polygon, {2.9, -1.4}));
    // Turned clockwise by a right angle the lower right quarter becomes the lower left one.
    const Plan turned = read_home(two_levels + stair_xml("a", "M0,0 H1 V.5 h-.5 v.5 L0,1z", "angle='1.5707963'"));
    EXPECT_FALSE(inside(turned.storeys.at(0).stairs.at(0).polygon, {1.6, -1.9}));
    EXPECT_TRUE(inside(turned.storeys.at(0).stairs.at(0).polygon, {2.4, -1.9}));
}

TEST(SweetHome, FollowsArcsOfStairs) {
    const Plan plan = read_home(two_levels + stair_xml("a", "M0,.5 A.5,.5 0 1 1 1,.5 A.5 .5 0 01 0,.5 z"));
    const std::vector<Point>& polygon = plan.storeys.at(0).stairs.at(0).polygon;
    ASSERT_GE(polygon.size(), 16u);
    for (const Point p : polygon) EXPECT_NEAR(std::hypot(p.x - 2, 2 * (p.y + 1)), 1, 1e-9);
}

TEST(SweetHome, TakesTheBoxOfStairsWithoutUsableShape) {
    for (const char* shape : {"nonsense", "M0,0", "M0,0 L1,1", "M0,0 L1e9,0 L0,1"}) {
        const Plan plan = read_home(two_levels + stair_xml("a", shape));
        EXPECT_EQ(plan.storeys.at(0).stairs.at(0).polygon.size(), 4u) << shape;
    }
}

TEST(SweetHome, KeepsStairsToNowhereAsFurniture) {
    const Plan plan = read_home(two_levels + stair_xml("b", "M0,0 v1 h1 v-1 z"));
    EXPECT_TRUE(plan.storeys.at(1).stairs.empty());
    EXPECT_EQ(plan.storeys.at(1).furniture.size(), 1u);
    EXPECT_EQ(findings_of(plan, "P181").size(), 1u);
}

TEST(SweetHome, NamesThePlanAfterTheHome) {
    EXPECT_EQ(read_home("", "name='/home/me/My flat.sh3d'").name, "My flat");
    EXPECT_EQ(read_home("", "name='C:\\homes\\flat.sh3d'").name, "flat");
    EXPECT_EQ(read_home("", "name='UK 4-Bed Semi'").name, "UK 4-Bed Semi");
    EXPECT_EQ(read_home("", "").name, "test");
}

TEST(SweetHome, RefusesTheSerialisedHomeWithItsRemedy) {
    const InputError error = refusal(archive({{"Home", "\xAC\xED"}, {"0", "x"}}));
    EXPECT_EQ(error.code, "P151");
    EXPECT_EQ(error.file, "test.sh3d");
    EXPECT_NE(std::string(error.what()).find("save it again"), std::string::npos);
}

TEST(SweetHome, RefusesOtherArchives) {
    EXPECT_EQ(refusal(archive({{"PluginFurnitureCatalog.properties", "x"}})).code, "P152");
    EXPECT_EQ(refusal("PK\x03\x04 and nothing more").code, "P150");
    EXPECT_EQ(refusal("").code, "P150");
    std::string cut = archive({{"Home.xml", "<home/>"}});
    cut.resize(cut.size() / 2);
    EXPECT_EQ(refusal(cut).code, "P150");
}

TEST(SweetHome, RefusesEntriesWithoutBound) {
    EXPECT_EQ(refusal(archive({{"Home.xml", "<home>" + std::string(std::size_t{65} << 20, ' ') + "</home>"}})).code,
              "P153");
}

TEST(SweetHome, RefusesDamagedEntries) {
    std::string bytes = archive({{"Home.xml", "<home>" + wall_xml("w", 0, 0, 1, 1) + "</home>"}});
    bytes[60] = static_cast<char>(bytes[60] ^ 0x5A);
    EXPECT_EQ(refusal(bytes).code, "P153");
}

TEST(SweetHome, RefusesMalformedXmlWithLineAndColumn) {
    const InputError bare = refusal_of_xml("<home>\n  <room name='Flur & Bad'/>\n</home>");
    EXPECT_EQ(bare.code, "P154");
    EXPECT_EQ(bare.line, 2);
    EXPECT_EQ(bare.column, 20);
    const InputError umlaut = refusal_of_xml("<home>\n  <room name='Küche &nbsp; Bad'/>\n</home>");
    EXPECT_EQ(umlaut.line, 2);
    EXPECT_EQ(umlaut.column, 21);
    EXPECT_NE(std::string(umlaut.what()).find("nbsp"), std::string::npos);
    const InputError tag = refusal_of_xml("<home>\n<wall>\n</room>\n</home>");
    EXPECT_EQ(tag.code, "P154");
    EXPECT_EQ(tag.line, 3);
    for (const char* xml : {"", "<home", "<home>", "home", "<home a='1", "<home a='<'/>", "<home>&#0;</home>"})
        EXPECT_EQ(refusal_of_xml(xml).code, "P154") << xml;
    EXPECT_EQ(refusal_of_xml(std::string("<home>\0</home>", 14)).code, "P154");
}

TEST(SweetHome, AcceptsReferencesWhereXmlHasThem) {
    const Plan plan = read_archive(
        archive({{"Home.xml", "<home name='A &amp; B &#x41;&#66;'><!-- & --><![CDATA[ & < ]]><?x & ?></home>"}}));
    EXPECT_EQ(plan.name, "A & B AB");
}

TEST(SweetHome, RefusesOtherRoots) { EXPECT_EQ(refusal_of_xml("<house/>").code, "P155"); }

TEST(SweetHome, RefusesNestingWithoutEnd) {
    std::string xml = "<home>";
    for (int k = 0; k < 100000; ++k) xml += "<furnitureGroup>";
    EXPECT_EQ(refusal_of_xml(xml).code, "P156");
}

RC_GTEST_PROP(SweetHomeProperties, OrderOfElementsChangesNothingButOrder, ()) {
    std::vector<std::string> elements;
    const int count = *rc::gen::inRange(1, 8);
    for (int k = 0; k < count; ++k) {
        const double y = k * 100;
        elements.push_back(wall_xml("w" + std::to_string(k), 0, y, 400, y));
        const int x = *rc::gen::inRange(0, 400);
        const int beside = *rc::gen::inRange(-70, 70);
        elements.push_back(testing::door_xml("d" + std::to_string(k), x, y + beside));
    }
    std::string sorted;
    for (const std::string& element : elements) sorted += element;
    std::vector<std::size_t> order(elements.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[*rc::gen::inRange<std::size_t>(0, k)]);
    std::string shuffled;
    for (const std::size_t k : order) shuffled += elements[k];
    const auto text = [](Plan plan) {
        for (Storey& storey : plan.storeys) {
            const auto by_id = [](const auto& a, const auto& b) { return a.id < b.id; };
            std::sort(storey.walls.begin(), storey.walls.end(), by_id);
            std::sort(storey.openings.begin(), storey.openings.end(), by_id);
        }
        std::sort(plan.findings.begin(), plan.findings.end(),
                  [](const Finding& a, const Finding& b) { return a.sentence < b.sentence; });
        return write_json(plan);
    };
    RC_ASSERT(text(read_home(sorted)) == text(read_home(shuffled)));
}

}  // namespace
}  // namespace enfilade::plans
