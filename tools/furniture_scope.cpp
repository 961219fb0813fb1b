#include "tools/furniture_scope.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "accel/assemble.h"
#include "modeler/export_scene.h"
#include "modeler/lighting/rule_lamps.h"
#include "render/executor.h"
#include "render/look.h"
#include "tools/bench.h"
#include "tools/view_file.h"
#include "tools/visible_rooms.h"

namespace enfilade::tools {

namespace {

using accel::SceneView;

struct Box {
    std::array<double, 3> low = {INFINITY, INFINITY, INFINITY};
    std::array<double, 3> high = {-INFINITY, -INFINITY, -INFINITY};
    void add(double x, double y, double z) {
        const std::array<double, 3> p = {x, y, z};
        for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], p[k]), high[k] = std::max(high[k], p[k]);
    }
    [[nodiscard]] bool meets(const Box& other) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (low[k] > other.high[k] || other.low[k] > high[k]) return false;
        return true;
    }
};

Box box_of(const SceneView& scene, const accel::Cell& cell) {
    Box box;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        box.add(double{scene.section_x[s]}, double{scene.section_y[s]}, double{cell.z_floor});
        box.add(double{scene.section_x[s]}, double{scene.section_y[s]}, double{cell.z_ceiling});
    }
    return box;
}

/// A piece whatever its angle, in the scene's frame.
Box box_of(const SceneView& scene, const plans::Storey& storey, const plans::Furniture& piece) {
    constexpr double spare = 0.01;
    const double reach = std::hypot(piece.width, piece.depth, piece.height) + spare;  // it may be tilted
    const double x = piece.position.x - scene.origin[0], y = piece.position.y - scene.origin[1];
    const double z = storey.elevation + piece.elevation - scene.origin[2];
    Box box;
    box.add(x - reach, y - reach, z - reach);
    box.add(x + reach, y + reach, z + reach);
    return box;
}

/// All rooms of that name.
std::vector<accel::SpaceId> rooms_named(const SceneView& scene, const std::string& name) {
    std::vector<accel::SpaceId> rooms;
    for (std::size_t s = 0; s < scene.spaces.size(); ++s)
        if (scene.spaces[s].label == accel::Label::Room && scene.string(scene.spaces[s].name) == name)
            rooms.push_back(accel::SpaceId(s));
    return rooms;
}

/// "Kitchen,Bath 2": names without commas, or one name with some; ids where no room is named so.
std::vector<accel::SpaceId> listed_rooms(const SceneView& scene, const std::string& list) {
    std::vector<accel::SpaceId> rooms = rooms_named(scene, list);
    if (!rooms.empty()) return rooms;
    for (std::size_t at = 0; at != std::string::npos;) {
        const std::size_t comma = list.find(',', at);
        const std::string name = list.substr(at, comma == std::string::npos ? comma : comma - at);
        std::vector<accel::SpaceId> found = rooms_named(scene, name);
        if (found.empty()) found.push_back(room_by_name(scene, name));
        rooms.insert(rooms.end(), found.begin(), found.end());
        at = comma == std::string::npos ? comma : comma + 1;
    }
    return rooms;
}

modeler::ScopeEyes eyes_of(const FurnishFlags& flags, const SceneView& scene) {
    modeler::ScopeEyes eyes;
    if (!flags.rooms.empty()) eyes.rooms = listed_rooms(scene, flags.rooms);
    if (flags.views.empty()) return eyes;
    for (const SavedView& view : read_views(flags.views, scene).views) {
        const render::Vec3f eye = render::vec_cast<float>(view.camera.eye);
        eyes.points.push_back({view.cell, {double{eye.x}, double{eye.y}, double{eye.z}}});
    }
    return eyes;
}

modeler::ScopeLight light_of(const FurnishFlags& flags, const SceneView& scene, const modeler::Building& building) {
    const render::Look look;
    modeler::ScopeLight light;
    light.sun = {double{look.sun_direction.x}, double{look.sun_direction.y}, double{look.sun_direction.z}};
    light.reach = double{look.ambient_reach};
    if (!flags.lit) return light;
    std::vector<modeler::Lamp> lamps = building.lamps;
    if (const auto rules = lamp_rules_of(flags)) {
        if (rules->replace) lamps.clear();
        for (modeler::Lamp& lamp : modeler::rule_lamps(building, *rules, nullptr, *render::make_executor()))
            lamps.push_back(std::move(lamp));
    }
    for (const modeler::Lamp& lamp : lamps) {
        const auto& [x, y, z] = lamp.position;
        light.lamps.push_back({x - scene.origin[0], y - scene.origin[1], z - scene.origin[2]});
    }
    return light;
}

/// The scope's spaces, and all that a piece lies in which lies in one of them, too: it may stand in any.
std::vector<std::uint32_t> spaces_of_pieces(const SceneView& scene, const modeler::Scope& scope,
                                            const plans::Plan& plan) {
    std::vector<char> is_wanted(scene.spaces.size());
    for (const accel::SpaceId space : scope.spaces) is_wanted[index(space)] = 1;
    const std::vector<char> is_in_scope = is_wanted;
    std::vector<Box> boxes;
    for (const accel::Cell& cell : scene.cells) boxes.push_back(box_of(scene, cell));
    std::vector<std::size_t> spaces;
    for (const plans::Storey& storey : plan.storeys)
        for (const plans::Furniture& piece : storey.furniture) {
            const Box box = box_of(scene, storey, piece);
            spaces.clear();
            bool reaches = false;
            for (std::size_t c = 0; c < boxes.size(); ++c) {
                if (!box.meets(boxes[c])) continue;
                spaces.push_back(index(scene.cells[c].space));
                reaches |= is_in_scope[spaces.back()] != 0;
            }
            if (reaches)
                for (const std::size_t space : spaces) is_wanted[space] = 1;
        }
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t s = 0; s < is_wanted.size(); ++s)
        if (is_wanted[s] != 0) wanted.push_back(s);
    return wanted;
}

}  // namespace

std::optional<modeler::LampRules> lamp_rules_of(const FurnishFlags& flags) {
    if (!flags.lamps) return std::nullopt;
    return flags.lamps->empty() ? modeler::own_lamp_rules() : modeler::read_lamp_rules(*flags.lamps);
}

FurnitureScope furniture_scope(const FurnishFlags& flags, const modeler::Building& building, const plans::Plan& plan) {
    FurnitureScope found;
    found.seconds = seconds_of([&] {
        const accel::Scene bare = accel::assemble(modeler::scene_input(building));
        const SceneView& scene = bare.view();
        const modeler::ScopeLight light = light_of(flags, scene, building);
        found.scope = modeler::scope_of(scene, eyes_of(flags, scene), light, *render::make_executor());
        found.pieces = spaces_of_pieces(scene, found.scope, plan);
        for (const accel::SpaceId space : found.scope.spaces)
            if (scene.spaces[index(space)].label == accel::Label::Room)
                found.rooms.push_back(std::uint32_t(index(space)));
        for (const accel::Space& space : scene.spaces) found.all_rooms += space.label == accel::Label::Room;
        found.all_spaces = scene.spaces.size();
        found.all_cells = scene.cells.size();
        found.lamps = light.lamps.size();
    });
    return found;
}

}  // namespace enfilade::tools
