// The bytes of a .glb file, by the rules of glTF 2.0.

#include "modeler/exports/gltf.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

#include "accel/assemble.h"
#include "modeler/exports/scene_mesh.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::modeler {
namespace {

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

class Gltf : public testing::Test {
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

}  // namespace
}  // namespace enfilade::modeler
