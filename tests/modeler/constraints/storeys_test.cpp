// T8: storeys lie between slabs.

#include <gtest/gtest.h>

#include "modeler/build.h"
#include "modeler/convexify.h"
#include "plans/generate.h"
#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/fault_verdict.h"
#include "tests/support/faults_semantics.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

using testing::FaultVerdict;

std::uint32_t volume_of(const Building& building, Label label) {
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (building.volumes[v].label == label) return v;
    return 0;
}

TEST(Storeys, FindsEachSlabThatIsNone) { testing::expect_found(testing::inject_t8, 12); }

TEST(Storeys, NamesTheSlabThatBecameAWall) {
    Building building = build(testing::two_storeys());
    const CheckReport before = check(building);
    const std::uint32_t slab = volume_of(building, Label::Slab), wall = volume_of(building, Label::Wall);
    building.volumes[slab].label = Label::Wall;
    building.volumes[slab].space = building.volumes[wall].space;
    const auto findings = testing::fresh_findings(before, check(building));
    ASSERT_EQ(findings.size(), 1u);
    EXPECT_EQ(findings[0].code, "T8");
    EXPECT_EQ(findings[0].severity, Severity::Error);
    EXPECT_NE(findings[0].sentence.find(building.spaces[building.volumes[wall].space].id), std::string::npos);
    ASSERT_TRUE(findings[0].point.has_value());
}

TEST(Storeys, LeavesALabelThatDiffersFromItsSpaceToS1) {
    Building building = build(testing::one_room());
    building.volumes[volume_of(building, Label::Slab)].label = Label::Wall;
    EXPECT_EQ(check(building).count("T8"), 0u);
}

TEST(Storeys, AcceptsFencesParapetsAndLowWalls) {
    plans::Plan plan = testing::two_storeys();
    plan.storeys[0].walls.push_back(testing::wall("fence", {10, 0}, {10, 4}, 0.2, 1.2));
    plan.storeys[0].walls.push_back(testing::wall("high fence", {11, 0}, {11, 4}, 0.2, 2.5));
    plan.storeys[1].walls.push_back(testing::wall("parapet", {7.5, 1}, {7.5, 5}, 0.1, 1));
    plan.storeys[0].walls.push_back(testing::wall("counter", {4, 2}, {6, 2}, 0.1, 1.1));
    const Building building = build(plan);
    EXPECT_EQ(check(building).count("T8"), 0u);
    EXPECT_EQ(check(convexify(building)).count("T8"), 0u);
}

}  // namespace
}  // namespace enfilade::modeler
