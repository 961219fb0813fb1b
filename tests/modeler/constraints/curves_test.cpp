// G9: the faces of curved walls follow the circles of the plan.

#include <gtest/gtest.h>

#include "tests/modeler/constraints/sound_buildings.h"
#include "tests/support/faults_geometry.h"

namespace enfilade::modeler {
namespace {

/// Two rooms with a curved wall between them that has a door, and a curved wall that stands alone with a straight one
/// running into its middle.
plans::Plan curved_walls() {
    plans::Plan plan = testing::two_rooms();
    plans::Storey& storey = plan.storeys[0];
    for (plans::Wall& wall : storey.walls)
        if (wall.id == "m") wall.arc_extent = 0.8;
    plans::Wall free = testing::wall("free", {6, 0}, {6, 3}, 0.2);
    free.arc_extent = -2.5;
    storey.walls.push_back(free);
    storey.walls.push_back(testing::wall("stem", {4, 1.5}, {7.5, 1.5}, 0.1));
    plans::Wall thick = testing::wall("thick", {10, 0}, {14, 0}, 0.4);
    thick.arc_extent = 4;
    storey.walls.push_back(thick);
    storey.walls.push_back(testing::wall("tangent", {10, 0}, {8, -1}, 0.3));
    return plan;
}

TEST(Curves, FindsEachCornerOffItsCircle) {
    std::uint32_t injected = 0;
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        plans::Random random{9, seed};
        Building building =
            build(seed % 3 == 0 ? curved_walls() : plans::generate({.rooms = 12, .curved = 0.7, .seed = seed}));
        if (seed % 2 == 0) building = convexify(building);
        const CheckReport before = check(building);
        EXPECT_EQ(before.count("G9"), 0u) << "seed " << seed;
        const auto fault = testing::inject_g9(building, random);
        if (!fault) continue;
        ++injected;
        const testing::FaultVerdict verdict = testing::judge(before, check(building), *fault);
        EXPECT_TRUE(verdict.exact() && verdict.found == 1) << "seed " << seed << ": " << verdict.text();
    }
    EXPECT_GE(injected, 15u);
}

TEST(Curves, FindsAModelThatIsCoarserThanItSays) {
    Building building = build(curved_walls());
    EXPECT_EQ(check(building).count("G9"), 0u);
    building.sagitta = 0.0005;
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("G9"), 3u);
    for (const Finding& finding : report.findings) {
        EXPECT_EQ(finding.code, "G9") << finding.sentence;
        EXPECT_EQ(finding.elements.size(), 1u);
        EXPECT_NE(finding.sentence.find("0.5 mm was asked for"), std::string::npos) << finding.sentence;
    }
}

TEST(Curves, FindsAWallThatThePlanBendsOtherwise) {
    Building building = build(curved_walls());
    plans::Plan plan = plans::read_json(building.plan_json, "");
    for (plans::Wall& wall : plan.storeys[0].walls)
        if (wall.id == "free") wall.arc_extent *= 1.01;
    building.plan_json = plans::write_json(plan);
    const CheckReport report = check(building);
    EXPECT_EQ(report.count("G9"), 1u);
}

TEST(Curves, AcceptsCurvesCutFinely) {
    for (const double sagitta_mm : {0.2, 1.0, 20.0}) {
        BuildOptions options;
        options.arrange.sagitta_mm = sagitta_mm;
        const Building building = build(curved_walls(), options);
        EXPECT_EQ(check(building).count("G9"), 0u) << sagitta_mm;
        EXPECT_EQ(check(convexify(building)).count("G9"), 0u) << sagitta_mm;
    }
}

}  // namespace
}  // namespace enfilade::modeler
