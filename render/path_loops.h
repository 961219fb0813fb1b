// The loops of path tracing: light is followed backwards from the eye, at every place the lamps and the sun are asked,
// and one ray goes on. Included by kernel_loops.h alone, once for each instruction set: no include guard is needed.

#include "render/look_loops.h"
#include "render/path_job.h"
#include "render/path_lamps.h"
#include "render/path_sampler.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// From there on a path goes on with the probability of what it still carries (Russian roulette).
inline constexpr std::uint32_t sure_bounces = 3;

ENFILADE_HD float luminance(Vec3f c) { return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z; }

/// Follows paths. Radiance is in units of the picture: what a white surface becomes in a light of pi lux is the lamps'
/// exposure, and sky and sun are the Look's.
template <class Rooms, class Events>
class PathFollower {
public:
    PathFollower(const accel::SceneView& scene, const detail::PathLight& light, const Rooms& rooms, Events& events)
        : scene_(scene), light_(light), rooms_(rooms), events_(events) {}

    /// The radiance that comes back along a ray from `cell`. spread: of its pixel, metres a unit of its parameter
    template <class T>
    [[nodiscard]] Vec3f along(const Ray<T>& ray, std::uint32_t cell, float spread, const PathSampler& sampler) {
        return followed(Going<T>{ray, cell, T(0), 0, spread, T(0)}, {1, 1, 1}, 0, sampler);
    }

    /// The radiance of a white surface at a place.
    template <class T>
    [[nodiscard]] Vec3f at(const LitPlace<T>& place, const PathSampler& sampler) {
        const Vec3f direct = lit(place, no_object, sampler, 0);
        if (light_.most_bounces == 0) return direct;
        return direct + followed(bounced(place, sampler, 0), {1, 1, 1}, 1, sampler);
    }

private:
    /// Where a path is, and how wide the beam is that it stands for: textures are blurred by that (surface.h).
    template <class T>
    struct Going {
        Ray<T> ray;
        std::uint32_t cell;
        T first;       ///< the parameter from which objects count
        float width;   ///< metres, where the ray starts to count
        float spread;  ///< by which that grows, a unit of its parameter
        T counted;     ///< the parameter where it starts to count
    };

    template <class T>
    struct Met {
        LitPlace<T> place;
        Surfacing surfacing;
        std::uint32_t object = no_object;
    };

    template <class T>
    Vec3f followed(Going<T> way, Vec3f throughput, std::uint32_t bounce, const PathSampler& sampler) {
        Vec3f sum = {0, 0, 0};
        for (;; ++bounce) {
            const Sight<T> sight =
                rooms_.look_along(scene_, way.ray, way.cell, NoLimit{}, throughput, events_, way.first);
            if (sees_sky(sight.end)) {
                const Vec3f sky = sky_colour(light_.look, vec_cast<float>(way.ray.direction));
                return sum + clamped(throughput * sky, bounce);
            }
            if (sight.end.status != WalkStatus::Hit && sight.end.status != WalkStatus::Object) return sum;
            const T t = parameter(scene_, way.ray, sight);
            way.width += way.spread * static_cast<float>(t - way.counted);
            const Met<T> met = what_is_met(way, sight);
            const Pair choice = sampler.pair(path_use(bounce, PathUse::Choice));
            way.cell = sight.end.cell;
            if (bounce < light_.most_bounces && goes_straight(met, sight, t, choice.v, way, throughput)) continue;
            throughput = throughput * met.surfacing.colour;
            if (largest_part(throughput) == 0) return sum;
            sum = sum + clamped(throughput * lit(met.place, met.object, sampler, bounce), bounce);
            if (bounce >= light_.most_bounces || !goes_on(bounce, choice.u, throughput)) return sum;
            way = bounced(met.place, sampler, bounce);
        }
    }

