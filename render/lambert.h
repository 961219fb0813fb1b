#pragma once
// A pixel lit by a lamp at the eye. Included by loops, which are compiled once for each instruction set, and as device
// code.

#include "render/camera.h"
#include "render/look.h"
#include "render/mirror.h"
#include "render/rooms.h"
#include "render/shade.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// What all pixels of such a picture share.
struct LambertPicture {
    const accel::SceneView* scene;
    const CameraFrame* camera;
    const Look* look;
    std::uint32_t start_cell;
    float mirror_floor;  ///< share of light that floors reflect
};

/// What a lamp at the eye shows of where a walk ended; throughput not yet counted.
template <class Rooms, class T>
ENFILADE_HD Vec3f lambert_colour(const accel::SceneView& scene, const Look& look, const Ray<T>& ray,
                                 const Sight<T>& sight) {
    const WalkEnd<T>& end = sight.end;
    if constexpr (Rooms::are_furnished) {
        if (end.status == WalkStatus::Object)
            return headlight_cosine(ray, sight.hit) * object_colour(scene, sight.hit.object, sight.hit.triangle);
    }
    if (end.status != WalkStatus::Hit) return {1, 0, 1};  // a leak shows
    const accel::SourceFace& face = scene.source_faces[end.target.bits];
    return face.surface == accel::Surface::Sky ? sky_colour(look, vec_cast<float>(ray.direction))
                                               : headlight_cosine(scene, ray, end) * colour_of(scene, face);
}

/// What the mirror at which `ray` ended shows: the eye and its lamp have their images below it.
template <class Rooms, class T, class Events>
ENFILADE_HD Vec3f lambert_in_mirror(const LambertPicture& picture, const Rooms& rooms, const Ray<T>& ray,
                                    const WalkEnd<T>& end, Vec3f own, Events& events) {
    const accel::SceneView& scene = *picture.scene;
    const Ray<T> image = mirrored(ray, T(scene.cells[end.cell].z_floor));
    Vec3f throughput = {1, 1, 1};
    const Sight<T> seen =
        rooms.look_along(scene, image, end.cell, NoLimit{}, throughput, events, parameter(scene, ray, end));
    return in_mirror(picture.mirror_floor, own, throughput * lambert_colour<Rooms>(scene, *picture.look, image, seen));
}

/// Linear light of the pixel x, y, counted from the upper left.
template <class T, class Rooms, class Events>
ENFILADE_HD Vec3f lambert_pixel(const LambertPicture& picture, const Rooms& rooms, int x, int y, Events& events) {
    const accel::SceneView& scene = *picture.scene;
    const CameraFrame& camera = *picture.camera;
    const Vec3f direction = camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const Ray<T> ray = make_ray_unchecked(vec_cast<T>(camera.origin), vec_cast<T>(direction));
    Vec3f throughput = {1, 1, 1};
    const Sight<T> sight = rooms.look_along(scene, ray, picture.start_cell, NoLimit{}, throughput, events);
    Vec3f colour = lambert_colour<Rooms>(scene, *picture.look, ray, sight);
    if (picture.mirror_floor > 0 && is_mirror_hit(scene, sight.end))
        colour = lambert_in_mirror(picture, rooms, ray, sight.end, colour, events);
    return throughput * colour;
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
