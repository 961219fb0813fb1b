#include "modeler/build.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "base/error.h"
#include "gmap/validate.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/map_geometry.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

std::map<Label, int> labels(const Building& building) {
    std::map<Label, int> count;
    for (const Volume& volume : building.volumes) ++count[volume.label];
    return count;
}

double cubic_metres(const Building& building, Label label) {
    const auto all = volumes6(building.map, building.vertices);
    double sum = 0;
    for (std::size_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label == label) sum += double((*all)[v]) / 6 * std::pow(building.frame.unit, 3);
    return sum;
}

std::string complaints(const CheckReport& report) {
    std::string text;
    for (const Finding& finding : report.findings)
        if (finding.severity == Severity::Error) text += finding.code + " " + finding.sentence + "\n";
    return text;
}

TEST(Build, OneRoomHasTheVolumesThatOneCounts) {
    const Building building = build(testing::one_room());
    const auto count = labels(building);
    EXPECT_EQ(count.at(Label::Room), 1);
    EXPECT_EQ(count.at(Label::Door), 1);
    EXPECT_EQ(count.at(Label::Outside), 1);
    EXPECT_EQ(count.at(Label::Slab), 2) << "ground slab and roof";
    // The south wall is cut by its door into three: two sides and a lintel. The others stay whole.
    EXPECT_EQ(count.at(Label::Wall), 6);
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, MeasuresOfOneRoomAreExact) {
    const Building building = build(testing::one_room());
    EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Room), 3.75 * 2.75 * 2.5);
    EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Door), 1 * 0.25 * 2);
    EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Wall), (4.25 * 3.25 - 3.75 * 2.75) * 2.5 - 1 * 0.25 * 2);
    EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Slab), 2 * 4.25 * 3.25 * 0.25);
}

TEST(Build, RoomsAndOpeningsOfTwoRooms) {
    const Building building = build(testing::two_rooms());
    const auto count = labels(building);
    EXPECT_EQ(count.at(Label::Room), 2);
    EXPECT_EQ(count.at(Label::Door), 2);
    EXPECT_EQ(count.at(Label::Window), 1);
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, ARingRoomIsTwoDiscsOfOneParentSpace) {
    const Building building = build(testing::ring_room());
    std::set<std::uint32_t> spaces;
    int rooms = 0;
    for (const Volume& volume : building.volumes)
        if (volume.label == Label::Room) ++rooms, spaces.insert(volume.space);
    EXPECT_EQ(rooms, 2);
    EXPECT_EQ(spaces.size(), 1u);
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, StairsPierceTheSlabBetweenTheirStoreys) {
    const Building building = build(testing::two_storeys());
    int stairs = 0, joints = 0;
    for (const Volume& volume : building.volumes) stairs += volume.label == Label::Stair;
    EXPECT_EQ(stairs, 2) << "one in the storey, one in the slab";
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Up) continue;
        const Label above = building.volumes[face.front].label, below = building.volumes[face.back].label;
        joints += below == Label::Stair && (above == Label::Stair || above == Label::Room);
    }
    EXPECT_EQ(joints, 2) << "stair to slab, slab to the room above";
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, TheSkyIsAboveATerrace) {
    const Building building = build(testing::two_storeys());
    bool has_terrace = false;
    for (const Face& face : building.faces) {
        if (face.direction != Direction::Up) continue;
        has_terrace |= building.volumes[face.front].label == Label::Exterior &&
                       building.volumes[face.back].label == Label::Slab && face.z_low == building.storeys[1].z_floor;
    }
    EXPECT_TRUE(has_terrace);
}

TEST(Build, AirIsOneVolumeThroughAllStoreys) {
    const Building building = build(testing::two_storeys());
    bool through = false;
    for (const Volume& volume : building.volumes)
        through |= volume.label == Label::Exterior && volume.z_low == building.storeys[0].z_floor &&
                   volume.z_high == building.site_max[2];
    EXPECT_TRUE(through);
}

TEST(Build, StoreysCanBeChosen) {
    BuildOptions options;
    options.arrange.storeys = {1};
    const Building building = build(testing::two_storeys(), options);
    ASSERT_EQ(building.storeys.size(), 1u);
    EXPECT_EQ(building.storeys[0].id, "upper");
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, StoreysThatAreNotThereAreRefused) {
    BuildOptions options;
    options.arrange.storeys = {7};
    EXPECT_THROW((void)build(testing::two_storeys(), options), InputError);
}

