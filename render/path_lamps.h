#pragma once
// Direct light of lamps for paths: of points by their light trees, of balls by walks to places drawn on them; of all
// lamps that a cell may see, or of a few drawn by what they would give if nothing stood between. Included by loops
// alone, which are compiled once for each instruction set.

#include "render/lamp_light.h"
#include "render/path_job.h"
#include "render/path_sampler.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// The most lux by linear RGB that a lamp gives a place: what a point gives, and for a ball what no part of it exceeds.
ENFILADE_HD Vec3f most_illuminance(const accel::Light& light, Vec3f way, Vec3f normal) {
    if (!(light.radius > 0)) return illuminance(light, way, normal);
    const float d = root(dot(way, way));
    const float near = larger(d, light.radius);
    const float cosine = (light.radius - dot(way, normal)) / near;  // of the ball's point highest above the surface
    if (!(cosine > 0)) return {0, 0, 0};
    const float share = 2 * (cosine < 1 ? cosine : 1.0f) / (near * near);
    return {share * light.intensity[0], share * light.intensity[1], share * light.intensity[2]};
}

template <class Rooms, class Events>
class PathLamps {
public:
    PathLamps(const accel::SceneView& scene, const detail::PathLight& light, const Rooms& rooms, Events& events)
        : scene_(scene), light_(light), lamps_(*light.lamps), rooms_(rooms), events_(events) {}

    /// Lux by linear RGB at the place, unbiased. bounce: how many lie before it on the path. object: on which the place
    /// lies, or no_object. A lamp's light goes through what carries it, so that sends none of it on: it only shows it.
    template <class T>
    [[nodiscard]] Vec3f at(const LitPlace<T>& place, std::uint32_t object, const PathSampler& sampler,
                           std::uint32_t bounce) {
        dark_carrier_ = bounce > 0 ? object : no_object;
        if (light_.lamps_a_bounce > 0) return of_some(place, sampler, bounce);
        Vec3f sum = {0, 0, 0};
        for (std::uint32_t k = first(place.cell), end = last(place.cell); k < end;) {
            const std::uint32_t next = next_lamp(k, end);
            sum = sum + of_one(place, k, next, sampler, bounce);
            k = next;
        }
        return sum;
    }

private:
    // Entries of a cell's list, of which several in a row may be of one lamp; without lists all lamps of the scene.
    [[nodiscard]] bool is_naive() const { return lamps_.search == LampSearch::Naive; }
    [[nodiscard]] std::uint32_t first(std::uint32_t cell) const {
        return is_naive() ? 0 : lamps_.trees.cell_offsets[cell];
    }
    [[nodiscard]] std::uint32_t last(std::uint32_t cell) const {
        return is_naive() ? static_cast<std::uint32_t>(scene_.lights.count) : lamps_.trees.cell_offsets[cell + 1];
    }
    [[nodiscard]] std::uint32_t lamp_of(std::uint32_t k) const {
        return is_naive() ? k : static_cast<std::uint32_t>(lamps_.trees.cell_lights[k].light);
    }
    [[nodiscard]] std::uint32_t next_lamp(std::uint32_t k, std::uint32_t end) const {
        const std::uint32_t lamp = lamp_of(k);
        do ++k;
        while (k < end && lamp_of(k) == lamp);
        return k;
    }

    [[nodiscard]] bool shines(const accel::Light& light) const {
        return static_cast<std::uint32_t>(light.cell) != no_cell &&
               (dark_carrier_ == no_object || static_cast<std::uint32_t>(light.carrier) != dark_carrier_);
    }

    template <class T>
    [[nodiscard]] static Vec3f way_from(const accel::Light& light, const LitPlace<T>& place) {
        return vec_cast<float>(place.point) - Vec3f{light.position[0], light.position[1], light.position[2]};
    }

    template <class T>
    [[nodiscard]] float weight(const LitPlace<T>& place, std::uint32_t k) const {
        const accel::Light& light = scene_.lights[lamp_of(k)];
        if (!shines(light)) return 0;
        const Vec3f most = most_illuminance(light, way_from(light, place), place.normal);
        return most.x + most.y + most.z;
    }

