// write_exports PLAN STEM: builds a plan (a file, or the name of a small plan) and writes all exports of its scene as
// STEM.glb, STEM.city.json, ..., for the readers of other people, and STEM.facts.json with what they have to find.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "modeler/exports/city_json.h"
#include "modeler/exports/dot.h"
#include "modeler/exports/gltf.h"
#include "modeler/exports/graphml.h"
#include "modeler/exports/hbjson.h"
#include "modeler/exports/indoor_gml.h"
#include "modeler/exports/obj.h"
#include "modeler/exports/scene_mesh.h"
#include "modeler/space_parts.h"
#include "tests/modeler/exports/exports_fixture.h"

namespace {

using namespace enfilade;
using Json = nlohmann::ordered_json;

plans::Plan plan_named(const std::string& name) {
    if (name == "one_room") return testing::one_room();
    if (name == "two_rooms") return testing::two_rooms();
    if (name == "ring_room") return testing::ring_room();
    if (name == "two_storeys") return testing::two_storeys();
    if (name == "nasty_names") {
        plans::Plan plan = testing::two_rooms();
        plan.name = test::nasty_name;
        plan.storeys[0].name = test::nasty_name;
        plan.storeys[0].rooms.push_back(
            {test::nasty_name, test::nasty_name, "room", {{1, 1}, {1.5, 1}, {1, 2}}, {}, {}});
        plan.storeys[0].walls[4].id = plan.storeys[0].openings[1].wall = "m<&\"'>";
        plan.storeys[0].lights.push_back({"l", test::nasty_name, {1, 1}, 2, {1, 1, 1}, 100});
        for (const double x : {0.5, 1.0})
            plan.storeys[0].furniture.push_back({test::nasty_name + std::to_string(x),
                                                 test::nasty_name,
                                                 test::nasty_name,
                                                 {x, 2},
                                                 0,
                                                 x,
                                                 0.5,
                                                 0.25,
                                                 1,
                                                 false,
                                                 {}});
        return plan;
    }
    return plans::read(name);
}

void write(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    out << text;
    if (!out.flush()) throw std::runtime_error("cannot write " + file);
}

/// Every space with its label, its volume by the parts of the model, and its storey.
Json facts(const test::BuiltPlan& plan) {
    const modeler::Building& model = plan.model;
    std::map<std::uint32_t, double> volume;
    for (const modeler::SpacePart& part : modeler::space_parts(model))
        volume[part.space] += modeler::area_m2(model, part) * model.frame.unit * (part.z_high - part.z_low);
    const modeler::Fittings fittings = modeler::fittings(model);
    double lumen = 0;
    for (const accel::Light& light : plan.scene.view().lights)
        lumen += 4 * std::numbers::pi * double{std::ranges::max(light.intensity)};
    Json json = {{"cells", plan.scene.view().cells.size()},
                 {"portals", plan.scene.view().portals.size()},
                 {"triangles", modeler::scene_mesh(plan.scene.view()).triangle_count()},
                 {"lights", plan.scene.view().lights.size()},
                 {"lumen", lumen},
                 {"furniture", fittings.furniture.size()}};
    for (const auto& [space, cubic_metres] : volume)
        json["spaces"].push_back(
            {{"id", model.spaces[space].id},
             {"name", model.spaces[space].name.empty() ? model.spaces[space].id : model.spaces[space].name},
             {"label", accel::name_of(model.spaces[space].label)},
             {"volume", cubic_metres}});
    return json;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const std::string stem = argv[2];
        const test::BuiltPlan plan = test::built(plan_named(argv[1]));
        const accel::SceneView& view = plan.scene.view();
        write(stem + ".facts.json", facts(plan).dump(1, ' ', false, Json::error_handler_t::replace));
        write(stem + ".city.json", modeler::to_cityjson(plan.model));
        write(stem + ".hbjson", modeler::to_hbjson(plan.model));
        write(stem + ".gml", modeler::to_indoorgml(plan.model));
        write(stem + ".dot", modeler::to_dot(view));
        write(stem + ".cells.dot", modeler::to_dot(view, modeler::GraphLevel::Cells));
        write(stem + ".glb", modeler::to_glb(view, modeler::fittings(plan.model)));
        write(stem + ".graphml", modeler::to_graphml(view));
        const modeler::ObjText obj = modeler::to_obj(view, "scene.mtl");
        write(stem + ".obj", obj.obj);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
