#include "render/lamp_oracle.h"

#include <algorithm>
#include <cmath>

#include "render/object_walk.h"

namespace enfilade::render {
namespace {

constexpr double least_sine = 1e-5;  ///< of the angle between a way and a face that it grazes

}  // namespace

LampOracle::LampOracle(const accel::SceneView& scene, double band) : scene_(scene), faces_(scene), band_(band) {
    if (scene.has_objects()) objects_.emplace(scene, band);
}

Vec3d LampOracle::position(std::uint32_t lamp) const {
    const auto& p = scene_.lights[lamp].position;
    return {p[0], p[1], p[2]};
}

std::optional<bool> LampOracle::sees(Vec3d place, std::uint32_t lamp) const {
    const accel::Light& light = scene_.lights[lamp];
    if (light.cell == none<accel::CellId>) return false;
    const Vec3d way = position(lamp) - place;
    const auto wall = faces_.trace(place, way);
    if (wall && wall->distance < length(way)) return false;
    if (!objects_) return true;
    const auto is_between = objects_->stands_between(place, position(lamp), double{touch_slack}, light.carrier);
    if (!is_between) return {};
    return !*is_between;
}

bool LampOracle::is_close(Vec3d place, std::uint32_t lamp) const {
    const Vec3d way = position(lamp) - place;
    const double distance = length(way);
    if (!(distance > band_)) return true;
    if (const auto wall = faces_.trace(place, way)) {
        const double sine = std::abs(dot(faces_.normal(wall->source_face), normalized(way)));
        const double reach = band_ / std::max(sine, least_sine);
        if (wall->distance <= reach || std::abs(wall->distance - distance) <= reach) return true;
    }
    return faces_.edge_distance(place, way, distance) <= band_;
}

bool LampOracle::allows(Vec3d place, std::uint32_t lamp, bool is_seen) const {
    const auto truth = sees(place, lamp);
    return !truth || *truth == is_seen || is_close(place, lamp);
}

}  // namespace enfilade::render