    /// Some lamps, drawn with the probability of their weight from equally long stretches of the sum of all weights.
    template <class T>
    Vec3f of_some(const LitPlace<T>& place, const PathSampler& sampler, std::uint32_t bounce) {
        const std::uint32_t begin = first(place.cell), end = last(place.cell);
        float all = 0;
        for (std::uint32_t k = begin; k < end; k = next_lamp(k, end)) all += weight(place, k);
        Vec3f sum = {0, 0, 0};
        if (!(all > 0)) return sum;
        const auto count = static_cast<float>(light_.lamps_a_bounce);
        float next_draw = sampler.pair(path_use(bounce, PathUse::Lamp)).u * (all / count), before = 0;
        std::uint32_t drawn = 0;
        for (std::uint32_t k = begin; k < end && drawn < light_.lamps_a_bounce;) {
            const std::uint32_t next = next_lamp(k, end);
            const float own = weight(place, k);
            std::uint32_t times = 0;
            for (; drawn < light_.lamps_a_bounce && next_draw < before + own; next_draw += all / count) {
                ++drawn;
                ++times;
            }
            before += own;
            if (times > 0)
                sum = sum + (static_cast<float>(times) * all / (count * own)) * of_one(place, k, next, sampler, bounce);
            k = next;
        }
        return sum;
    }

    template <class T>
    Vec3f of_one(const LitPlace<T>& place, std::uint32_t k, std::uint32_t end, const PathSampler& sampler,
                 std::uint32_t bounce) {
        const std::uint32_t lamp = lamp_of(k);
        const accel::Light& light = scene_.lights[lamp];
        if (!shines(light)) return {0, 0, 0};
        const Vec3f way = way_from(light, place);
        if (light.radius > 0) return of_ball(place, lamp, way, sampler.pair(path_use_of_lamp(bounce, lamp)));
        LampLight<Rooms, Events> points(scene_, lamps_, rooms_, events_);
        return is_naive() ? points.of_lamp(place, lamp, 0, 0) : points.of_lamp(place, lamp, k, end);
    }

    /// A ball of even radiance: a place on it, drawn evenly from the cone in which it is seen.
    template <class T>
    Vec3f of_ball(const LitPlace<T>& place, std::uint32_t lamp, Vec3f way, Pair drawn) {
        const accel::Light& light = scene_.lights[lamp];
        const Vec3f point = vec_cast<float>(place.point);
        const float r2 = light.radius * light.radius, d2 = dot(way, way);
        if (!(d2 > r2)) {  // inside: as on its surface, from its centre
            const float towards = -dot(way, place.normal);
            if (!(towards > 0)) return {0, 0, 0};
            const float share = towards / (root(d2) * r2);
            return walked(place, light, point - way, static_cast<std::uint32_t>(light.cell),
                          {share * light.intensity[0], share * light.intensity[1], share * light.intensity[2]});
        }
        const float d = root(d2), flat = root(1 - r2 / d2);
        const Vec3f towards = cone_direction((-1 / d) * way, r2 / d2 / (1 + flat), drawn);
        const float cosine = dot(towards, place.normal);
        if (!(cosine > 0)) return {0, 0, 0};
        const float share = 2 * cosine / (d2 * (1 + flat));  // radiance I / (pi r2), solid angle 2 pi (1 - flat)
        const float along = -dot(way, towards), depth2 = r2 - (d2 - along * along);
        const float far = along - root(depth2 > 0 ? depth2 : 0.0f);
        return walked(place, light, point + far * towards, light_.ball_cells[lamp],
                      {share * light.intensity[0], share * light.intensity[1], share * light.intensity[2]});
    }

    /// `here` as far as it gets from `to` on the ball, which lies in `to_cell` (no_cell: not known).
    template <class T>
    Vec3f walked(const LitPlace<T>& place, const accel::Light& light, Vec3f to, std::uint32_t to_cell, Vec3f here) {
        Vec3f throughput = {1, 1, 1};
        const bool seen = sees_through(scene_, rooms_, place.point, vec_cast<T>(to), place.cell, to_cell, throughput,
                                       events_, static_cast<std::uint32_t>(light.carrier));
        return seen ? throughput * here : Vec3f{0, 0, 0};
    }

    const accel::SceneView& scene_;
    const detail::PathLight& light_;
    const Lamps& lamps_;
    const Rooms& rooms_;
    Events& events_;
    std::uint32_t dark_carrier_ = no_object;  ///< none of whose lamps shine
};

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
