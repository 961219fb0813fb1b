#pragma once
// The light of a place in a picture: sun, sky, lamps, darkened corners. Included by loops, which are compiled once for
// each instruction set, and as device code.

#include "render/camera.h"
#include "render/lit_place.h"
#include "render/look.h"
#include "render/sampling.h"
#include "render/shade.h"
#include "render/surface.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// What all pixels of such a picture share. Plain data.
struct LookPicture {
    const accel::SceneView* scene;
    const CameraFrame* camera;
    const Look* look;
    const Lamps* lamps;        ///< nullptr: a lamp at the eye, besides what else the look has
    std::uint32_t start_cell;  ///< unless it is cut
    int samples_a_side;        ///< their square a pixel
    bool is_cut;               ///< dollhouse: rays start where they fall through the height cut_z
    float cut_z;
    float mirror_floor;  ///< share of light that floors reflect
};

/// What all rays of a picture share.
template <class Rooms_, class Events_>
struct LookTools {
    using Rooms = Rooms_;
    using Events = Events_;
    const LookPicture& picture;
    const accel::SceneView& scene;
    const Look& look;
    const Rooms& rooms;
    Events& events;
};

/// Whether a ray that ended so sees the sky, or at least nothing within its reach.
template <class T>
ENFILADE_HD_FREE bool is_open(const accel::SceneView& scene, const Sight<T>& sight) {
    const WalkEnd<T>& end = sight.end;
    if (end.status == WalkStatus::Object)
        return scene.has_looks() && is_glass(scene, sight.hit.object, sight.hit.triangle);
    return end.status != WalkStatus::Hit || scene.source_faces[end.target.bits].surface == accel::Surface::Sky;
}

/// How much of the sky and of far walls a point sees: short rays over the hemisphere, each worth how far it gets.
template <class T, class Tools>
ENFILADE_HD_FREE float ambient_openness(const Tools& tools, const LitPlace<T>& at, Sampler& sampler) {
    const Look& look = tools.look;
    float open = 0;
    for (int i = 0; i < look.ambient_samples; ++i) {
        const Ray<T> ray = make_ray_unchecked(at.point, vec_cast<T>(sampler.next_cosine_direction(at.normal)));
        Vec3f throughput = {1, 1, 1};
        const Sight<T> sight = tools.rooms.look_along(tools.scene, ray, at.cell, Limit<T>{T(look.ambient_reach)},
                                                      throughput, tools.events);
        const float reached = is_open(tools.scene, sight)
                                  ? 1.0f
                                  : static_cast<float>(parameter(tools.scene, ray, sight) / T(look.ambient_reach));
        open += reached > 0 ? (reached < 1 ? reached * (2 - reached) : 1.0f) : 0.0f;
    }
    return look.ambient_samples > 0 ? open / static_cast<float>(look.ambient_samples) : 1.0f;
}

template <class T, class Tools>
ENFILADE_HD_FREE Vec3f sunlight(const Tools& tools, const LitPlace<T>& at) {
    const float cosine = dot(at.normal, tools.look.sun_direction);
    if (!(cosine > 0) || largest_part(tools.look.sun) == 0) return {0, 0, 0};
    Vec3f throughput = {1, 1, 1};
    const Ray<T> ray = make_ray_unchecked(at.point, vec_cast<T>(tools.look.sun_direction));
    const WalkEnd<T> end =
        tools.rooms.look_for_any(tools.scene, ray, at.cell, NoLimit{}, ObjectPart{}, throughput, tools.events);
    if (end.status != WalkStatus::Hit || tools.scene.source_faces[end.target.bits].surface != accel::Surface::Sky)
        return {0, 0, 0};
    return cosine * (throughput * tools.look.sun);
}

ENFILADE_HD float under_shoulder(float value, float shoulder) {
    const float over = value - shoulder, room = 1 - shoulder;
    return over > 0 && room > 0 ? shoulder + room * over / (over + room) : value;
}

ENFILADE_HD Vec3f under_shoulder(const Look& look, Vec3f c) {
    return {under_shoulder(c.x, look.shoulder), under_shoulder(c.y, look.shoulder), under_shoulder(c.z, look.shoulder)};
}

/// The light of a surface of that colour. headlight: what the lamp at the camera adds where there are no others.
template <class T, class Tools>
ENFILADE_HD_FREE Vec3f lit_colour(const Tools& tools, const LitPlace<T>& at, float headlight, Vec3f colour,
                                  Sampler& sampler) {
    const Vec3f near = tools.picture.lamps != nullptr
                           ? lamp_light(tools.scene, *tools.picture.lamps, tools.rooms, at, tools.events)
                           : Vec3f{headlight, headlight, headlight};
    const Vec3f light = ambient_openness(tools, at, sampler) * tools.look.ambient + sunlight(tools, at) + near;
    return under_shoulder(tools.look, light * colour);
}

/// A place that a ray found, and what light does there.
template <class T>
struct Found {
    LitPlace<T> place;
    float headlight;  ///< Lambert's cosine for a lamp at the eye
    Surfacing surfacing;
};

/// Of where a walk ended, other than in the sky. width: of the ray's beam there, metres
template <class T, class Tools>
ENFILADE_HD_FREE Found<T> what_is_found(const Tools& tools, const Ray<T>& ray, const Sight<T>& sight, float width) {
    const accel::SceneView& scene = tools.scene;
    const LitPlace<T> place = place_of<typename Tools::Rooms>(scene, ray, sight);
    if constexpr (Tools::Rooms::are_furnished) {
        if (sight.end.status == WalkStatus::Object)
            return {place, headlight_cosine(ray, sight.hit),
                    surfacing_of_object(scene, ray, sight.hit, place.normal, width)};
    }
    return {place, headlight_cosine(scene, ray, sight.end),
            surfacing_of_face(scene, ray, sight.end, vec_cast<float>(place.point), place.normal, width)};
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
