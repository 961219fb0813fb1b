#include "modeler/exports/gltf.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "base/error.h"
#include "modeler/exports/scene_mesh.h"

namespace enfilade::modeler {

namespace {

using Json = nlohmann::ordered_json;
using Point3 = std::array<float, 3>;

// Numbers of the glTF 2.0 specification.
constexpr int array_buffer = 34962;
constexpr int element_array_buffer = 34963;
constexpr int type_float = 5126;
constexpr int type_unsigned_int = 5125;
constexpr std::uint32_t magic = 0x46546C67;
constexpr std::uint32_t chunk_json = 0x4E4F534A;
constexpr std::uint32_t chunk_binary = 0x004E4942;

/// glTF has y up: (x, y, z) becomes (x, z, -y).
Point3 y_up(const Point3& p) { return {p[0], p[2], 0.0f - p[1]}; }

class Writer {
public:
    explicit Writer(const accel::SceneView& scene) : scene_(scene), mesh_(scene_mesh(scene)) {
        json_["asset"] = {{"version", "2.0"}, {"generator", "Enfilade"}};
        json_["scene"] = 0;
        for (const char* list : {"scenes", "nodes", "meshes", "materials", "accessors", "bufferViews", "buffers"})
            json_[list] = Json::array();
    }

    std::string write() {
        for (const MeshMaterial& material : mesh_.materials) add_material(material);
        add_nodes();
        json_["buffers"].push_back({{"byteLength", binary_.size()}});
        return file();
    }

private:
    void add_material(const MeshMaterial& material) {
        const auto& [r, g, b] = material.colour;
        Json json = {{"name", material.name}};
        json["pbrMetallicRoughness"] = {
            {"baseColorFactor", {r, g, b, material.opacity}}, {"metallicFactor", 0}, {"roughnessFactor", 1}};
        if (material.opacity < 1) {
            json["alphaMode"] = "BLEND";
            json["doubleSided"] = true;
        }
        json_["materials"].push_back(std::move(json));
    }

    /// Root, storeys, spaces; spaces of no storey hang from the root.
    void add_nodes() {
        Json& nodes = json_["nodes"];
        nodes.push_back({{"name", "building"}, {"children", Json::array()}});
        const Point3 origin = y_up({float(scene_.origin[0]), float(scene_.origin[1]), float(scene_.origin[2])});
        if (origin != Point3{}) nodes[0]["translation"] = origin;
        std::map<std::string, std::size_t> storeys;
        for (const MeshSpace& space : mesh_.spaces) {
            const std::string storey(scene_.string(scene_.spaces[index(space.space)].storey));
            std::size_t parent = 0;
            if (!storey.empty()) {
                const auto [found, fresh] = storeys.try_emplace(storey, nodes.size());
                parent = found->second;
                if (fresh) {
                    nodes[0]["children"].push_back(parent);
                    nodes.push_back({{"name", "storey " + storey}, {"children", Json::array()}});
                }
            }
            nodes[parent]["children"].push_back(nodes.size());
            nodes.push_back(node(space));
        }
        if (nodes[0]["children"].empty()) nodes[0].erase("children");
        json_["scenes"].push_back({{"name", "building"}, {"nodes", {0}}});
    }

    Json node(const MeshSpace& mesh_space) {
        const accel::Space& space = scene_.spaces[index(mesh_space.space)];
        Json primitives = Json::array();
        for (const MeshPart& part : mesh_space.parts) primitives.push_back(primitive(part));
        Json json = {{"name", mesh_space.name}, {"mesh", json_["meshes"].size()}};
        json_["meshes"].push_back({{"name", mesh_space.name}, {"primitives", std::move(primitives)}});
        json["extras"] = {{"label", accel::name_of(space.label)}, {"id", scene_.string(space.id)}};
        if (space.area_m2 > 0) json["extras"]["area_m2"] = space.area_m2;
        return json;
    }

    Json primitive(const MeshPart& part) {
        std::vector<Point3> positions;
        std::vector<Point3> normals;
        for (const Point3& p : part.positions) positions.push_back(y_up(p));
        for (const Point3& n : part.normals) normals.push_back(y_up(n));
        Point3 low = positions[0];
        Point3 high = positions[0];
        for (const Point3& p : positions)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        const std::size_t position =
            accessor(std::as_bytes(std::span(positions)), array_buffer, type_float, "VEC3", positions.size());
        json_["accessors"][position]["min"] = low;
        json_["accessors"][position]["max"] = high;
        const std::size_t normal =
            accessor(std::as_bytes(std::span(normals)), array_buffer, type_float, "VEC3", normals.size());
        const std::size_t indices = accessor(std::as_bytes(std::span(part.indices)), element_array_buffer,
                                             type_unsigned_int, "SCALAR", part.indices.size());
        return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
                {"indices", indices},
                {"material", part.material}};
    }

    /// Puts `bytes` (whole 4-byte numbers) into the buffer; returns the index of the accessor.
    std::size_t accessor(std::span<const std::byte> bytes, int target, int component, const char* type,
                         std::size_t count) {
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}, {"target", target}});
        binary_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        json_["accessors"].push_back({{"bufferView", json_["bufferViews"].size() - 1},
                                      {"componentType", component},
                                      {"count", count},
                                      {"type", type}});
        return json_["accessors"].size() - 1;
    }

    /// Header and two chunks, each filled up to a multiple of four bytes.
    std::string file() {
        std::string json = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
        json.resize((json.size() + 3) / 4 * 4, ' ');
        const std::size_t size = 12 + 8 + json.size() + 8 + binary_.size();
        if (size > UINT32_MAX)
            throw InputError(
                "F110", "",
                "The scene is too large for glTF, whose files end at 4 GiB: build fewer storeys (--storeys).");
        std::string out;
        const auto put = [&out](std::uint32_t number) {
            char bytes[4];
            std::memcpy(bytes, &number, 4);
            out.append(bytes, 4);
        };
        put(magic);
        put(2);
        put(std::uint32_t(size));
        put(std::uint32_t(json.size()));
        put(chunk_json);
        out += json;
        put(std::uint32_t(binary_.size()));
        put(chunk_binary);
        return out += binary_;
    }

    const accel::SceneView& scene_;
    SceneMesh mesh_;
    Json json_;
    std::string binary_;
};

}  // namespace

std::string to_glb(const accel::SceneView& scene) { return Writer(scene).write(); }

}  // namespace enfilade::modeler