    /// At mirrors and glass, one of the ways on is drawn: true where it is that of a mirror or straight on, else it is
    /// the diffuse one. draw: in [0, 1)
    template <class T>
    bool goes_straight(const Met<T>& met, const Sight<T>& sight, T t, float draw, Going<T>& way,
                       Vec3f& throughput) const {
        float mirror = met.surfacing.mirror;
        const float through = largest_part(met.surfacing.through);
        float diffuse = met.surfacing.diffuse;
        if (light_.mirror_floor > 0 && is_mirror_hit(scene_, sight.end)) {
            mirror = light_.mirror_floor;
            diffuse = 1 - mirror;
        }
        if (draw < mirror) {
            reflect(met.place, sight, t, way);
            return true;
        }
        if (draw < mirror + through) {
            throughput = (1 / through) * (throughput * met.surfacing.through);
            const T step = T(0x1p-18f) * (largest_part(way.ray.origin) + largest_part(t * way.ray.direction));
            way.first = way.counted = t + (step + T(0x1p-16f)) / length(way.ray.direction);
            return true;
        }
        const float chance = 1 - mirror - through;
        throughput = (chance > 0 ? diffuse / chance : 0.0f) * throughput;
        return false;
    }

    template <class T>
    void reflect(const LitPlace<T>& place, const Sight<T>& sight, T t, Going<T>& way) const {
        if (is_mirror_hit(scene_, sight.end)) {  // keeps the ray's line on the plan
            way.ray = mirrored(way.ray, T(scene_.cells[way.cell].z_floor));
            way.first = way.counted = t;
            return;
        }
        const Vec<T> n = vec_cast<T>(place.normal);
        way.ray = make_ray_unchecked(place.point, way.ray.direction - T(2) * dot(n, way.ray.direction) * n);
        way.first = way.counted = 0;
    }

    template <class T>
    [[nodiscard]] bool sees_sky(const WalkEnd<T>& end) const {
        return end.status == WalkStatus::Hit && scene_.source_faces[end.target.bits].surface == accel::Surface::Sky;
    }

    template <class T>
    [[nodiscard]] Met<T> what_is_met(const Going<T>& way, const Sight<T>& sight) const {
        if constexpr (Rooms::are_furnished) {
            if (sight.end.status == WalkStatus::Object) {
                const Vec3f normal = facing_normal(way.ray, sight.hit);
                return {{off_object(way.ray, sight.hit, normal), normal, sight.end.cell},
                        surfacing_of_object(scene_, way.ray, sight.hit, normal, way.width),
                        sight.hit.object};
            }
        }
        const LitPlace<T> place = {end_point(scene_, way.ray, sight.end), normal_of(scene_, sight.end), sight.end.cell};
        return {place,
                surfacing_of_face(scene_, way.ray, sight.end, vec_cast<float>(place.point), place.normal, way.width)};
    }

    template <class T>
    static Going<T> bounced(const LitPlace<T>& place, const PathSampler& sampler, std::uint32_t bounce) {
        constexpr float diffuse_spread = 0.25f;  // what a bounce shows of a texture is blurred by so much of its way
        const Vec3f way = cosine_direction(place.normal, sampler.pair(path_use(bounce, PathUse::Direction)));
        return {make_ray_unchecked(place.point, vec_cast<T>(way)), place.cell, T(0), 0, diffuse_spread, T(0)};
    }

    static bool goes_on(std::uint32_t bounce, float draw, Vec3f& throughput) {
        if (bounce < sure_bounces) return true;
        const float chance = largest_part(throughput);
        if (chance >= 1) return true;
        if (!(draw < chance)) return false;
        throughput = (1 / chance) * throughput;
        return true;
    }

    /// What lamps and sun make of a white surface.
    template <class T>
    Vec3f lit(const LitPlace<T>& place, std::uint32_t object, const PathSampler& sampler, std::uint32_t bounce) {
        constexpr float inverse_pi = 0.318309886f;
        Vec3f sum = {0, 0, 0};
        if (light_.lamps != nullptr) {
            PathLamps<Rooms, Events> lamps(scene_, light_, rooms_, events_);
            sum = inverse_pi * light_.lamps->exposure * lamps.at(place, object, sampler, bounce);
        }
        return largest_part(light_.look.sun) > 0 ? sum + sunlight_of(place, sampler, bounce) : sum;
    }

