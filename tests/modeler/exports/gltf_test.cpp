// The bytes of a .glb file, by the rules of glTF 2.0.

#include "modeler/exports/gltf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "accel/assemble.h"
#include "modeler/exports/scene_mesh.h"
#include "tests/modeler/exports/exports_fixture.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::modeler {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

class Gltf : public ::testing::Test {
protected:
    Gltf() {
        scene_ = accel::assemble(test::synthetic_office({.rooms_per_row = 2, .rows = 1, .storeys = 2}));
        bytes_ = to_glb(scene_.view());
        json_bytes_ = number_at(bytes_, 12);
        json_ = nlohmann::json::parse(bytes_.substr(20, json_bytes_));
    }
    accel::Scene scene_;
    std::string bytes_;
    std::uint32_t json_bytes_ = 0;
    nlohmann::json json_;
};

TEST_F(Gltf, HasTheHeaderAndTwoWholeChunks) {
    EXPECT_EQ(bytes_.substr(0, 4), "glTF");
    EXPECT_EQ(number_at(bytes_, 4), 2u);
    EXPECT_EQ(number_at(bytes_, 8), bytes_.size());
    EXPECT_EQ(bytes_.substr(16, 4), "JSON");
    EXPECT_EQ(json_bytes_ % 4, 0u);
    EXPECT_EQ(bytes_.substr(20 + json_bytes_ + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(number_at(bytes_, 20 + json_bytes_), json_["buffers"][0]["byteLength"].get<std::uint32_t>());
    EXPECT_EQ(20 + json_bytes_ + 8 + number_at(bytes_, 20 + json_bytes_), bytes_.size());
}

TEST_F(Gltf, AccessorsLieInTheBuffer) {
    for (const auto& accessor : json_["accessors"]) {
        const auto& view = json_["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const std::size_t element = accessor["type"] == "VEC3" ? 12 : 4;
        EXPECT_EQ(accessor["count"].get<std::size_t>() * element, view["byteLength"].get<std::size_t>());
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                  json_["buffers"][0]["byteLength"].get<std::size_t>());
        EXPECT_EQ(view["byteOffset"].get<std::size_t>() % 4, 0u);
    }
}

TEST_F(Gltf, IndicesNameVerticesOfTheirPrimitive) {
    const std::size_t binary = 20 + json_bytes_ + 8;
    std::size_t triangles = 0;
    for (const auto& mesh : json_["meshes"])
        for (const auto& primitive : mesh["primitives"]) {
            const auto& indices = json_["accessors"][primitive["indices"].get<std::size_t>()];
            const auto& positions = json_["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
            const std::size_t at =
                binary +
                json_["bufferViews"][indices["bufferView"].get<std::size_t>()]["byteOffset"].get<std::size_t>();
            for (std::size_t i = 0; i < indices["count"]; ++i)
                ASSERT_LT(number_at(bytes_, at + 4 * i), positions["count"].get<std::uint32_t>());
            triangles += indices["count"].get<std::size_t>() / 3;
        }
    EXPECT_EQ(triangles, scene_mesh(scene_.view()).triangle_count());
}

TEST_F(Gltf, EveryNodeHangsFromTheRootOnce) {
    std::vector<int> parents(json_["nodes"].size(), 0);
    for (const auto& node : json_["nodes"])
        for (const auto& child : node.value("children", nlohmann::json::array())) ++parents[child.get<std::size_t>()];
    EXPECT_EQ(parents[0], 0);
    for (std::size_t n = 1; n < parents.size(); ++n) EXPECT_EQ(parents[n], 1) << json_["nodes"][n];
    EXPECT_EQ(json_["scenes"][0]["nodes"], nlohmann::json({0}));
}

TEST_F(Gltf, BoundsHoldThePositions) {
    const std::size_t binary = 20 + json_bytes_ + 8;
    for (const auto& accessor : json_["accessors"]) {
        if (!accessor.contains("min")) continue;
        const std::size_t at =
            binary + json_["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteOffset"].get<std::size_t>();
        for (std::size_t i = 0; i < 3 * accessor["count"].get<std::size_t>(); ++i) {
            float value = 0;
            std::memcpy(&value, bytes_.data() + at + 4 * i, 4);
            ASSERT_GE(value, accessor["min"][i % 3].get<float>());
            ASSERT_LE(value, accessor["max"][i % 3].get<float>());
        }
    }
}

/// One room with two chairs of one model, one of another colour, a table without model, and two lamps.
class FurnishedGltf : public ::testing::Test {
protected:
    FurnishedGltf() {
        plans::Plan plan = enfilade::testing::one_room();
        plans::Storey& ground = plan.storeys[0];
        ground.elevation = 1.5;
        ground.lights.push_back({"l1", "", {1, 1}, 2.25, {1, 0.5f, 0.25f}, 4 * std::numbers::pi});
        ground.lights.push_back({"l2", "Lamp", {2, 1}, 2.25, {1, 1, 1}, 800});
        const plans::Colour red = {0.5f, 0, 0};
        ground.furniture.push_back({"c1", "Chair", "chair", {1, 2}, 0, 0, 0.5, 0.25, 1, false, red});
        ground.furniture.push_back(
            {"c2", "Chair", "chair", {2, 2}, 0.125, std::numbers::pi / 2, 0.5, 0.25, 1, true, red});
        ground.furniture.push_back({"c3", "Chair", "chair", {3, 2}, 0, 0, 0.5, 0.25, 1, false, {}});
        ground.furniture.push_back({"t", "Table", "", {3, 1}, 0, 0, 1, 1, 0.75, false, {}});
        plan_ = test::built(plan);
        bytes_ = to_glb(plan_.scene.view(), fittings(plan_.model));
        json_ = nlohmann::json::parse(bytes_.substr(20, number_at(bytes_, 12)));
    }
    [[nodiscard]] std::vector<nlohmann::json> nodes_of(const std::string& label) const {
        std::vector<nlohmann::json> found;
        for (const auto& node : json_["nodes"])
            if (node.contains("extras") && node["extras"]["label"] == label) found.push_back(node);
        return found;
    }
    test::BuiltPlan plan_;
    std::string bytes_;
    nlohmann::json json_;
};

TEST_F(FurnishedGltf, LightsAreCandelaWhereThePlanHangsThem) {
    EXPECT_EQ(json_["extensionsUsed"], nlohmann::json({"KHR_lights_punctual"}));
    const auto& lights = json_["extensions"]["KHR_lights_punctual"]["lights"];
    ASSERT_EQ(lights.size(), 2u);
    // Of light of this colour 0.588 of what red alone would need is seen.
    EXPECT_NEAR(lights[0]["intensity"], 1 / (0.2126 + 0.5 * 0.7152 + 0.25 * 0.0722), 1e-5);
    EXPECT_EQ(lights[0]["color"], nlohmann::json({1.0, 0.5, 0.25}));
    EXPECT_NEAR(lights[1]["intensity"], 63.66, 0.01);
    const std::vector<nlohmann::json> nodes = nodes_of("light");
    ASSERT_EQ(nodes.size(), 2u);
    const auto& frame = plan_.model.frame;
    EXPECT_NEAR(nodes[1]["translation"][0], 2 - frame.origin_x, 1e-6);
    EXPECT_NEAR(nodes[1]["translation"][1], 1.5 + 2.25 - frame.origin_z, 1e-6);
    EXPECT_NEAR(nodes[1]["translation"][2], -(1 - frame.origin_y), 1e-6);
    EXPECT_EQ(nodes[1]["extensions"]["KHR_lights_punctual"]["light"], 1);
}

TEST_F(FurnishedGltf, PiecesOfOneModelAndColourShareAMesh) {
    const std::vector<nlohmann::json> nodes = nodes_of("furniture");
    ASSERT_EQ(nodes.size(), 4u);
    EXPECT_EQ(nodes[0]["mesh"], nodes[1]["mesh"]);
    EXPECT_NE(nodes[0]["mesh"], nodes[2]["mesh"]);
    EXPECT_NE(nodes[2]["mesh"], nodes[3]["mesh"]);
    const auto position = [&](const nlohmann::json& node) {
        return json_["meshes"][node["mesh"].get<std::size_t>()]["primitives"][0]["attributes"]["POSITION"];
    };
    EXPECT_EQ(position(nodes[0]), position(nodes[3])) << "one box in the buffer for all";
}

TEST_F(FurnishedGltf, TurnsAndScalesBoxes) {
    const nlohmann::json node = nodes_of("furniture")[1];
    EXPECT_EQ(node["scale"], nlohmann::json({0.5, 1.0, 0.25}));
    EXPECT_NEAR(node["rotation"][1], std::sin(std::numbers::pi / 4), 1e-12);
    EXPECT_NEAR(node["translation"][1], 1.5 + 0.125 - plan_.model.frame.origin_z, 1e-6);
    EXPECT_TRUE(node["extras"]["mirrored"]);
}

TEST_F(FurnishedGltf, HangFromTheirStorey) {
    std::size_t storeys = 0;
    for (const auto& node : json_["nodes"]) {
        if (node["name"] != "storey ground") continue;
        ++storeys;
        std::size_t fitted = 0;
        for (const auto& child : node["children"]) {
            const auto& label = json_["nodes"][child.get<std::size_t>()]["extras"]["label"];
            fitted += label == "light" || label == "furniture" ? 1 : 0;
        }
        EXPECT_EQ(fitted, 6u);
    }
    EXPECT_EQ(storeys, 1u);
}

TEST_F(FurnishedGltf, SkipsStoreysThatWereNotBuilt) {
    modeler::Building other = plan_.model;
    other.storeys[0].id = "another";
    EXPECT_TRUE(fittings(other).furniture.empty());
}

}  // namespace
}  // namespace enfilade::modeler
