#pragma once
// What a ray of a picture sees, as far as light goes on from mirrors and through glass. Included by loops, which are
// compiled once for each instruction set, and as device code.

#include "render/look_light.h"
#include "render/mirror.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// A part of a pixel's light that is still to be followed.
template <class T>
struct Way {
    Ray<T> ray;
    std::uint32_t cell;
    T first;           ///< the parameter from which objects count
    float width;       ///< of its beam where it starts to count, metres
    float spread;      ///< by which that grows, a unit of its parameter
    T counted;         ///< the parameter where it starts to count
    Vec3f share;       ///< of the pixel's light
    bool is_mirrored;  ///< somewhere before
};

/// The ways that one ray splits into at mirrors and glass. The weakest are left out where they cannot be seen, and none
/// is split any more where there are too many: there a surface shows its colour alone.
template <class T>
class Ways {
public:
    static constexpr int most_open = 8;
    static constexpr int most_walked = 48;

    [[nodiscard]] ENFILADE_HD bool may_split() const {
        return open_ + 2 <= most_open && walked_ + open_ + 2 <= most_walked;
    }
    ENFILADE_HD void add(const Way<T>& way) {
        if (largest_part(way.share) >= least_share) ways_[open_++] = way;
    }
    ENFILADE_HD bool take(Way<T>& way) {
        if (open_ == 0) return false;
        way = ways_[--open_];
        ++walked_;
        return true;
    }

private:
    Way<T> ways_[most_open];
    int open_ = 0, walked_ = 0;
};

/// In a dollhouse a ray that rises through the cut sees the sky.
template <class T>
ENFILADE_HD_FREE Limit<T> until_the_cut(const LookPicture& picture, const Ray<T>& ray) {
    const bool rises = picture.is_cut && ray.direction.z > 0;
    return Limit<T>{rises ? (T(picture.cut_z) - ray.origin.z) / ray.direction.z : T(3e38f)};
}

/// The way from a mirror: a level floor keeps the ray's line on the plan (mirror.h).
template <class T>
ENFILADE_HD_FREE Way<T> reflected(const accel::SceneView& scene, const Way<T>& way, const Sight<T>& sight,
                                  const LitPlace<T>& place, float width, Vec3f share) {
    Way<T> next = way;
    next.cell = sight.end.cell;
    next.share = share;
    next.width = width;
    next.is_mirrored = true;
    if (is_mirror_hit(scene, sight.end)) {
        next.ray = mirrored(way.ray, T(scene.cells[sight.end.cell].z_floor));
        next.first = next.counted = parameter(scene, way.ray, sight.end);
        return next;
    }
    const Vec<T> n = vec_cast<T>(place.normal);
    next.ray = make_ray_unchecked(place.point, way.ray.direction - T(2) * dot(n, way.ray.direction) * n);
    next.spread = way.spread * static_cast<float>(length(next.ray.direction) / length(way.ray.direction));
    next.first = next.counted = 0;
    return next;
}

/// Straight on, behind the triangle that was met.
template <class T>
ENFILADE_HD_FREE Way<T> straight_on(const Way<T>& way, const Sight<T>& sight, float width, Vec3f share) {
    Way<T> next = way;
    const Vec<T> met = sight.hit.t * way.ray.direction;
    const T step = T(0x1p-18f) * (largest_part(way.ray.origin) + largest_part(met)) + T(0x1p-16f);
    next.cell = sight.end.cell;
    next.first = next.counted = sight.hit.t + step / length(way.ray.direction);
    next.width = width;
    next.share = share;
    return next;
}

/// What one way shows: adds the ways that go on from there.
template <class T, class Tools>
ENFILADE_HD_FREE Vec3f along_way(const Tools& tools, const Way<T>& way, Ways<T>& ways, Sampler& sampler) {
    const accel::SceneView& scene = tools.scene;
    const Look& look = tools.look;
    Vec3f tint = {1, 1, 1};
    const Sight<T> sight =
        way.is_mirrored ? tools.rooms.look_along(scene, way.ray, way.cell, until_the_cut(tools.picture, way.ray), tint,
                                                 tools.events, way.first)
                        : tools.rooms.look_along(scene, way.ray, way.cell, NoLimit{}, tint, tools.events, way.first);
    const WalkEnd<T>& end = sight.end;
    const Vec3f share = tint * way.share;
    const bool is_sky =
        end.status == WalkStatus::Reached ||
        (end.status == WalkStatus::Hit && scene.source_faces[end.target.bits].surface == accel::Surface::Sky);
    if (is_sky) return share * sky_colour(look, vec_cast<float>(way.ray.direction));
    if (end.status != WalkStatus::Hit && end.status != WalkStatus::Object) return share * Vec3f{1, 0, 1};
    const float width = way.width + way.spread * static_cast<float>(parameter(scene, way.ray, sight) - way.counted);
    const Found<T> found = what_is_found(tools, way.ray, sight, width);
    Surfacing surfacing = found.surfacing;
    if (tools.picture.mirror_floor > 0 && !way.is_mirrored && is_mirror_hit(scene, end)) {
        surfacing.mirror = tools.picture.mirror_floor;
        surfacing.diffuse = 1 - surfacing.mirror;
    }
    const bool splits = surfacing.mirror > 0 || largest_part(surfacing.through) > 0;
    if (splits && ways.may_split()) {
        if (largest_part(surfacing.through) > 0) ways.add(straight_on(way, sight, width, surfacing.through * share));
        if (surfacing.mirror > 0) ways.add(reflected(scene, way, sight, found.place, width, surfacing.mirror * share));
    } else {
        surfacing.diffuse = 1;
    }
    const Vec3f own = surfacing.diffuse * share;
    if (splits && largest_part(own) < least_share) return {0, 0, 0};
    return own * lit_colour(tools, found.place, look.headlight * found.headlight, surfacing.colour, sampler);
}

/// spread: how much wider the pixel's beam becomes along `direction`, metres.
template <class T, class Tools>
ENFILADE_HD_FREE Vec3f radiance(const Tools& tools, Vec<T> origin, Vec3f direction, std::uint32_t cell, float width,
                                float spread, Sampler& sampler) {
    Ways<T> ways;
    const Ray<T> ray = make_ray_unchecked(origin, vec_cast<T>(direction));
    const float scale = static_cast<float>(length(ray.direction)) / length(direction);
    Way<T> way = {ray, cell, T(0), width, scale * spread, T(0), {1, 1, 1}, false};
    Vec3f sum = {0, 0, 0};
    do {
        sum = sum + along_way(tools, way, ways, sampler);
    } while (ways.take(way));
    return sum;
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