    template <class T>
    Vec3f sunlight_of(const LitPlace<T>& place, const PathSampler& sampler, std::uint32_t bounce) {
        const Vec3f towards =
            cone_direction(light_.look.sun_direction, light_.sun_height, sampler.pair(path_use(bounce, PathUse::Sun)));
        const float cosine = dot(place.normal, towards);
        if (!(cosine > 0)) return {0, 0, 0};
        Vec3f throughput = {1, 1, 1};
        const Ray<T> ray = make_ray_unchecked(place.point, vec_cast<T>(towards));
        const WalkEnd<T> end =
            rooms_.look_for_any(scene_, ray, place.cell, NoLimit{}, ObjectPart{}, throughput, events_);
        return sees_sky(end) ? cosine * (throughput * light_.look.sun) : Vec3f{0, 0, 0};
    }

    [[nodiscard]] Vec3f clamped(Vec3f light, std::uint32_t bounce) const {
        if (!(light_.clamp > 0) || bounce == 0) return light;
        const float most = largest_part(light);
        return most > light_.clamp ? (light_.clamp / most) * light : light;
    }

    const accel::SceneView& scene_;
    const detail::PathLight& light_;
    const Rooms& rooms_;
    Events& events_;
};

inline void add_sample(detail::PathSum& sum, Vec3f light, std::uint32_t sample) {
    sum.rgb[0] += double{light.x};
    sum.rgb[1] += double{light.y};
    sum.rgb[2] += double{light.z};
    sum.luminance[sample % path_sequences] += double{luminance(light)};
}

/// Where a ray of the dollhouse's camera starts: where it falls through the cut. False, and a colour, where there is
/// nothing but a wall, or no building.
inline bool starts_at_cut(const detail::PathJob& job, Vec3f direction, Vec3f& origin, std::uint32_t& cell,
                          Vec3f& colour) {
    const accel::SceneView& scene = *job.scene;
    colour = job.light->look.paper;
    if (!(direction.z < 0)) return false;
    const Vec3f eye = job.camera->origin;
    const float t = (job.cut_z - eye.z) / direction.z;
    origin = {eye.x + t * direction.x, eye.y + t * direction.y, job.cut_z};
    const double where[3] = {origin.x, origin.y, origin.z};
    if (cell != no_cell && detail::cell_holds(scene, cell, where)) return true;
    cell = detail::cell_at(scene, where);
    const accel::LocatorNode& site = scene.locator_nodes[0];
    if (origin.x >= site.low[0] && origin.x <= site.high[0] && origin.y >= site.low[1] && origin.y <= site.high[1])
        colour = job.light->look.cut;
    return cell != no_cell;
}

template <class Rooms, class Events>
void path_rows(const detail::PathJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    PathFollower<Rooms, Events> follower(scene, *job.light, rooms, events);
    std::uint32_t cut_cell = no_cell;
    const float spread = length(job.camera->du);
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            detail::PathSum& sum = job.sums[static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x];
            for (std::uint32_t s = job.begin; s < job.end; ++s) {
                const PathSampler sampler(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), job.light->seed,
                                          s);
                const Pair in_pixel = sampler.pair(path_use(0, PathUse::Pixel));
                const Vec3f way =
                    job.camera->direction(static_cast<float>(x) + in_pixel.u, static_cast<float>(y) + in_pixel.v);
                Vec3f origin = job.camera->origin, colour;
                std::uint32_t cell = job.start_cell;
                if (job.is_cut) {
                    const bool starts = starts_at_cut(job, way, origin, cut_cell, colour);
                    cell = cut_cell;
                    if (!starts) {
                        add_sample(sum, colour, s);
                        continue;
                    }
                }
                add_sample(sum, follower.along(make_ray_unchecked(origin, way), cell, spread, sampler), s);
            }
        }
    }
}

template <class Rooms, class Events>
void path_each_place(const detail::PathJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    PathFollower<Rooms, Events> follower(scene, *job.light, rooms, events);
    for (std::uint32_t i = job.first_place; i < job.end_place; ++i) {
        const LitPlace<float> place = {job.points[i], job.normals[i], static_cast<std::uint32_t>(job.cells[i])};
        for (std::uint32_t s = job.begin; s < job.end; ++s) {
            const PathSampler sampler(i, 0x70617468u, job.light->seed, s);
            add_sample(job.sums[i], follower.at(place, sampler), s);
        }
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
