#pragma once
// A pixel lit by the scene's lamps alone: of colours without mirrors, glass of furniture and textures, but for floors
// that mirror. The same numbers as those of look_pixel.h, which knows all of that. Included by loops, which are
// compiled once for each instruction set, and as device code.

#include "render/camera.h"
#include "render/lit_place.h"
#include "render/look.h"
#include "render/mirror.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// What all pixels of such a picture share.
struct LitPicture {
    const accel::SceneView* scene;
    const CameraFrame* camera;
    const Look* look;  ///< of which the sky shows
    const Lamps* lamps;
    std::uint32_t start_cell;
    float mirror_floor;  ///< share of light that floors reflect
};

/// A part of a pixel's light: that which the camera's ray brings, or its image in a floor. The ray itself is made anew
/// for each, so that nothing of it is kept while lamps are asked.
template <class T>
struct LitWay {
    std::uint32_t cell;
    T first;      ///< the parameter from which objects count
    T mirror_z;   ///< where is_mirrored
    Vec3f share;  ///< of the pixel's light
    bool is_mirrored;
};

template <class T>
ENFILADE_HD Ray<T> ray_of_way(const CameraFrame& camera, int x, int y, const LitWay<T>& way) {
    const Vec3f direction = camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const Ray<T> ray = make_ray_unchecked(vec_cast<T>(camera.origin), vec_cast<T>(direction));
    return way.is_mirrored ? mirrored(ray, way.mirror_z) : ray;
}

/// What one way shows. goes_on: whether `way` is now the way from the mirror at which it ended.
template <class T, class Rooms, class Events>
ENFILADE_HD Vec3f along_lit_way(const LitPicture& picture, const Rooms& rooms, int x, int y, LitWay<T>& way,
                                bool& goes_on, Events& events) {
    const accel::SceneView& scene = *picture.scene;
    goes_on = false;
    const Ray<T> ray = ray_of_way(*picture.camera, x, y, way);
    Vec3f tint = {1, 1, 1};
    const Sight<T> sight = rooms.look_along(scene, ray, way.cell, NoLimit{}, tint, events, way.first);
    const WalkEnd<T>& end = sight.end;
    Vec3f share = tint * way.share, colour;
    if (Rooms::are_furnished && end.status == WalkStatus::Object) {
        colour = object_colour(scene, sight.hit.object, sight.hit.triangle);
    } else {
        if (end.status != WalkStatus::Hit) return share * Vec3f{1, 0, 1};  // a leak shows
        const accel::SourceFace& face = scene.source_faces[end.target.bits];
        if (face.surface == accel::Surface::Sky)
            return share * sky_colour(*picture.look, vec_cast<float>(ray.direction));
        colour = colour_of(scene, face);
        if (picture.mirror_floor > 0 && !way.is_mirrored && is_mirror(face, end.exit)) {
            const Vec3f in_mirror = picture.mirror_floor * share;
            share = (1 - picture.mirror_floor) * share;
            goes_on = largest_part(in_mirror) >= least_share;
            way = {end.cell, parameter(scene, ray, end), T(scene.cells[end.cell].z_floor), in_mirror, true};
            if (largest_part(share) < least_share) return {0, 0, 0};
        }
    }
    return share * (lamp_light(scene, *picture.lamps, rooms, place_of<Rooms>(scene, ray, sight), events) * colour);
}

/// Linear light of the pixel x, y, counted from the upper left.
template <class T, class Rooms, class Events>
ENFILADE_HD Vec3f lit_pixel(const LitPicture& picture, const Rooms& rooms, int x, int y, Events& events) {
    LitWay<T> way = {picture.start_cell, T(0), T(0), {1, 1, 1}, false};
    Vec3f sum = {0, 0, 0};
    bool goes_on;
    do {
        sum = sum + along_lit_way(picture, rooms, x, y, way, goes_on, events);
    } while (goes_on);
    return sum;
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
