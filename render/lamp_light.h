#pragma once
// The light of lamps at a place: Lambert's cosine, the inverse square of the distance, and whether the place sees them
// (Maria, Horna, Aveneau 2013, section 5.2; README.md, "Lamps"). Included by loops, which are compiled once for each
// instruction set, and as device code.

#include "render/lamps.h"
#include "render/rooms.h"
#include "render/sees.h"

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

/// 1 / m2: nearer than a micrometre light grows no more, so that no picture holds an infinity.
inline constexpr float largest_share = 1e12f;

/// What a lamp gives to a place that sees it, by linear RGB: candela cos / m2, that is lux. way: from the lamp to the
/// place. towards: -way . normal, above 0
ENFILADE_HD Vec3f illuminance(const accel::Light& light, Vec3f way, float towards) {
    const float d2 = dot(way, way);
    float share = towards / (d2 * root(d2));
    share = share < largest_share ? share : largest_share;
    const auto* candela = reinterpret_cast<const float*>(&light.intensity);
    return {share * candela[0], share * candela[1], share * candela[2]};
}

/// The same with the normal of the place, of length 1: 0 from behind.
ENFILADE_HD Vec3f illuminance(const accel::Light& light, Vec3f way, Vec3f normal) {
    const float towards = -dot(way, normal);
    return towards > 0 ? illuminance(light, way, towards) : Vec3f{0, 0, 0};
}

template <class T>
ENFILADE_HD Vec<T> position_of(const accel::Light& light) {
    const auto* p = reinterpret_cast<const float*>(&light.position);
    return {T(p[0]), T(p[1]), T(p[2])};
}

/// What a place finds out about one lamp.
enum class LampSeen { Dark, Lit, Unclear };

/// Asks the scene's lamps on behalf of places. Nothing is allocated; one of these serves one thread.
template <class Rooms, class Events>
class LampLight {
public:
    ENFILADE_HD LampLight(const accel::SceneView& scene, const Lamps& lamps, const Rooms& rooms, Events& events)
        : scene_(scene), lamps_(lamps), rooms_(rooms), events_(events) {}

    /// Lux by linear RGB of all lamps that the place sees, by ascending lamp.
    template <class T>
    ENFILADE_HD Vec3f at(const LitPlace<T>& place) {
        Vec3f sum = {0, 0, 0};
        if (lamps_.search == LampSearch::Naive) {
            for (std::uint32_t l = 0; l < scene_.lights.count; ++l) sum = sum + of_lamp(place, l, 0, 0);
            return sum;
        }
        const accel::LightTreesView& trees = lamps_.trees;
        const std::uint32_t end = trees.cell_offsets[place.cell + 1];
        for (std::uint32_t k = trees.cell_offsets[place.cell]; k < end;) {
            const auto l = static_cast<std::uint32_t>(trees.cell_lights[k].light);
            std::uint32_t next = k + 1;
            while (next < end && static_cast<std::uint32_t>(trees.cell_lights[next].light) == l) ++next;
            sum = sum + of_lamp(place, l, k, next);
            k = next;
        }
        return sum;
    }

    /// Of one lamp. first, end: its entries in the list of the place's cell; of Naive 0 and 0.
    template <class T>
    ENFILADE_HD Vec3f of_lamp(const LitPlace<T>& place, std::uint32_t l, std::uint32_t first, std::uint32_t end) {
        events_.considered_lamp();
        const accel::Light& light = scene_.lights[l];
        const Vec3f way = vec_cast<float>(place.point - position_of<T>(light));
        const float towards = -dot(way, place.normal);
        if (!(towards > 0)) return {0, 0, 0};
        Vec3f throughput = {1, 1, 1};
        if (!is_seen(place, light, way, first, end, throughput)) return {0, 0, 0};
        events_.lit_by_lamp();
        return throughput * illuminance(light, way, towards);
    }

