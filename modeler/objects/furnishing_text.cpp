#include "modeler/objects/furnishing_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "modeler/objects/scene_textures.h"

namespace enfilade::modeler {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void damaged(const std::string& what) {
    throw InputError("F20", "", "The scene's model is damaged: " + what + ". Build the scene again from its plan.");
}

/// What most objects have is not written.
Json object_json(const FurnishedObject& object) {
    const FurnishedObject usual;
    Json json = {{"id", object.id},       {"name", object.name},   {"model", object.model},
                 {"mesh", object.mesh},   {"space", object.space}, {"position", object.position},
                 {"angle", object.angle}, {"size", object.size}};
    if (object.mirrored) json["mirrored"] = true;
    if (object.turned != usual.turned) json["turned"] = object.turned;
    if (object.colour) json["colour"] = *object.colour;
    if (object.by_rule) json["by_rule"] = true;
    if (!object.stands_on.empty()) json["stands_on"] = object.stands_on;
    if (!object.volume.empty()) json["volume"] = object.volume;
    return json;
}

template <std::size_t n>
std::array<double, n> numbers(const Json& json, const char* what) {
    const auto values = json.get<std::array<double, n>>();
    for (const double value : values)
        if (!(std::abs(value) < 1e9)) damaged(std::string(what) + " of an object beyond all bounds");
    return values;
}

FurnishedObject object_from(const Json& json) {
    FurnishedObject object;
    object.id = json.at("id");
    object.name = json.at("name");
    object.model = json.at("model");
    object.mesh = json.at("mesh");
    object.space = json.at("space");
    object.position = numbers<3>(json.at("position"), "the position");
    object.angle = json.at("angle");
    if (!(std::abs(object.angle) < 1e9)) damaged("the angle of an object beyond all bounds");
    object.size = numbers<3>(json.at("size"), "the size");
    for (const double length : object.size)
        if (!(length > 0)) damaged("an object without size");
    object.mirrored = json.value("mirrored", false);
    if (json.contains("turned")) object.turned = numbers<9>(json.at("turned"), "the rotation");
    if (json.contains("colour")) object.colour = json.at("colour").get<std::array<float, 3>>();
    object.by_rule = json.value("by_rule", false);
    object.stands_on = json.value("stands_on", "");
    object.volume = json.value("volume", "");
    return object;
}

using Textures = std::vector<std::shared_ptr<const accel::InputTexture>>;

/// A material of the scene as one of a mesh, whose textures it adds.
ObjectMaterial material_from(const accel::SceneView& scene, accel::MaterialId id, const Textures& textures,
                             ObjectMesh& mesh) {
    const accel::Material& from = scene.materials[index(id)];
    ObjectMaterial material{std::string(scene.string(from.name)), from.colour};
    if (!scene.has_looks()) return material;
    const accel::MaterialLook& look = scene.material_looks[index(id)];
    material.look = {look.mirror, look.through, UINT32_MAX, look.texture_from_face};
    if (look.texture == none<accel::TextureId>) return material;
    const auto& texture = textures[index(look.texture)];
    const auto at = std::find(mesh.textures.begin(), mesh.textures.end(), texture);
    material.look.texture = std::uint32_t(at - mesh.textures.begin());
    if (at == mesh.textures.end()) mesh.textures.push_back(texture);
    return material;
}

std::shared_ptr<const ObjectMesh> mesh_from(const accel::SceneView& scene, const accel::ObjectMesh& from,
                                            const Textures& textures) {
    auto mesh = std::make_shared<ObjectMesh>();
    mesh->name = scene.string(from.name);
    mesh->vertices.reserve(from.vertex_count);
    for (std::uint32_t v = from.first_vertex; v < from.first_vertex + from.vertex_count; ++v)
        mesh->vertices.push_back({scene.mesh_vertices[v].x, scene.mesh_vertices[v].y, scene.mesh_vertices[v].z});
    std::vector<std::uint32_t> own(scene.materials.size(), UINT32_MAX);
    mesh->triangles.reserve(from.triangle_count);
    mesh->triangle_materials.reserve(from.triangle_count);
    for (std::uint32_t t = from.first_triangle; t < from.first_triangle + from.triangle_count; ++t) {
        const accel::MeshTriangle& triangle = scene.mesh_triangles[t];
        std::uint32_t& number = own[index(triangle.material)];
        if (number == UINT32_MAX) {
            number = std::uint32_t(mesh->materials.size());
            mesh->materials.push_back(material_from(scene, triangle.material, textures, *mesh));
        }
        mesh->triangles.push_back(triangle.corners);
        mesh->triangle_materials.push_back(number);
    }
    for (std::uint32_t k = 0; from.texcoords != 0 && k < 3 * from.triangle_count; ++k) {
        const accel::TexCoord& at = scene.mesh_texcoords[from.texcoords - 1 + k];
        mesh->texcoords.push_back({at.u, at.v});
    }
    return mesh;
}

}  // namespace

std::string furnishing_text(const Furnishing& furnishing) {
    Json json = {{"cells", furnishing.cells == ObjectCells::Cut ? "cut" : "list"}, {"objects", Json::array()}};
    for (const FurnishedObject& object : furnishing.objects) json["objects"].push_back(object_json(object));
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Furnishing read_furnishing(const std::string& text, const accel::SceneView& scene, const std::vector<Space>& spaces) {
    Furnishing furnishing;
    try {
        const Json json = Json::parse(text);
        furnishing.cells = json.at("cells") == "cut" ? ObjectCells::Cut : ObjectCells::List;
        for (const Json& object : json.at("objects")) furnishing.objects.push_back(object_from(object));
    } catch (const Json::exception& error) {
        damaged(error.what());
    }
    for (std::size_t k = 0; k < furnishing.objects.size(); ++k) {
        const FurnishedObject& object = furnishing.objects[k];
        if (k > 0 && furnishing.objects[k - 1].id >= object.id) damaged("its objects are out of order");
        if (object.mesh >= scene.meshes.size() || object.space >= spaces.size())
            damaged("an object of no mesh or no room");
    }
    const Textures textures = scene_textures(scene);
    for (const accel::ObjectMesh& mesh : scene.meshes) furnishing.meshes.push_back(mesh_from(scene, mesh, textures));
    return furnishing;
}

}  // namespace enfilade::modeler
