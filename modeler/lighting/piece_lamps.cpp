#include "modeler/lighting/piece_lamps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "modeler/lighting/ceiling_lamps.h"

namespace enfilade::modeler {
namespace {

using Place = std::array<double, 3>;

constexpr std::string_view glass_name = "lamp glass";  ///< what shines of our own pieces (catalogue/own/paint.h)

/// The middle of the surface that is lamp glass, in the mesh's own frame; nothing where none is.
std::optional<Place> glass_of(const ObjectMesh& mesh) {
    Place sum = {0, 0, 0};
    double all = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (mesh.materials[mesh.triangle_materials[t]].name != glass_name) continue;
        std::array<Place, 3> p{};
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t r = 0; r < 3; ++r) p[k][r] = double{mesh.vertices[mesh.triangles[t][k]][r]};
        Place u{}, v{};
        for (std::size_t r = 0; r < 3; ++r) u[r] = p[1][r] - p[0][r], v[r] = p[2][r] - p[0][r];
        const double area = std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
        all += area;
        for (std::size_t r = 0; r < 3; ++r) sum[r] += area * (p[0][r] + p[1][r] + p[2][r]) / 3;
    }
    if (!(all > 0)) return std::nullopt;
    for (double& x : sum) x /= all;
    return sum;
}

Place placed(const Place& p, const std::array<double, 12>& plan_from_mesh) {
    Place result{};
    for (std::size_t r = 0; r < 3; ++r) {
        result[r] = plan_from_mesh[4 * r + 3];
        for (std::size_t k = 0; k < 3; ++k) result[r] += plan_from_mesh[4 * r + k] * p[k];
    }
    return result;
}

}  // namespace

std::vector<PieceLamp> piece_lamps(const Building& building, const LampRules& rules, const Catalogue& catalogue) {
    const Furnishing& furnishing = building.furnishing;
    std::set<std::string_view> shining;
    for (const Lamp& lamp : building.lamps) shining.insert(lamp.carrier);
    std::map<std::uint32_t, std::optional<Place>> glass;
    std::vector<PieceLamp> lamps;
    for (const FurnishedObject& object : furnishing.objects) {
        if (shining.contains(object.id)) continue;
        const CatalogueEntry* entry = catalogue.find(object.model);
        const PieceLight* light = entry == nullptr ? nullptr : rules.piece(entry->kind);
        if (light == nullptr) continue;
        const ObjectMesh& mesh = *furnishing.meshes[object.mesh];
        const auto [known, is_new] = glass.try_emplace(object.mesh);
        if (is_new) known->second = glass_of(mesh);
        PieceLamp made;
        made.space = object.space;
        made.lights_room = light->lights_room;
        Lamp& lamp = made.lamp;
        lamp.id = object.id + "/lamp";
        lamp.name = object.name;
        if (known->second) {
            lamp.position = to_millimetres(placed(*known->second, plan_from_mesh(object, mesh)));
        } else {
            const auto& [x, y, z] = object.position;
            lamp.position = to_millimetres({x, y, z + light->height * object.size[2]});
        }
        lamp.radius = light->radius;
        lamp.colour = colour_of_kelvin(light->kelvin);
        lamp.lumen = light->lumen;
        lamp.carrier = object.id;
        lamp.by_rule = true;
        lamps.push_back(std::move(made));
    }
    return lamps;
}

}  // namespace enfilade::modeler
