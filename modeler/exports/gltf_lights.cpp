#include "modeler/exports/gltf_lights.h"

#include <algorithm>
#include <utility>

#include "base/id.h"

namespace enfilade::modeler {

namespace {

using Json = GltfFile::Json;

constexpr const char* lights_extension = "KHR_lights_punctual";

/// glTF has y up: (x, y, z) becomes (x, z, -y).
std::array<float, 3> y_up(const std::array<float, 3>& p) { return {p[0], p[2], 0.0f - p[1]}; }

std::size_t parent_of(const accel::SceneView& scene, const accel::Light& light,
                      const std::function<std::size_t(const std::string&)>& storey_node) {
    if (light.cell == none<accel::CellId>) return 0;
    const accel::Cell& cell = scene.cells[index(light.cell)];
    const std::string storey(scene.string(scene.spaces[index(cell.space)].storey));
    return storey.empty() ? 0 : storey_node(storey);
}

}  // namespace

void add_lights(const accel::SceneView& scene, const std::function<std::size_t(const std::string&)>& storey_node,
                GltfFile& file) {
    if (scene.lights.empty()) return;
    file.use_extension(lights_extension);
    Json lights = Json::array();
    for (const accel::Light& light : scene.lights) {
        const std::string id(scene.string(light.id));
        const std::string name = scene.string(light.name).empty() ? id : std::string(scene.string(light.name));
        const float most = std::ranges::max(light.intensity);
        std::array<float, 3> colour = {1, 1, 1};
        if (most > 0) std::ranges::transform(light.intensity, colour.begin(), [&](float c) { return c / most; });
        Json extras = {{"label", "light"}, {"id", id}};
        if (light.radius > 0) extras["radius"] = light.radius;
        const std::size_t parent = parent_of(scene, light, storey_node);
        const std::size_t node = file.add("nodes", {{"name", name},
                                                    {"translation", y_up(light.position)},
                                                    {"extras", std::move(extras)},
                                                    {"extensions", {{lights_extension, {{"light", lights.size()}}}}}});
        file["nodes"][parent]["children"].push_back(node);
        lights.push_back({{"name", name}, {"type", "point"}, {"color", colour}, {"intensity", most}});
    }
    file["extensions"][lights_extension] = {{"lights", std::move(lights)}};
}

}  // namespace enfilade::modeler
