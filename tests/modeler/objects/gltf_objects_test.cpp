// Furniture in a .glb file stands where it stands in the scene.

#include "modeler/exports/gltf_objects.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "accel/assemble.h"
#include "modeler/export_scene.h"
#include "modeler/exports/gltf.h"
#include "tests/support/furnished_scenes.h"

namespace enfilade::modeler {
namespace {

using Json = nlohmann::json;
using accel::SceneView;

struct Glb {
    Json json;
    std::string binary;

    explicit Glb(const std::string& bytes) {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, 4);
        json = Json::parse(bytes.substr(20, length));
        binary = bytes.substr(28 + length);
    }

    template <class T>
    [[nodiscard]] std::vector<T> numbers(std::size_t accessor) const {
        const Json& of = json["accessors"][accessor];
        const Json& view = json["bufferViews"][of["bufferView"].get<std::size_t>()];
        std::vector<T> values(view["byteLength"].get<std::size_t>() / sizeof(T));
        std::memcpy(values.data(), binary.data() + view["byteOffset"].get<std::size_t>(), values.size() * sizeof(T));
        return values;
    }
};

/// Corners of the node's triangles where they stand, with y up.
std::vector<std::array<double, 3>> corners_of(const Glb& glb, const Json& node) {
    std::vector<std::array<double, 3>> corners;
    if (!node.contains("mesh")) return corners;
    std::array<double, 16> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    if (node.contains("matrix")) m = node["matrix"].get<std::array<double, 16>>();
    for (const Json& primitive : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
        const auto points = glb.numbers<float>(primitive["attributes"]["POSITION"].get<std::size_t>());
        for (const std::uint32_t i : glb.numbers<std::uint32_t>(primitive["indices"].get<std::size_t>())) {
            std::array<double, 3> at{};
            for (std::size_t r = 0; r < 3; ++r)
                at[r] = m[r] * points[3 * i] + m[4 + r] * points[3 * i + 1] + m[8 + r] * points[3 * i + 2] + m[12 + r];
            corners.push_back(at);
        }
    }
    return corners;
}

TEST(GltfObjects, StandWhereTheSceneHasThem) {
    const accel::Scene scene = test::furnished_scene(test::FurnishedHouse::Townhouse, 8, 120);
    const SceneView& view = scene.view();
    const Glb glb(to_glb(view));
    std::map<std::string, const Json*> nodes;
    for (const Json& node : glb.json["nodes"])
        if (node.contains("extras") && node["extras"]["label"] == "furniture")
            nodes[node["extras"]["id"].get<std::string>()] = &node;
    ASSERT_EQ(nodes.size(), view.objects.size());
    std::set<std::size_t> meshes;
    std::size_t placed = 0;
    for (const accel::PlacedObject& object : view.objects) {
        const Json& node = *nodes.at(std::string(view.string(object.id)));
        const accel::ObjectMesh& mesh = view.meshes[index(object.mesh)];
        const auto corners = corners_of(glb, node);
        ASSERT_EQ(corners.size(), 3 * std::size_t{mesh.triangle_count});
        if (corners.empty()) continue;
        meshes.insert(node["mesh"].get<std::size_t>());
        placed += node.contains("matrix");
        // Triangles are by material there: the sums of all corners have to agree.
        std::array<double, 3> here{}, there{};
        for (const auto& p : corners)
            for (std::size_t k = 0; k < 3; ++k) here[k] += p[k];
        for (std::uint32_t t = mesh.first_triangle; t < mesh.first_triangle + mesh.triangle_count; ++t)
            for (const std::uint32_t c : view.mesh_triangles[t].corners) {
                const accel::Vertex& v = view.mesh_vertices[mesh.first_vertex + c];
                std::array<double, 3> p{};
                for (std::size_t r = 0; r < 3; ++r) {
                    const float* row = object.scene_from_object.rows.data() + 4 * r;
                    p[r] = double(row[0]) * v.x + double(row[1]) * v.y + double(row[2]) * v.z + row[3];
                }
                there[0] += p[0], there[1] += p[2], there[2] -= p[1];
            }
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(here[k] / double(corners.size()), there[k] / double(corners.size()), 1e-5);
    }
    EXPECT_LT(meshes.size(), view.objects.size() / 2) << "meshes are shared";
    EXPECT_GT(placed, view.objects.size() / 2);
}

TEST(GltfObjects, EachIsNamedUnderItsRoom) {
    const accel::Scene scene = test::furnished_scene(test::FurnishedHouse::Office, 8, 40);
    const Glb glb(to_glb(scene.view()));
    std::map<std::size_t, std::string> room_of;
    for (const Json& node : glb.json["nodes"])
        if (node.contains("children") && node.contains("extras"))
            for (const Json& child : node["children"])
                room_of[child.get<std::size_t>()] = node["extras"]["id"].get<std::string>();
    std::size_t found = 0;
    for (std::size_t n = 0; n < glb.json["nodes"].size(); ++n) {
        const Json& node = glb.json["nodes"][n];
        if (!node.contains("extras") || node["extras"]["label"] != "furniture") continue;
        for (const accel::PlacedObject& object : scene.view().objects)
            if (scene.view().string(object.id) == node["extras"]["id"].get<std::string>()) {
                EXPECT_EQ(room_of[n], scene.view().string(scene.view().spaces[index(object.space)].id));
                ++found;
            }
    }
    EXPECT_EQ(found, 40u);
}

}  // namespace
}  // namespace enfilade::modeler
