#pragma once
// Where light is gathered of what a ray has found, and what lamps give there. Included by loops, which are compiled
// once for each instruction set, and as device code.

#include "render/lamp_light.h"
#include "render/shade.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// Of a pixel's light no smaller share is followed: it cannot be seen.
inline constexpr float least_share = 1.0f / 512;

/// Where the walk ended, on the face itself. Secondary rays need no epsilon: a walk starts in a cell and asks by which
/// face the line leaves it, so the face on which it starts is never hit again.
template <class T>
ENFILADE_HD Vec<T> end_point(const accel::SceneView& scene, const Ray<T>& ray, const WalkEnd<T>& end) {
    const accel::Cell& cell = scene.cells[end.cell];
    Vec<T> point = ray.origin + parameter(scene, ray, end) * ray.direction;
    if (end.exit == Exit::Floor || point.z < T(cell.z_floor)) point.z = T(cell.z_floor);
    if (end.exit == Exit::Ceiling || point.z > T(cell.z_ceiling)) point.z = T(cell.z_ceiling);
    return point;
}

/// The place on the face, or just off the triangle, at which a walk ended.
template <class Rooms, class T>
ENFILADE_HD LitPlace<T> place_of(const accel::SceneView& scene, const Ray<T>& ray, const Sight<T>& sight) {
    if constexpr (Rooms::are_furnished) {
        if (sight.end.status == WalkStatus::Object) {
            const Vec3f normal = facing_normal(ray, sight.hit);
            return {off_object(ray, sight.hit, normal), normal, sight.end.cell};
        }
    }
    return {end_point(scene, ray, sight.end), normal_of(scene, sight.end), sight.end.cell};
}

/// What lamps add to a white surface in the picture.
template <class T, class Rooms, class Events>
ENFILADE_HD Vec3f lamp_light(const accel::SceneView& scene, const Lamps& lamps, const Rooms& rooms,
                             const LitPlace<T>& at, Events& events) {
    constexpr float inverse_pi = 0.318309886f;
    LampLight<Rooms, Events> light(scene, lamps, rooms, events);
    return inverse_pi * lamps.exposure * light.at(at);
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
