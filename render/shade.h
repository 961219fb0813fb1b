#pragma once
// Surfaces and light, on host and device.

#include "accel/scene.h"
#include "render/isa.h"
#include "render/look.h"
#include "render/walk.h"

namespace enfilade::render {

inline namespace ENFILADE_ISA {

ENFILADE_HD accel::SourceFace source_face_of(const accel::SceneView& scene, accel::Target target) {
    return scene.source_faces[target.bits];
}

ENFILADE_HD Vec3f colour_of(const accel::SceneView& scene, const accel::SourceFace& face) {
    const float* c = reinterpret_cast<const float*>(&scene.materials[static_cast<std::uint32_t>(face.material)]);
    return {c[0], c[1], c[2]};
}

/// The unit normal on the light's side of where a walk ended.
template <class T>
ENFILADE_HD Vec3f normal_of(const accel::SceneView& scene, const WalkEnd<T>& end) {
    if (end.exit == Exit::Floor) return {0, 0, 1};
    if (end.exit == Exit::Ceiling) return {0, 0, -1};
    const float ex = scene.section_x[end.next_section] - scene.section_x[end.section];
    const float ey = scene.section_y[end.next_section] - scene.section_y[end.section];
    const float inverse = 1.0f / root(ex * ex + ey * ey);
    return {-ey * inverse, ex * inverse, 0};
}

/// Lambert's cosine for a lamp at the eye: one root and one division.
template <class T>
ENFILADE_HD float headlight_cosine(const accel::SceneView& scene, const Ray<T>& ray, const WalkEnd<T>& end) {
    const T d2 = dot(ray.direction, ray.direction);
    if (end.exit != Exit::Side) return static_cast<float>(magnitude(ray.direction.z) / root(d2));
    const T ex = T(scene.section_x[end.next_section]) - T(scene.section_x[end.section]);
    const T ey = T(scene.section_y[end.next_section]) - T(scene.section_y[end.section]);
    return static_cast<float>(end.facing / root((ex * ex + ey * ey) * d2));
}

ENFILADE_HD Vec3f sky_colour(const Look& look, Vec3f direction) {
    const float up = direction.z / root(dot(direction, direction));
    const float blend = up > 0 ? root(up) : 0.0f;
    return (1 - blend) * look.sky_horizon + blend * look.sky_zenith;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
