#include "modeler/lighting/rule_lamps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "accel/assemble.h"
#include "accel/locate.h"
#include "base/error.h"
#include "modeler/build.h"
#include "modeler/check.h"
#include "modeler/convexify.h"
#include "modeler/export_scene.h"
#include "modeler/furnishing/furnish.h"
#include "modeler/model_group.h"
#include "modeler/objects/object_box.h"
#include "modeler/objects/put_objects.h"
#include "plans/generate.h"
#include "tests/support/small_plans.h"

namespace enfilade::modeler {
namespace {

Building built(const plans::Plan& plan) { return convexify(build(plan)); }

/// An office floor without the lamps that its generator hangs.
plans::Plan dark_office(std::uint32_t rooms, double curved = 0) {
    plans::Plan plan = plans::generate({.rooms = rooms, .curved = curved});
    for (plans::Storey& storey : plan.storeys) storey.lights.clear();
    return plan;
}

Building furnished(const Building& rooms, const Catalogue& catalogue, ObjectCells cells) {
    Furnished made = furnish(rooms, own_rules(), catalogue, {.seed = 1, .spaces = {}});
    made.furnishing.cells = cells;
    std::vector<Finding> findings;
    return put_objects(rooms, std::move(made.furnishing), findings, accel::SerialExecutor());
}

/// The room or other space around each lamp, by the scene itself.
std::map<std::string, std::size_t> lamps_by_space(const Building& building) {
    const accel::Scene scene = accel::assemble(scene_input(building));
    const accel::SceneView& view = scene.view();
    std::map<std::string, std::size_t> count;
    for (const accel::Light& light : view.lights)
        ++count[light.cell == none<accel::CellId>
                    ? "a solid"
                    : std::string(view.string(view.spaces[index(view.cells[index(light.cell)].space)].id))];
    return count;
}

TEST(RuleLamps, EveryRoomHasItsLampsAndNoneIsInASolid) {
    Building building = built(dark_office(30, 0.3));
    light_building(building, own_lamp_rules());
    const auto count = lamps_by_space(building);
    EXPECT_FALSE(count.contains("a solid"));
    std::size_t rooms = 0;
    for (const Space& space : building.spaces) {
        if (space.label != Label::Room) continue;
        ++rooms;
        EXPECT_TRUE(count.contains(space.id)) << space.name;
    }
    EXPECT_EQ(rooms, 30u);
    EXPECT_EQ(check(building).count("S7"), 0u);
}

TEST(RuleLamps, GiveARoomTheFluxThatItsKindAsksFor) {
    plans::Plan plan = testing::one_room();
    plan.storeys[0].rooms.push_back({"office-1", "Office", "office", {{1, 1}, {3, 1}, {3, 2}, {1, 2}}});
    Building building = built(plan);
    light_building(building, own_lamp_rules());
    ASSERT_EQ(building.lamps.size(), 2u) << "one in the room, one over the door";
    const Lamp& lamp = building.lamps[1];
    EXPECT_EQ(lamp.id, "office-1/lamp-1");
    EXPECT_NEAR(lamp.lumen, 3.75 * 2.75 * 500 / 0.5, 1);
    EXPECT_NEAR(lamp.position[0], 2, 1e-3);
    EXPECT_NEAR(lamp.position[1], 1.5, 1e-3);
    EXPECT_NEAR(lamp.position[2], 2.4, 1e-3);
    EXPECT_EQ(building.lamps[0].id, "door/lamp");
    EXPECT_NEAR(building.lamps[0].position[0], 1, 1e-3) << "before the middle of the door";
    EXPECT_NEAR(building.lamps[0].position[1], -0.125 - 0.2, 1e-3);
}

TEST(RuleLamps, RoomsThatThePlanLightsKeepToItsLampsUnlessTheyAreReplaced) {
    plans::Plan plan = testing::two_rooms();
    plan.storeys[0].lights.push_back({"own", "", {1, 1.5}, 2, {1, 1, 1}, 800});
    LampRules rules = own_lamp_rules();
    rules.outdoor.entrance_lumen = 0;
    Building kept = built(plan), replaced = kept;
    light_building(kept, rules);
    EXPECT_EQ(kept.lamps.size(), 2u);
    rules.replace = true;
    light_building(replaced, rules);
    EXPECT_EQ(replaced.lamps.size(), 2u);
    for (const Lamp& lamp : replaced.lamps) EXPECT_TRUE(lamp.by_rule);
}

TEST(RuleLamps, AreExactlyAsManyAsAskedFor) {
    for (const auto& [rooms, lamps] : {std::pair(8u, 8u), {8u, 5u}, {46u, 55u}, {135u, 200u}, {46u, 1000u}}) {
        Building building = built(plans::generate({.rooms = rooms}));
        LampRules rules = own_lamp_rules();
        rules.count = lamps;
        rules.replace = true;
        rules.outdoor.entrance_lumen = 0;
        light_building(building, rules);
        EXPECT_EQ(building.lamps.size(), lamps);
        const auto count = lamps_by_space(building);
        EXPECT_FALSE(count.contains("a solid"));
        EXPECT_EQ(count.size(), std::min(rooms, lamps)) << "no room has two before each has one";
    }
}

TEST(RuleLamps, AreTheSameOnAnyNumberOfThreadsAndInAnyOrderOfThePlan) {
    plans::Plan plan = dark_office(20, 0.3);
    Building building = built(plan);
    light_building(building, own_lamp_rules());
    std::ranges::reverse(plan.storeys[0].rooms);
    std::ranges::reverse(plan.storeys[0].walls);
    Building other = built(plan);
    light_building(other, own_lamp_rules());
    ASSERT_EQ(building.lamps.size(), other.lamps.size());
    for (std::size_t k = 0; k < other.lamps.size(); ++k) {
        EXPECT_EQ(building.lamps[k].id, other.lamps[k].id);
        for (std::size_t r = 0; r < 3; ++r)
            EXPECT_NEAR(building.lamps[k].position[r], other.lamps[k].position[r], 0.0011);
        EXPECT_NEAR(building.lamps[k].lumen, other.lamps[k].lumen, 1);
    }
}

class FurnishedLamps : public ::testing::TestWithParam<ObjectCells> {};

TEST_P(FurnishedLamps, PiecesThatAreLampsShineFromTheirGlassAndThrowNoShadowOfIt) {
    const Catalogue catalogue;
    Building building = furnished(built(dark_office(12)), catalogue, GetParam());
    light_building(building, own_lamp_rules(), &catalogue);
    const accel::Scene scene = accel::assemble(scene_input(building));
    const accel::SceneView& view = scene.view();
    std::size_t carried = 0;
    for (const Lamp& lamp : building.lamps) {
        if (lamp.carrier.empty()) continue;
        ++carried;
        const auto object = std::ranges::find(building.furnishing.objects, lamp.carrier, &FurnishedObject::id);
        ASSERT_NE(object, building.furnishing.objects.end());
        const ObjectBox box = box_of(*object);
        EXPECT_GE(lamp.position[2], box.z_low - 0.001) << lamp.id;
        EXPECT_LE(lamp.position[2], box.z_high + 0.001) << lamp.id;
        EXPECT_LE(std::hypot(lamp.position[0] - object->position[0], lamp.position[1] - object->position[1]),
                  std::hypot(object->size[0], object->size[1]) / 2);
    }
    EXPECT_GT(carried, 0u);
    std::size_t with_carrier = 0;
    for (const accel::Light& light : view.lights) {
        EXPECT_NE(light.cell, none<accel::CellId>) << view.string(light.id);
        with_carrier += light.carrier != none<accel::ObjectId>;
    }
    EXPECT_EQ(with_carrier, carried);
}

TEST_P(FurnishedLamps, RoomsWithACeilingLampGetNoOther) {
    const Catalogue catalogue;
    Building building = furnished(built(dark_office(12)), catalogue, GetParam());
    light_building(building, own_lamp_rules(), &catalogue);
    std::map<std::uint32_t, bool> has_piece;
    for (const FurnishedObject& object : building.furnishing.objects) {
        const CatalogueEntry* entry = catalogue.find(object.model);
        if (entry && (entry->kind == "ceiling_lamp" || entry->kind == "office_lamp")) has_piece[object.space] = true;
    }
    ASSERT_FALSE(has_piece.empty());
    for (const Lamp& lamp : building.lamps)
        for (const auto& [room, _] : has_piece)
            EXPECT_NE(lamp.id, building.spaces[room].id + "/lamp-1") << building.spaces[room].name;
}

TEST_P(FurnishedLamps, HangInNoPieceOfFurniture) {
    const Catalogue catalogue;
    Building building = furnished(built(dark_office(12)), catalogue, GetParam());
    LampRules rules = own_lamp_rules();
    rules.pieces.clear();
    for (RoomLight& room : rules.rooms) room.drop = 0.9;  // among the wardrobes
    light_building(building, rules, &catalogue);
    for (const Lamp& lamp : building.lamps)
        for (const FurnishedObject& object : building.furnishing.objects) {
            const ObjectBox box = box_of(object);
            if (lamp.position[2] < box.z_low || lamp.position[2] > box.z_high) continue;
            const double c = std::cos(object.angle), s = std::sin(object.angle);
            const double x = lamp.position[0] - object.position[0], y = lamp.position[1] - object.position[1];
            EXPECT_FALSE(std::abs(c * x + s * y) < object.size[0] / 2 && std::abs(c * y - s * x) < object.size[1] / 2)
                << lamp.id << " in " << object.id;
        }
}

INSTANTIATE_TEST_SUITE_P(BothWays, FurnishedLamps, ::testing::Values(ObjectCells::List, ObjectCells::Cut),
                         [](const auto& each) { return each.param == ObjectCells::Cut ? "Cut" : "List"; });

TEST(SiteLamps, StandOnTheSiteAndUnderNoRoof) {
    Building building = built(dark_office(46));
    LampRules rules = own_lamp_rules();
    rules.rooms.clear();
    rules.outdoor = {.spacing = 1.5, .entrance_lumen = 0};
    light_building(building, rules);
    EXPECT_GT(building.lamps.size(), 100u);
    const accel::Scene scene = accel::assemble(scene_input(building));
    for (const accel::Light& light : scene.view().lights) {
        ASSERT_NE(light.cell, none<accel::CellId>);
        EXPECT_EQ(scene.view().cells[index(light.cell)].label, Label::Exterior);
        std::array<double, 3> foot{};
        for (std::size_t k = 0; k < 3; ++k) foot[k] = double{light.position[k]};
        foot[2] -= rules.outdoor.elevation - 0.1;
        const auto below = accel::locate(scene.view(), foot);
        ASSERT_TRUE(below.has_value()) << "a lamp on a roof";
        EXPECT_EQ(scene.view().cells[index(*below)].label, Label::Exterior);
    }
    building.lamps.clear();
    rules.outdoor.count = 2500;
    light_building(building, rules);
    EXPECT_EQ(building.lamps.size(), 2500u);
    rules.outdoor.count = 0;
    rules.outdoor.spacing = 0.001;
    EXPECT_THROW(light_building(building, rules), InputError);
}

TEST(RuleLamps, AreInTheFileAndComeBackFromIt) {
    Building building = built(dark_office(8));
    light_building(building, own_lamp_rules());
    const accel::Scene scene = export_scene(building, check(building), "{}");
    EXPECT_EQ(read_model(scene).lamps, building.lamps);
}

}  // namespace
}  // namespace enfilade::modeler