TEST(Build, AStoreyWithoutHeightIsLeftOutAsAnError) {
    plans::Plan plan = testing::two_storeys();
    plan.storeys[1].elevation = 1.2;
    plan.storeys[1].slab_thickness = 0.9;
    const Building building = build(plan);
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("P401"), 1u);
    EXPECT_FALSE(report.sound());
    EXPECT_EQ(building.storeys.size(), 1u);
}

TEST(Build, AboveALowWallIsAnOpening) {
    plans::Plan plan = testing::two_rooms();
    for (plans::Wall& wall : plan.storeys[0].walls)
        if (wall.id == "m") wall.height_at_start = wall.height_at_end = 1;
    plan.storeys[0].openings.erase(plan.storeys[0].openings.begin() + 1);
    const Building building = build(plan);
    bool found = false;
    for (const Volume& volume : building.volumes)
        found |= volume.label == Label::Opening && building.spaces[volume.space].id == "m/above" &&
                 volume.z_low == building.storeys[0].z_floor + 8192 && volume.z_high == building.storeys[0].z_ceiling;
    EXPECT_TRUE(found);
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, AFenceHasNoSlabAboveIt) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].walls.push_back(testing::wall("fence", {10, 0}, {14, 0}, 0.25, 1));
    const Building building = build(plan);
    for (const Volume& volume : building.volumes)
        if (volume.label == Label::Wall && building.spaces[volume.space].id == "fence") {
            EXPECT_EQ(volume.z_high - volume.z_low, 8192);
        }
    EXPECT_EQ(labels(building).at(Label::Slab), 3) << "the house's ground slab and roof, and the fence's foot";
    EXPECT_TRUE(check(building).sound()) << complaints(check(building));
}

TEST(Build, TheSamePlanFarAwayHasTheSameTopology) {
    plans::Plan far = testing::two_storeys();
    for (plans::Storey& storey : far.storeys) {
        for (plans::Wall& wall : storey.walls)
            wall.start.x += 1e6, wall.end.x += 1e6, wall.start.y -= 1e6, wall.end.y -= 1e6;
        for (plans::Stair& stair : storey.stairs)
            for (plans::Point& p : stair.polygon) p.x += 1e6, p.y -= 1e6;
    }
    const Building here = build(testing::two_storeys()), there = build(far);
    EXPECT_EQ(here.map.dart_count(), there.map.dart_count());
    EXPECT_EQ(here.map.arrays().alpha, there.map.arrays().alpha);
    EXPECT_TRUE(check(there).sound());
}

TEST(Build, EmptyPlansAreRefused) { EXPECT_THROW((void)build(plans::Plan{}), InputError); }

TEST(Convexify, CellsAreConvexAndSumToTheirParents) {
    for (const plans::Plan& plan :
         {testing::one_room(), testing::two_rooms(), testing::ring_room(), testing::two_storeys()}) {
        const Building building = build(plan);
        const Building convex = convexify(building);
        const CheckReport report = check(convex);
        EXPECT_TRUE(report.sound()) << plan.name << ": " << complaints(report);
        EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Room), cubic_metres(convex, Label::Room)) << plan.name;
        EXPECT_DOUBLE_EQ(cubic_metres(building, Label::Exterior), cubic_metres(convex, Label::Exterior)) << plan.name;
    }
}

TEST(Convexify, PiecesKeepTheirParentVolume) {
    const Building building = build(testing::ring_room());
    const Building convex = convexify(building);
    std::map<std::uint32_t, std::uint32_t> space_of_parent;
    for (const Volume& volume : building.volumes) space_of_parent[volume.parent] = volume.space;
    for (const Volume& volume : convex.volumes) EXPECT_EQ(space_of_parent.at(volume.parent), volume.space);
}

TEST(Convexify, GivesTheSameBuildingEveryTime) {
    const Building once = convexify(build(testing::two_storeys())), twice = convexify(build(testing::two_storeys()));
    EXPECT_EQ(once.map.arrays().alpha, twice.map.arrays().alpha);
    EXPECT_EQ(once.vertices, twice.vertices);
}

}  // namespace
}  // namespace enfilade::modeler
