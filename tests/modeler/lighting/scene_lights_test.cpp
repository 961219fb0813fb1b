#include "modeler/lighting/scene_lights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/lighting/lamps_text.h"
#include "modeler/lighting/plan_lamps.h"
#include "modeler/model_group.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

plans::Plan lit_room() {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].elevation = 1.5;
    plan.storeys[0].lights.push_back({"b", "Lamp", {1, 1}, 2.25, {1, 0.5f, 0.25f}, 4 * std::numbers::pi});
    plan.storeys[0].lights.push_back({"a", "", {2, 1}, 2, {1, 1, 1}, 800, 0.05});
    plan.storeys[0].lights.push_back({"in-wall", "", {0, 1}, 1, {1, 1, 1}, 800});
    return plan;
}

Building built(const plans::Plan& plan) { return convexify(build(plan)); }

accel::Scene scene_of(const Building& building) { return export_scene(building, check(building), "{}"); }

double luminance_of(const std::array<float, 3>& rgb) { return luminance({rgb[0], rgb[1], rgb[2]}); }

TEST(SceneLights, StandInTheSceneByAscendingIdWhereThePlanHangsThem) {
    const Building building = built(lit_room());
    const accel::Scene scene = scene_of(building);
    const accel::SceneView& view = scene.view();
    ASSERT_EQ(view.lights.size(), 3u);
    EXPECT_EQ(view.string(view.lights[0].id), "a");
    EXPECT_EQ(view.string(view.lights[1].id), "b");
    EXPECT_EQ(view.string(view.lights[1].name), "Lamp");
    EXPECT_FLOAT_EQ(view.lights[0].radius, 0.05f);
    EXPECT_NEAR(double{view.lights[1].position[0]} + view.origin[0], 1, 1e-5);
    EXPECT_NEAR(double{view.lights[1].position[1]} + view.origin[1], 1, 1e-5);
    EXPECT_NEAR(double{view.lights[1].position[2]} + view.origin[2], 1.5 + 2.25, 1e-5);
}

TEST(SceneLights, KnowTheCellThatHoldsThemAndNoneInAWall) {
    const accel::Scene scene = scene_of(built(lit_room()));
    const accel::SceneView& view = scene.view();
    ASSERT_NE(view.lights[0].cell, none<accel::CellId>);
    EXPECT_EQ(view.cells[index(view.lights[0].cell)].label, accel::Label::Room);
    EXPECT_EQ(view.string(view.lights[2].id), "in-wall");
    EXPECT_EQ(view.lights[2].cell, none<accel::CellId>);
}

TEST(SceneLights, TheLuminanceOfTheirCandelaIsTheirLumenOverTheSphere) {
    for (const plans::Colour& colour :
         {plans::Colour{1, 1, 1}, plans::Colour{0, 0, 1}, plans::Colour{0.25f, 0.125f, 0}}) {
        const auto intensity = candela({.colour = colour, .lumen = 800});
        EXPECT_NEAR(luminance_of(intensity), 800 / (4 * std::numbers::pi), 1e-3);
        EXPECT_NEAR(intensity[0] * colour[2], intensity[2] * colour[0], 1e-3) << "the colour stays";
    }
}

TEST(SceneLights, LampsWithoutPowerOrColourHaveNoIntensity) {
    const std::array<float, 3> dark = {0, 0, 0};
    const double not_a_number = std::nan("");
    EXPECT_EQ(candela({.lumen = 0}), dark);
    EXPECT_EQ(candela({.lumen = -5}), dark);
    EXPECT_EQ(candela({.lumen = not_a_number}), dark);
    EXPECT_EQ(candela({.colour = {0, 0, 0}, .lumen = 800}), dark);
    EXPECT_EQ(candela({.colour = {float(not_a_number), 1, 1}, .lumen = 800}), dark);
    EXPECT_EQ(candela({.colour = {1e-44f, 0, 0}, .lumen = 1e300}), dark) << "beyond all floats";
}

TEST(SceneLights, AreCarriedByTheObjectOfTheirPiece) {
    Building building = built(lit_room());
    building.lamps[1].carrier = "lamp-2";
    building.lamps[2].carrier = "absent";
    accel::SceneInput input;
    for (const char* id : {"chair", "lamp-2", "table"}) input.objects.push_back({.id = id});
    add_lights(building, input);
    ASSERT_EQ(input.lights.size(), 3u);
    EXPECT_EQ(input.lights[0].carrier, UINT32_MAX);
    EXPECT_EQ(input.lights[1].carrier, 1u);
    EXPECT_EQ(input.lights[2].carrier, UINT32_MAX);
}

TEST(SceneLights, ComeBackFromTheModelOfTheirScene) {
    Building building = built(lit_room());
    building.lamps.push_back({.id = "site", .position = {9, 9, 3}, .lumen = 3000, .carrier = "post", .by_rule = true});
    const accel::Scene scene = scene_of(building);
    const Building read = read_model(scene);
    EXPECT_EQ(read.lamps, building.lamps);
    const accel::Scene again = export_scene(read, check(read), "{}");
    EXPECT_TRUE(std::ranges::equal(again.bytes(), scene.bytes()));
}

TEST(SceneLights, OfAPlanAreTheSameInAnyOrderOfItsElements) {
    plans::Plan plan = lit_room();
    const accel::Scene scene = scene_of(built(plan));
    std::ranges::reverse(plan.storeys[0].lights);
    const accel::Scene other = scene_of(built(plan));
    ASSERT_EQ(scene.view().lights.size(), other.view().lights.size());
    for (std::size_t k = 0; k < scene.view().lights.size(); ++k) {
        EXPECT_EQ(scene.view().lights[k].position, other.view().lights[k].position);
        EXPECT_EQ(scene.view().string(scene.view().lights[k].id), other.view().string(other.view().lights[k].id));
    }
}

TEST(SceneLights, OfStoreysThatAreNotBuiltAreLeftOut) {
    const plans::Plan plan = lit_room();
    StoreyInfo other;
    other.id = "another";
    EXPECT_TRUE(plan_lamps(plan, std::vector{other}).empty());
}

TEST(LampsText, RefusesWhatNoLampCanBe) {
    const std::vector<Lamp> lamps = {{.id = "a", .storey = 0, .lumen = 800}, {.id = "b", .lumen = 800}};
    const std::string text = lamps_text(lamps);
    EXPECT_EQ(read_lamps(text, 1), lamps);
    EXPECT_THROW((void)read_lamps(text, 0), InputError) << "no such storey";
    EXPECT_THROW((void)read_lamps(text.substr(1), 1), InputError);
    EXPECT_THROW((void)read_lamps(lamps_text({lamps[1], lamps[0]}), 1), InputError) << "out of order";
    EXPECT_THROW((void)read_lamps(lamps_text({lamps[0], lamps[0]}), 1), InputError) << "one id twice";
    EXPECT_THROW((void)read_lamps(lamps_text({{.id = "a", .lumen = -1}}), 1), InputError);
    EXPECT_THROW((void)read_lamps(lamps_text({{.id = "a", .position = {1e300, 0, 0}}}), 1), InputError);
    EXPECT_THROW((void)read_lamps(lamps_text({{.id = "a", .colour = {-1, 0, 0}}}), 1), InputError);
}

}  // namespace
}  // namespace enfilade::modeler
