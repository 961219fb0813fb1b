#pragma once
// The light of lamps at a place: Lambert's cosine, the inverse square of the distance, and whether the place sees them
// (Maria, Horna, Aveneau 2013, section 5.2). Included by loops alone, which are compiled once for each instruction set.

#include "render/lamps.h"
#include "render/ray_loops.h"
#include "render/rooms.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// A place where light is gathered: on a face, or just off a triangle.
template <class T>
struct LitPlace {
    Vec<T> point;
    Vec3f normal;  ///< of length 1, on the light's side
    std::uint32_t cell;
};

/// Whether the beam holds a place that lies at `way` from its lamp.
ENFILADE_HD bool holds(const accel::LightTreesView& trees, std::uint32_t beam, Vec3f way) {
    for (const accel::BeamPlane& plane : trees.planes_of(beam))
        if (!(plane.x * way.x + plane.y * way.y + plane.z * way.z >= 0)) return false;
    return true;
}

/// What a lamp gives to a place that sees it, by linear RGB: candela cos / m2, that is lux; 0 from behind.
/// way: from the lamp to the place.
ENFILADE_HD Vec3f illuminance(const accel::Light& light, Vec3f way, Vec3f normal) {
    const float d2 = dot(way, way);
    const float towards = -dot(way, normal);
    if (!(towards > 0)) return {0, 0, 0};
    const float share = towards / (d2 * root(d2));
    return {share * light.intensity[0], share * light.intensity[1], share * light.intensity[2]};
}

template <class Rooms, class Events>
class LampLight {
public:
    LampLight(const accel::SceneView& scene, const Lamps& lamps, const Rooms& rooms, Events& events)
        : scene_(scene), lamps_(lamps), rooms_(rooms), events_(events) {}

    /// Lux by linear RGB of all lamps that the place sees.
    template <class T>
    [[nodiscard]] Vec3f at(const LitPlace<T>& place) {
        Vec3f sum = {0, 0, 0};
        if (lamps_.search == LampSearch::Naive) {
            for (std::uint32_t l = 0; l < scene_.lights.count; ++l) sum = sum + walked(place, l);
            return sum;
        }
        const accel::LightTreesView& trees = lamps_.trees;
        const std::uint32_t end = trees.cell_offsets[place.cell + 1];
        for (std::uint32_t k = trees.cell_offsets[place.cell]; k < end;) {
            const auto l = static_cast<std::uint32_t>(trees.cell_lights[k].light);
            std::uint32_t next = k;
            while (next < end && static_cast<std::uint32_t>(trees.cell_lights[next].light) == l) ++next;
            const bool has_tree = trees.cell_lights[k].beam != accel::no_beam;
            sum = sum +
                  (lamps_.search == LampSearch::Tree && has_tree ? through_beams(place, l, k, next) : walked(place, l));
            k = next;
        }
        return sum;
    }

private:
    template <class T>
    Vec3f walked(const LitPlace<T>& place, std::uint32_t l) {
        const accel::Light& light = scene_.lights[l];
        const Vec3f lamp = {light.position[0], light.position[1], light.position[2]};
        const Vec3f light_here = illuminance(light, vec_cast<float>(place.point) - lamp, place.normal);
        if (static_cast<std::uint32_t>(light.cell) == no_cell || largest_part(light_here) == 0) return {0, 0, 0};
        Vec3f throughput = {1, 1, 1};
        const bool seen = sees_through(scene_, rooms_, vec_cast<float>(place.point), lamp, place.cell,
                                       static_cast<std::uint32_t>(light.cell), throughput, events_);
        return seen ? throughput * light_here : Vec3f{0, 0, 0};
    }

    template <class T>
    Vec3f through_beams(const LitPlace<T>& place, std::uint32_t l, std::uint32_t first, std::uint32_t end) {
        const accel::Light& light = scene_.lights[l];
        const Vec3f way = vec_cast<float>(place.point) - Vec3f{light.position[0], light.position[1], light.position[2]};
        const Vec3f light_here = illuminance(light, way, place.normal);
        if (largest_part(light_here) == 0) return {0, 0, 0};
        for (std::uint32_t k = first; k < end; ++k) {
            const std::uint32_t beam = lamps_.trees.cell_lights[k].beam;
            if (!holds(lamps_.trees, beam, way)) continue;
            if constexpr (Rooms::are_furnished) return walked(place, l);
            const accel::Vertex& tint = lamps_.trees.tints[lamps_.trees.beams[beam].tint];
            return Vec3f{tint.x, tint.y, tint.z} * light_here;
        }
        return {0, 0, 0};
    }

    const accel::SceneView& scene_;
    const Lamps& lamps_;
    const Rooms& rooms_;
    Events& events_;
};

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
