#include "tools/furniture_summary.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "tools/console.h"

namespace enfilade::tools {

namespace {

using Json = nlohmann::ordered_json;
using Counts = std::map<std::string, std::size_t>;

std::string mesh_name(const accel::SceneView& scene, const accel::PlacedObject& object) {
    return std::string(scene.string(scene.meshes[index(object.mesh)].name));
}

/// By space: how many objects of each mesh.
std::map<std::size_t, Counts> by_space(const accel::SceneView& scene) {
    std::map<std::size_t, Counts> spaces;
    for (const accel::PlacedObject& object : scene.objects) ++spaces[index(object.space)][mesh_name(scene, object)];
    return spaces;
}

std::size_t sum(const Counts& counts) {
    std::size_t all = 0;
    for (const auto& [name, count] : counts) all += count;
    return all;
}

/// "4 Chair, 1 Desk"
std::string counts_text(const Counts& counts) {
    std::vector<std::pair<std::string, std::size_t>> ordered(counts.begin(), counts.end());
    std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (const auto& [name, count] : ordered)
        text += (text.empty() ? "" : ", ") + grouped(count) + ' ' + (name.empty() ? "unnamed" : name);
    return text;
}

}  // namespace

std::string furniture_text(const accel::SceneView& scene, const accel::SceneStats& stats) {
    if (scene.objects.size() == 0) return {};
    std::string text = "\nFurniture\n";
    for (const auto& [number, counts] : by_space(scene)) {
        const accel::Space& space = scene.spaces[number];
        const std::string_view name =
            scene.string(space.name).empty() ? scene.string(space.id) : scene.string(space.name);
        text += "  " + std::string(name) + ": " + counts_text(counts) + '\n';
    }
    text +=
        "  in all              " + counted(stats.objects, "object") + " of " + counted(stats.meshes, "mesh", "meshes");
    text += "\n  triangles           " + grouped(stats.unique_triangles) + ", with all copies " +
            grouped(stats.instanced_triangles);
    text += "\n  listed in cells     " + grouped(stats.listed_objects) + " times";
    if (stats.texture_bytes > 0)
        text += "\n  textures            " + grouped(stats.textures) + ", with mirrors and glass " +
                byte_text(double(stats.texture_bytes));
    return text + "\n  bytes               " + byte_text(double(stats.mesh_bytes)) + " of meshes, " +
           byte_text(double(stats.object_bytes)) + " of places and lists\n";
}

Json furniture_json(const accel::SceneView& scene, const accel::SceneStats& stats) {
    if (scene.objects.size() == 0) return nullptr;
    Json json = {{"objects", stats.objects},
                 {"meshes", stats.meshes},
                 {"triangles", stats.unique_triangles},
                 {"instanced_triangles", stats.instanced_triangles},
                 {"listed_objects", stats.listed_objects},
                 {"object_bytes", stats.object_bytes},
                 {"mesh_bytes", stats.mesh_bytes},
                 {"textures", stats.textures},
                 {"texture_bytes", stats.texture_bytes}};
    json["spaces"] = Json::array();
    for (const auto& [number, counts] : by_space(scene)) {
        const accel::Space& space = scene.spaces[number];
        Json one = {{"id", scene.string(space.id)}, {"name", scene.string(space.name)}, {"objects", sum(counts)}};
        one["models"] = Json::object();
        for (const auto& [name, count] : counts) one["models"][name] = count;
        json["spaces"].push_back(std::move(one));
    }
    return json;
}

}  // namespace enfilade::tools