    /// Whether the place sees a lamp, wherever its surface looks. throughput: multiplied by what the glass between lets
    /// pass. Cost: of Pvs and Tree linear in the lamps of the place's cell.
    template <class T>
    ENFILADE_HD bool sees(const LitPlace<T>& place, std::uint32_t l, Vec3f& throughput) {
        const accel::Light& light = scene_.lights[l];
        const Vec3f way = vec_cast<float>(place.point - position_of<T>(light));
        if (lamps_.search == LampSearch::Naive) return is_seen(place, light, way, 0, 0, throughput);
        const accel::LightTreesView& trees = lamps_.trees;
        const std::uint32_t last = trees.cell_offsets[place.cell + 1];
        std::uint32_t first = trees.cell_offsets[place.cell];
        while (first < last && static_cast<std::uint32_t>(trees.cell_lights[first].light) != l) ++first;
        std::uint32_t end = first;
        while (end < last && static_cast<std::uint32_t>(trees.cell_lights[end].light) == l) ++end;
        return first != end && is_seen(place, light, way, first, end, throughput);
    }

private:
    /// throughput: multiplied by what the glass between lets pass.
    template <class T>
    ENFILADE_HD bool is_seen(const LitPlace<T>& place, const accel::Light& light, Vec3f way, std::uint32_t first,
                             std::uint32_t end, Vec3f& throughput) {
        const bool has_tree = first != end && lamps_.trees.cell_lights[first].beam != accel::no_beam;
        if (lamps_.search != LampSearch::Tree || !has_tree) return sees_by_walk(place, light, throughput);
        for (std::uint32_t k = first; k < end; ++k) {
            const std::uint32_t beam = lamps_.trees.cell_lights[k].beam;
            if (!holds(lamps_.trees, beam, way)) continue;
            if constexpr (Rooms::are_furnished) {
                const LampSeen seen = past_objects(place, light, beam);
                if (seen == LampSeen::Unclear) return sees_by_walk(place, light, throughput);
                if (seen == LampSeen::Dark) return false;
            }
            const accel::Vertex& tint = lamps_.trees.tints[lamps_.trees.beams[beam].tint];
            throughput = throughput * Vec3f{tint.x, tint.y, tint.z};
            return true;
        }
        return false;
    }

    template <class T>
    ENFILADE_HD bool sees_by_walk(const LitPlace<T>& place, const accel::Light& light, Vec3f& throughput) {
        const auto cell = static_cast<std::uint32_t>(light.cell);
        return cell != no_cell && sees_through(scene_, rooms_, place.point, position_of<T>(light), place.cell, cell,
                                               throughput, events_, static_cast<std::uint32_t>(light.carrier));
    }

    /// Whether objects stand between a lamp and a place that its beam holds: each that may, in all of its way at once.
    /// Where some of them end at a wall on this way, one that is met may be behind that wall: a walk decides.
    template <class T>
    ENFILADE_HD LampSeen past_objects(const LitPlace<T>& place, const accel::Light& light, std::uint32_t beam) {
        if (lamps_.trees.beam_object_lists.count == 0) return LampSeen::Unclear;
        const accel::ObjectsOfBeam objects = lamps_.trees.objects_of(beam);
        Segment<T> segment;
        if (objects.count == 0 || !make_segment(place.point, position_of<T>(light), no_object, segment))
            return LampSeen::Lit;
        const SlabRay slabs = scene_slabs(segment.ray);
        for (const accel::ObjectId id : objects)
            if (meets_object(scene_, rooms_.objects, segment.ray, slabs, static_cast<std::uint32_t>(id),
                             segment.part.near, segment.part.far))
                return objects.must_walk ? LampSeen::Unclear : LampSeen::Dark;
        return LampSeen::Lit;
    }

    const accel::SceneView& scene_;
    const Lamps& lamps_;
    const Rooms& rooms_;
    Events& events_;
};

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
