#include "modeler/exports/gltf.h"

#include <cstdint>
#include <map>
#include <utility>

#include "modeler/exports/gltf_file.h"
#include "modeler/exports/gltf_fittings.h"
#include "modeler/exports/gltf_lights.h"
#include "modeler/exports/gltf_objects.h"
#include "modeler/exports/scene_mesh.h"

namespace enfilade::modeler {

namespace {

using Json = GltfFile::Json;
using Point3 = GltfFile::Point3;

/// glTF has y up: (x, y, z) becomes (x, z, -y).
Point3 y_up(const Point3& p) { return {p[0], p[2], 0.0f - p[1]}; }

class Writer {
public:
    Writer(const accel::SceneView& scene, const Fittings& fittings)
        : scene_(scene), fittings_(fittings), mesh_(scene_mesh(scene)), space_nodes_(scene.spaces.size(), 0) {
        // Real meshes instead of boxes.
        if (scene.has_objects()) fittings_.furniture.clear();
    }

    std::string write() {
        for (const MeshMaterial& material : mesh_.materials) add_material(material);
        add_nodes();
        return file_.bytes();
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
        file_.add("materials", std::move(json));
    }

    /// Root, storeys, spaces and fittings; spaces of no storey hang from the root.
    void add_nodes() {
        file_.add("nodes", {{"name", "building"}, {"children", Json::array()}});
        const Point3 origin = y_up({float(scene_.origin[0]), float(scene_.origin[1]), float(scene_.origin[2])});
        if (origin != Point3{}) file_["nodes"][0]["translation"] = origin;
        for (const MeshSpace& space : mesh_.spaces) {
            const std::string storey(scene_.string(scene_.spaces[index(space.space)].storey));
            const std::size_t parent = storey.empty() ? 0 : storey_node(storey);
            const std::size_t child = file_.add("nodes", node(space));
            file_["nodes"][parent]["children"].push_back(child);
            space_nodes_[index(space.space)] = child;
        }
        std::vector<std::size_t> storeys;
        for (const StoreyInfo& storey : fittings_.storeys)
            storeys.push_back(has_fittings(storeys.size()) ? storey_node(storey.id) : 0);
        add_fittings(fittings_, storeys, file_);
        add_lights(
            scene_, [&](const std::string& storey) { return storey_node(storey); }, file_);
        if (scene_.has_objects()) add_objects(scene_, space_nodes_, file_);
        for (Json& each : file_["nodes"])
            if (each.contains("children") && each["children"].empty()) each.erase("children");
        file_.add("scenes", {{"name", "building"}, {"nodes", {0}}});
    }

    bool has_fittings(std::size_t storey) const {
        for (const PlacedFurniture& piece : fittings_.furniture)
            if (piece.storey == storey) return true;
        return false;
    }

    std::size_t storey_node(const std::string& storey) {
        const auto [found, fresh] = storeys_.try_emplace(storey, 0);
        if (fresh) {
            found->second = file_.add("nodes", {{"name", "storey " + storey}, {"children", Json::array()}});
            file_["nodes"][0]["children"].push_back(found->second);
        }
        return found->second;
    }

    Json node(const MeshSpace& mesh_space) {
        const accel::Space& space = scene_.spaces[index(mesh_space.space)];
        Json primitives = Json::array();
        for (const MeshPart& part : mesh_space.parts) primitives.push_back(primitive(part));
        const std::size_t mesh =
            file_.add("meshes", {{"name", mesh_space.name}, {"primitives", std::move(primitives)}});
        Json json = {{"name", mesh_space.name}, {"mesh", mesh}};
        json["extras"] = {{"label", accel::name_of(space.label)}, {"id", scene_.string(space.id)}};
        if (space.area_m2 > 0) json["extras"]["area_m2"] = space.area_m2;
        return json;
    }

    Json primitive(const MeshPart& part) {
        std::vector<Point3> positions;
        std::vector<Point3> normals;
        for (const Point3& p : part.positions) positions.push_back(y_up(p));
        for (const Point3& n : part.normals) normals.push_back(y_up(n));
        const std::size_t position = file_.add_positions(positions);
        const std::size_t normal = file_.add_normals(normals);
        const std::size_t indices = file_.add_indices(part.indices);
        return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
                {"indices", indices},
                {"material", part.material}};
    }

    const accel::SceneView& scene_;
    Fittings fittings_;
    SceneMesh mesh_;
    GltfFile file_;
    std::map<std::string, std::size_t> storeys_;  ///< node of each storey
    std::vector<std::size_t> space_nodes_;        ///< [space] its node; 0, the root, where it shows no face
};

}  // namespace

std::string to_glb(const accel::SceneView& scene, const Fittings& fittings) { return Writer(scene, fittings).write(); }

}  // namespace enfilade::modeler
