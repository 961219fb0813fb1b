// IndoorGML, CityJSON and Honeybee models of plans whose every number is known.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "modeler/exports/city_json.h"
#include "modeler/exports/energy_model.h"
#include "modeler/exports/hbjson.h"
#include "modeler/exports/indoor_gml.h"
#include "tests/modeler/exports/exports_fixture.h"

namespace enfilade::test {
namespace {

using modeler::Across;
using modeler::EnergyFace;
using modeler::EnergyModel;

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
    return found;
}

double area(const EnergyFace& face) {
    std::array<double, 3> sum = {};
    const auto add = [&](const auto& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const auto &p = ring[k], &q = ring[(k + 1) % ring.size()];
            for (std::size_t i = 0; i < 3; ++i)
                sum[i] += (p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3]) / 2;
        }
    };
    add(face.outer);
    for (const auto& hole : face.holes) add(hole);
    return std::hypot(sum[0], sum[1], sum[2]);
}

double area_of(const EnergyModel& model, Across across) {
    double sum = 0;
    for (const modeler::EnergyRoom& room : model.rooms)
        for (const EnergyFace& face : room.faces) sum += face.across == across ? area(face) : 0;
    return sum;
}

TEST(IndoorGml, DoorsAreCellsAndEntrancesAnchors) {
    const std::string gml = modeler::to_indoorgml(built(testing::two_rooms()).model);
    EXPECT_EQ(count(gml, "<navi:GeneralSpace "), 2u);
    EXPECT_EQ(count(gml, "<navi:ConnectionSpace "), 1u) << "the inner door";
    EXPECT_EQ(count(gml, "<navi:AnchorSpace "), 1u) << "the door to the outside";
    EXPECT_EQ(count(gml, "<core:Transition "), 3u);
    EXPECT_EQ(count(gml, "<navi:AnchorBoundary "), 1u);
    EXPECT_EQ(count(gml, ">window<"), 0u) << "one does not walk through windows";
}

TEST(IndoorGml, RoomsAreNotTheirConvexPieces) {
    const BuiltPlan ring = built(testing::ring_room());
    ASSERT_GT(ring.scene.view().cells.size(), 6u);
    EXPECT_EQ(count(modeler::to_indoorgml(ring.model), "<core:State "), 2u);
}

TEST(IndoorGml, OlderReadersGetTheirNamespaces) {
    const modeler::Building model = built(testing::one_room()).model;
    EXPECT_EQ(count(modeler::to_indoorgml(model), "indoorgml/1.0"), 0u);
    const std::string old = modeler::to_indoorgml(model, modeler::IndoorGmlVersion::V1_0);
    EXPECT_EQ(count(old, "indoorgml/1.1"), 0u);
    EXPECT_EQ(count(old, "xmlns:core=\"http://www.opengis.net/indoorgml/1.0/core\""), 1u);
}

TEST(IndoorGml, NamesTheReferenceSystemThatIsAskedFor) {
    const std::string gml = modeler::to_indoorgml(built(testing::one_room()).model, modeler::IndoorGmlVersion::V1_1,
                                                  "http://www.opengis.net/def/crs/EPSG/0/7415");
    EXPECT_GT(count(gml, "srsName=\"http://www.opengis.net/def/crs/EPSG/0/7415\""), 3u);
    EXPECT_EQ(count(gml, "local-metres"), 0u);
}

TEST(CityJson, VerticesAreThoseOfTheGrid) {
    const BuiltPlan plan = built(testing::one_room());
    const auto json = nlohmann::json::parse(modeler::to_cityjson(plan.model));
    EXPECT_EQ(json["transform"]["scale"][0], plan.model.frame.unit);
    EXPECT_EQ(json["transform"]["translate"][1], plan.model.frame.origin_y);
    EXPECT_EQ(json["CityObjects"]["s"]["type"], "BuildingConstructiveElement");
    EXPECT_EQ(json["CityObjects"]["storey ground"]["type"], "BuildingStorey");
    EXPECT_DOUBLE_EQ(json["CityObjects"]["room@ground/0"]["attributes"]["volume"], 3.75 * 2.75 * 2.5);
}

TEST(CityJson, SurfacesSayWhatTheyAre) {
    const auto json = nlohmann::json::parse(modeler::to_cityjson(built(testing::two_storeys()).model));
    const auto surfaces = [&](const std::string& object) {
        std::vector<std::string> types;
        for (const auto& surface : json["CityObjects"][object]["geometry"][0]["semantics"]["surfaces"])
            types.push_back(surface["type"]);
        return types;
    };
    const auto has = [&](const std::string& object, const std::string& type) {
        const auto types = surfaces(object);
        return std::find(types.begin(), types.end(), type) != types.end();
    };
    EXPECT_TRUE(has("slab@ground", "GroundSurface"));
    EXPECT_TRUE(has("slab@ground", "FloorSurface"));
    EXPECT_TRUE(has("roof@upper", "RoofSurface"));
    EXPECT_TRUE(has("terrace@upper", "OuterFloorSurface"));
    EXPECT_TRUE(has("stair", "ClosureSurface"));
    EXPECT_TRUE(has("gs", "WallSurface"));
    EXPECT_TRUE(has("gs", "InteriorWallSurface"));
}

