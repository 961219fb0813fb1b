#include "modeler/objects/scene_objects.h"

#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include "modeler/objects/object_cells.h"

namespace enfilade::modeler {
namespace {

using Textures = std::vector<std::shared_ptr<const accel::InputTexture>>;

/// Materials and textures of a scene, those of walls first, equal ones once.
class SceneMaterials {
public:
    explicit SceneMaterials(accel::SceneInput& input) : materials_(input.materials), textures_(input.textures) {
        for (std::uint32_t m = 0; m < materials_.size(); ++m) known_.emplace(key_of(materials_[m]), m);
    }

    /// textures: those that the material's look may name.
    std::uint32_t of(const ObjectMaterial& from, const Textures& textures) {
        accel::InputMaterial material{from.name, from.colour, from.look};
        if (from.look.texture != UINT32_MAX) material.look.texture = number_of(textures[from.look.texture]);
        const auto [at, is_new] = known_.try_emplace(key_of(material), std::uint32_t(materials_.size()));
        if (is_new) materials_.push_back(std::move(material));
        return at->second;
    }

private:
    using Key = std::tuple<std::string, std::array<float, 3>, accel::InputLook>;
    static Key key_of(const accel::InputMaterial& m) { return {m.name, m.colour, m.look}; }

    std::uint32_t number_of(const Textures::value_type& texture) {
        for (std::uint32_t t = 0; t < textures_.size(); ++t)
            if (textures_[t] == texture || *textures_[t] == *texture) return t;
        textures_.push_back(texture);
        return std::uint32_t(textures_.size() - 1);
    }

    std::vector<accel::InputMaterial>& materials_;
    Textures& textures_;
    std::map<Key, std::uint32_t> known_;
};

/// Materials get their numbers in the order in which triangles use them: so it is again when they are read back.
std::shared_ptr<const accel::InputMesh> scene_mesh(const ObjectMesh& mesh, SceneMaterials& materials) {
    auto result = std::make_shared<accel::InputMesh>();
    result->name = mesh.name;
    result->vertices = mesh.vertices;
    result->triangles = mesh.triangles;
    result->texcoords = mesh.texcoords;
    std::vector<std::uint32_t> numbers(mesh.materials.size(), UINT32_MAX);
    result->triangle_materials.reserve(mesh.triangle_materials.size());
    for (const std::uint32_t m : mesh.triangle_materials) {
        if (numbers[m] == UINT32_MAX) numbers[m] = materials.of(mesh.materials[m], mesh.textures);
        result->triangle_materials.push_back(numbers[m]);
    }
    return result;
}

std::string colour_name(const std::array<float, 3>& colour) {
    char text[64];
    std::snprintf(text, sizeof text, "object %.4g %.4g %.4g", double(colour[0]), double(colour[1]), double(colour[2]));
    return text;
}

/// The boxes of meshes, each way of turning one once.
class TurnedBoxes {
public:
    explicit TurnedBoxes(const Furnishing& furnishing) : furnishing_(furnishing) {}

    const TurnedBox& of(const FurnishedObject& object) {
        const auto [at, is_new] = known_.try_emplace({object.mesh, object.turned});
        if (is_new) at->second = turned_box(object.turned, *furnishing_.meshes[object.mesh]);
        return at->second;
    }

private:
    const Furnishing& furnishing_;
    std::map<std::pair<std::uint32_t, std::array<double, 9>>, TurnedBox> known_;
};

/// The spaces of boxes, by their ids.
std::map<std::string, std::uint32_t, std::less<>> object_spaces(const Building& building) {
    std::map<std::string, std::uint32_t, std::less<>> spaces;
    for (std::uint32_t s = 0; s < building.spaces.size(); ++s)
        if (building.spaces[s].label == Label::Object) spaces.emplace(building.spaces[s].id, s);
    return spaces;
}

}  // namespace

void add_objects(const Building& building, accel::SceneInput& input) {
    const Furnishing& furnishing = building.furnishing;
    if (furnishing.empty()) return;
    SceneMaterials materials(input);
    for (const auto& mesh : furnishing.meshes) input.meshes.push_back(scene_mesh(*mesh, materials));
    const ObjectCellFinder finder(input, building.frame);
    const auto volumes = object_spaces(building);
    TurnedBoxes boxes(furnishing);
    input.cell_objects.resize(input.cells.size());
    for (std::uint32_t k = 0; k < furnishing.objects.size(); ++k) {
        const FurnishedObject& from = furnishing.objects[k];
        accel::InputObject object;
        object.id = from.id;
        object.name = from.name;
        object.mesh = from.mesh;
        if (from.colour) object.material = materials.of({colour_name(*from.colour), *from.colour}, {});
        const auto own = from.volume.empty() ? volumes.end() : volumes.find(from.volume);
        object.space = own == volumes.end() ? from.space : own->second;
        object.scene_from_object = plan_from_mesh(from, boxes.of(from));
        for (std::size_t r = 0; r < 3; ++r) object.scene_from_object[4 * r + 3] -= input.origin[r];
        for (const std::uint32_t cell : finder.cells_of(box_of(from), object.space))
            input.cell_objects[cell].push_back(k);
        input.objects.push_back(std::move(object));
    }
}

}  // namespace enfilade::modeler
