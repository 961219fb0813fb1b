// S7: what `check` says of lamps that light nothing.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "accel/assemble.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

std::vector<Finding> s7(const CheckReport& report) {
    std::vector<Finding> found;
    for (const Finding& finding : report.findings)
        if (finding.code == "S7") found.push_back(finding);
    return found;
}

std::vector<Finding> of_lamp(plans::Light lamp) {
    plans::Plan plan = testing::ring_room();
    plan.storeys[0].lights.push_back(std::move(lamp));
    return s7(check(convexify(build(plan))));
}

TEST(Lamps, InTheAirOfARoomADoorwayOrTheSiteAreSound) {
    for (const plans::Point p : {plans::Point{1, 1}, {1, 0}, {1, -1}})
        EXPECT_TRUE(of_lamp({"l", "", p, 1.5, {1, 1, 1}, 800}).empty()) << p.x << ' ' << p.y;
}

TEST(Lamps, InSolidsAreNamedWithWhatTheyAreIn) {
    const auto sentence = [](plans::Point p, double elevation) {
        const std::vector<Finding> found = of_lamp({"l", "Lamp 7", p, elevation, {1, 1, 1}, 800});
        EXPECT_EQ(found.size(), 1u);
        if (found.empty()) return std::string();
        EXPECT_EQ(found[0].severity, Severity::Warning);
        EXPECT_FALSE(found[0].hint.empty());
        EXPECT_EQ(found[0].storey, "ground");
        EXPECT_EQ(found[0].point, (std::array{p.x, p.y, elevation}));
        return found[0].sentence;
    };
    EXPECT_NE(sentence({0, 1}, 1).find("Lamp \"Lamp 7\" is inside the wall"), std::string::npos);
    EXPECT_NE(sentence({2, 1.5}, 1).find("column"), std::string::npos);
    EXPECT_NE(sentence({1, 1}, 2.6).find("slab"), std::string::npos);
    EXPECT_NE(sentence({1, 1}, 2.5).find("slab"), std::string::npos) << "exactly at the ceiling";
    EXPECT_NE(sentence({-2, -2}, -0.5).find("ground"), std::string::npos);
    EXPECT_NE(sentence({1e4, 0}, 1).find("outside the site"), std::string::npos);
}

TEST(Lamps, WithoutPowerOrInBlackAreNamed) {
    ASSERT_EQ(of_lamp({"l", "", {1, 1}, 1, {1, 1, 1}, 0}).size(), 1u);
    ASSERT_EQ(of_lamp({"l", "", {1, 1}, 1, {0, 0, 0}, 800}).size(), 1u);
    EXPECT_NE(of_lamp({"l", "", {1, 1}, 1, {1, 1, 1}, 0})[0].sentence.find("\"l\" has no power"), std::string::npos);
}

TEST(Lamps, AtExactlyOnePlaceAreNamedTogetherAndBothShine) {
    plans::Plan plan = testing::one_room();
    for (const char* id : {"a", "b", "c"}) plan.storeys[0].lights.push_back({id, "", {1, 1}, 2, {1, 1, 1}, 800});
    plan.storeys[0].lights.push_back({"d", "", {1, 1}, 2.001, {1, 1, 1}, 800});
    const Building building = convexify(build(plan));
    const std::vector<Finding> found = s7(check(building));
    ASSERT_EQ(found.size(), 2u) << "b and c, with a";
    EXPECT_EQ(found[0].elements.at(0).id, "b");
    EXPECT_EQ(found[0].elements.at(1).id, "a");
    const accel::Scene scene = accel::assemble(scene_input(building));
    for (const accel::Light& light : scene.view().lights) EXPECT_NE(light.cell, none<accel::CellId>);
}

TEST(Lamps, AreFoundInSolidsExactlyWhereTheSceneFindsNoCell) {
    plans::Plan plan = testing::two_storeys();
    std::mt19937_64 random(5);
    // On the lattice of the walls' own measures: in corners, on faces and edges, and a little beside.
    for (int k = 0; k < 3000; ++k) {
        const auto draw = [&](int steps) { return 0.0625 * double(random() % std::uint64_t(steps)); };
        plan.storeys[0].lights.push_back(
            {"l" + std::to_string(k), "", {draw(160) - 1, draw(120) - 1}, draw(110) - 1, {1, 1, 1}, 800});
    }
    const Building building = convexify(build(plan));
    std::vector<std::string> named, dark;
    for (const Finding& finding : s7(check(building)))
        if (finding.sentence.find("lights nothing") != std::string::npos) named.push_back(finding.elements.at(0).id);
    const accel::Scene scene = accel::assemble(scene_input(building));
    for (const accel::Light& light : scene.view().lights)
        if (light.cell == none<accel::CellId>) dark.emplace_back(scene.view().string(light.id));
    EXPECT_GT(dark.size(), 300u);
    EXPECT_LT(dark.size(), 2700u);
    EXPECT_EQ(named, dark);
}

}  // namespace
}  // namespace enfilade::modeler