TEST(EnergyModel, TheWallBetweenTwoRoomsIsOnePairWithItsDoor) {
    const EnergyModel model = modeler::energy_model(built(testing::two_rooms()).model);
    ASSERT_EQ(model.rooms.size(), 2u);
    std::size_t pairs = 0;
    for (const EnergyFace& face : model.rooms[0].faces) {
        if (face.across != Across::Part) continue;
        ++pairs;
        const EnergyFace& other = model.rooms[face.other_room].faces[face.other_face];
        EXPECT_EQ(face.other_room, 1u);
        EXPECT_EQ(other.other_room, 0u);
        EXPECT_DOUBLE_EQ(area(face), 2.75 * 2.5);
        EXPECT_DOUBLE_EQ(area(other), 2.75 * 2.5);
        EXPECT_EQ(face.openings.size(), 1u);
        EXPECT_EQ(other.openings.size(), 1u);
        EXPECT_DOUBLE_EQ(std::abs(face.outer[0][0] - other.outer[0][0]), 0.125) << "the wall's real thickness";
    }
    EXPECT_EQ(pairs, 1u);
}

TEST(EnergyModel, ARoomIsClosedByItsFaces) {
    const EnergyModel model = modeler::energy_model(built(testing::one_room()).model);
    EXPECT_DOUBLE_EQ(area_of(model, Across::Outdoors), 3.75 * 2.75 + 2 * (3.75 + 2.75) * 2.5);
    EXPECT_DOUBLE_EQ(area_of(model, Across::Ground), 3.75 * 2.75);
    EXPECT_EQ(area_of(model, Across::Nothing), 0);
}

TEST(EnergyModel, AColumnInARoomIsAdiabatic) {
    const EnergyModel model = modeler::energy_model(built(testing::ring_room()).model);
    EXPECT_DOUBLE_EQ(area_of(model, Across::Nothing), 4 * 0.5 * 2.5);
}

TEST(EnergyModel, FloorsArePairedWithTheCeilingsBelow) {
    const EnergyModel model = modeler::energy_model(built(testing::two_storeys()).model);
    double floors = 0;
    double ceilings = 0;
    for (const modeler::EnergyRoom& room : model.rooms)
        for (const EnergyFace& face : room.faces) {
            if (face.across != Across::Part || face.is_air) continue;
            if (face.kind == modeler::EnergyFaceKind::Floor) floors += area(face);
            if (face.kind == modeler::EnergyFaceKind::Ceiling) ceilings += area(face);
        }
    // The two upper rooms, less the stair that opens into the lower one.
    EXPECT_NEAR(floors, 4.75 * 5.75 - 4.75 * 0.125 - 3, 1e-9);
    EXPECT_NEAR(ceilings, floors, 1e-9);
}

TEST(EnergyModel, CurvedWallsHavePairsOfEqualArea) {
    const EnergyModel model = modeler::energy_model(built(example("office-135.json")).model);
    for (const modeler::EnergyRoom& room : model.rooms)
        for (const EnergyFace& face : room.faces) {
            if (face.across != Across::Part) continue;
            const EnergyFace& other = model.rooms[face.other_room].faces[face.other_face];
            ASSERT_NEAR(area(face), area(other), 1e-6 * area(face) + 1e-9);
            ASSERT_EQ(&model.rooms[other.other_room].faces[other.other_face], &face);
        }
}

TEST(SemanticExports, AreTheSameEachTimeAndTakeAnyName) {
    plans::Plan plan = testing::two_rooms();
    plan.name = plan.storeys[0].name = nasty_name;
    plan.storeys[0].rooms.push_back({nasty_name, nasty_name, nasty_name, {{0.5, 0.5}, {1.5, 0.5}, {1, 2}}, {}, {}});
    const modeler::Building a = built(plan).model, b = built(plan).model;
    EXPECT_EQ(modeler::to_indoorgml(a), modeler::to_indoorgml(b));
    EXPECT_EQ(modeler::to_cityjson(a), modeler::to_cityjson(b));
    EXPECT_EQ(modeler::to_hbjson(a), modeler::to_hbjson(b));
    EXPECT_TRUE(nlohmann::json::accept(modeler::to_cityjson(a)));
    EXPECT_TRUE(nlohmann::json::accept(modeler::to_hbjson(a)));
}

}  // namespace
}  // namespace enfilade::test
