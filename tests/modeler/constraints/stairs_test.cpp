// S4: each flight links two consecutive storeys and pierces the slab between them.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_semantics.h"

namespace enfilade::modeler {
namespace {

std::vector<Finding> findings_of(const plans::Plan& plan, const BuildOptions& options = {}) {
    std::vector<Finding> found;
    for (const Finding& finding : check(build(plan, options)).findings)
        if (finding.code == "S4") found.push_back(finding);
    return found;
}

TEST(Stairs, FindsEachStairThatLeadsNowhere) { testing::expect_found(testing::inject_s4, 30); }

TEST(Stairs, NamesAStairUnderOpenAir) {
    plans::Plan plan = testing::two_storeys();
    // Beside the upper storey, under its terrace.
    plan.storeys[0].stairs[0].polygon = {{6, 0.5}, {7, 0.5}, {7, 3.5}, {6, 3.5}};
    const auto found = findings_of(plan);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].severity, Severity::Error);
    EXPECT_EQ(found[0].storey, "ground");
    EXPECT_EQ(found[0].elements[0].id, "stair");
    EXPECT_EQ(found[0].elements[1].id, "upper");
    EXPECT_NEAR((*found[0].point)[0], 6.5, 1e-9);
    EXPECT_NEAR((*found[0].point)[1], 2, 1e-9);
}

TEST(Stairs, ReachTheNextStoreyBesideAWall) {
    plans::Plan plan = testing::two_storeys();
    plan.storeys[1].walls.push_back(testing::wall("over the stair", {1, 0}, {1, 2}, 0.1));
    EXPECT_TRUE(findings_of(plan).empty());
}

TEST(Stairs, ToAStoreyThatIsNotBuiltAreNoFault) {
    BuildOptions options;
    options.arrange.storeys = {0};
    EXPECT_TRUE(findings_of(testing::two_storeys(), options).empty());
}

TEST(Stairs, AFaultOfTheStairIsNoneOfTheRoomsAbove) {
    plans::Plan plan = testing::two_storeys();
    plan.storeys[0].stairs.clear();
    plan.storeys[1].openings.pop_back();  // the terrace door
    const CheckReport without = check(build(plan));
    EXPECT_EQ(without.count("S5"), 1u) << "no stair, no door: both upper rooms, in one warning";
    plan = testing::two_storeys();
    plan.storeys[1].openings.pop_back();
    plan.storeys[0].stairs[0].polygon = {{6, 0.5}, {7, 0.5}, {7, 3.5}, {6, 3.5}};
    const CheckReport with = check(build(plan));
    EXPECT_EQ(with.count("S4"), 1u);
    EXPECT_EQ(with.count("S5"), 0u);
    EXPECT_GT(with.suppressed, 0u);
}

}  // namespace
}  // namespace enfilade::modeler
