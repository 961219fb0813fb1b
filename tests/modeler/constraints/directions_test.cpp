// G7: sides of volumes are upright, floors and ceilings level.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

/// The head of a door, from 0.5 to 1.5 m along the wall: at one jamb, or at both, it goes up.
Building with_lifted_head(int units, bool both) {
    Building building = build(testing::one_room());
    const std::int32_t left = building.frame.grid_x(0.5), right = building.frame.grid_x(1.5);
    const std::int32_t z = building.frame.grid_z(2);
    for (auto& p : building.vertices)
        if (p[2] == z && (p[0] == left || (both && p[0] == right))) p[2] += units;
    return building;
}

TEST(Directions, FindsEachFaceThatLeans) { testing::expect_found(testing::inject_g7, 20); }

TEST(Directions, FindsADoorHeadThatRisesByAUnit) {
    const CheckReport report = check(with_lifted_head(1, false));
    ASSERT_EQ(report.findings.size(), 1u);
    const Finding& finding = report.findings.front();
    EXPECT_EQ(finding.code, "G7");
    EXPECT_EQ(finding.severity, Severity::Error);
    EXPECT_NEAR((*finding.point)[0], 1, 1e-9);
    EXPECT_NEAR((*finding.point)[2], 2, 1e-3);
    // A unit in a metre: 0.007 degrees.
    EXPECT_NE(finding.sentence.find("off the horizontal by 0.00699 degrees"), std::string::npos) << finding.sentence;
    const auto is_door = [](const ElementRef& e) { return e.id == "door"; };
    EXPECT_TRUE(std::any_of(finding.elements.begin(), finding.elements.end(), is_door));
}

TEST(Directions, AcceptsADoorHeadThatRisesAsAWhole) { EXPECT_EQ(check(with_lifted_head(7, true)).count("G7"), 0u); }

TEST(Directions, LeavesARowThatCallsASideAFloorToTheLabels) {
    Building building = build(testing::one_room());
    building.faces[0].direction = Direction::Up;
    EXPECT_EQ(check(building).count("G7"), 0u);
}

}  // namespace
}  // namespace enfilade::modeler
