// G6: walls and slabs have a thickness that can be built.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

/// Two rooms with a wall of this thickness between them, a door in it.
plans::Plan with_thin_wall(double thickness, double arc = 0) {
    plans::Plan plan = testing::two_rooms();
    for (plans::Wall& wall : plan.storeys[0].walls)
        if (wall.id == "m") wall.thickness = thickness, wall.arc_extent = arc;
    return plan;
}

std::vector<Finding> thin(const plans::Plan& plan, CheckOptions options = {}) {
    std::vector<Finding> found;
    const Building building = build(plan);
    for (const Finding& finding : check(building, options).findings)
        if (finding.code == "G6") found.push_back(finding);
    EXPECT_EQ(check(convexify(building), options).count("G6"), found.size());
    return found;
}

TEST(Thickness, FindsEachThinWallAndSlab) { testing::expect_found(testing::inject_g6, 20); }

TEST(Thickness, NamesAThinWallOnceWithWhatItMeasures) {
    for (const double arc : {0.0, 0.6}) {
        const auto found = thin(with_thin_wall(0.005, arc));
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(found[0].severity, Severity::Warning);
        ASSERT_EQ(found[0].elements.size(), 1u);
        EXPECT_EQ(found[0].elements[0].id, "m");
        if (arc == 0) {
            // 5 mm are 40.96 units of the grid; both sides are rounded.
            EXPECT_NE(found[0].sentence.find("only 4.88 mm thick"), std::string::npos) << found[0].sentence;
            EXPECT_NEAR((*found[0].point)[0], 2, 0.01);
        }
    }
}

TEST(Thickness, AcceptsAWallOfTheLeastThickness) {
    EXPECT_TRUE(thin(with_thin_wall(0.01)).empty());
    EXPECT_TRUE(thin(with_thin_wall(0.01, 0.6)).empty());
    EXPECT_TRUE(thin(with_thin_wall(0.125), {.least_thickness = 0.125}).empty());
    EXPECT_EQ(thin(with_thin_wall(0.125), {.least_thickness = 0.13}).size(), 1u);
}

TEST(Thickness, AcceptsTheTipOfAWedge) {
    plans::Plan plan = testing::one_room();
    // A wall that leaves a corner at 8 degrees: between the two a tip of wall runs out to nothing.
    plan.storeys[0].walls.push_back(testing::wall("oblique", {0, 0}, {4, 0.55}, 0.1));
    EXPECT_TRUE(thin(plan).empty());
}

TEST(Thickness, AcceptsScrapsOfAWallBetweenOthers) {
    plans::Plan plan = testing::one_room();
    // The thin wall is taken by two thick ones that almost touch.
    plan.storeys[0].walls.push_back(testing::wall("thin", {1, 1.5}, {3, 1.5}, 0.1));
    plan.storeys[0].walls.push_back(testing::wall("left", {1.9, 0.5}, {1.9, 2.5}, 0.2));
    plan.storeys[0].walls.push_back(testing::wall("right", {2.105, 0.5}, {2.105, 2.5}, 0.2));
    EXPECT_TRUE(thin(plan).empty());
}

/// The roof comes down until its slab is this many units thick.
Building with_roof(std::int32_t units) {
    Building building = build(testing::one_room());
    const std::int32_t underside = building.storeys[0].z_ceiling;
    const std::int32_t down = building.frame.grid_z(2.75) - underside - units;
    testing::shift_levels(building, underside + 1, -down);
    return building;
}

TEST(Thickness, NamesAThinSlab) {
    const CheckReport report = check(with_roof(70));
    ASSERT_EQ(report.findings.size(), 1u);
    const Finding& finding = report.findings.front();
    EXPECT_EQ(finding.code, "G6");
    EXPECT_EQ(finding.elements.front().kind, "slab");
    EXPECT_NE(finding.sentence.find("only 8.54 mm thick"), std::string::npos) << finding.sentence;
    EXPECT_TRUE(check(with_roof(82)).findings.empty());
}

}  // namespace
}  // namespace enfilade::modeler
