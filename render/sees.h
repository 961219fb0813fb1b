#pragma once
// Whether one place sees another: segments of streams, and the ways from places to lamps. Included by loops, which are
// compiled once for each instruction set, and as device code.

#include "render/rooms.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// The segment from p to q as a ray, and the part of it in which objects count.
template <class T>
struct Segment {
    Ray<T> ray;
    T t;              ///< the parameter of q
    ObjectPart part;  ///< objects that touch p or q (`touch_slack`) are not between
};

/// False: the points are equal. The ray's direction is q - p rounded once and scaled by a power of two.
template <class T>
ENFILADE_HD bool make_segment(Vec<T> p, Vec<T> q, std::uint32_t skipped, Segment<T>& segment) {
    const Vec<T> way = q - p;
    if (!make_ray(p, way, segment.ray)) return false;
    segment.t = largest_part(way) / largest_part(segment.ray.direction);
    const float touch = touch_slack / static_cast<float>(length(segment.ray.direction));
    segment.part = {touch, static_cast<float>(segment.t) - touch, skipped};
    return true;
}

/// Whether nothing but glass lies between the ends of a segment from `cell` to `to_cell` (no_cell: not known): the walk
/// from p reaches q's cell, or q. throughput: multiplied by the tints of the glass between.
template <class Scene, class T, class Rooms, class Throughput, class Events>
ENFILADE_HD bool is_clear(const Scene& scene, const Rooms& rooms, const Segment<T>& segment, std::uint32_t cell,
                          std::uint32_t to_cell, Throughput& throughput, Events& events) {
    if constexpr (Rooms::are_furnished) {
        ObjectHit<T> hit;
        if (cell == to_cell)
            return !meets_objects<ObjectsAsked::Any>(scene, rooms.objects, segment.ray, scene_slabs(segment.ray), cell,
                                                     segment.part.near, segment.part.far, hit, segment.part.skipped);
    }
    return rooms
               .look_for_any(scene, segment.ray, cell, ToPoint<T>{segment.t, to_cell}, segment.part, throughput, events)
               .status == WalkStatus::Reached;
}

/// Whether nothing but glass lies between p (in `cell`) and q (in `to_cell`; no_cell: not known): the walk from p
/// reaches q's cell, or q. Objects that touch p or q (`touch_slack`) are not between, nor is the object `skipped`.
///
/// The ray's direction is q - p rounded once and scaled by a power of two, so that power is exactly the parameter of q,
/// and a floor or ceiling at q's height has exactly q's parameter: what lies on a level is seen from its cell, in
/// either direction. Where q lies on a wall and its cell is not known, rounding decides, as everywhere within
/// `error_band`. Outside that band the answer is the same for q and p exchanged. Points that are none (NaN, infinite)
/// see nothing, not even themselves.
///
/// throughput: multiplied by the tints of the glass between.
template <class Scene, class T, class Rooms, class Throughput, class Events>
ENFILADE_HD bool sees_through(const Scene& scene, const Rooms& rooms, Vec<T> p, Vec<T> q, std::uint32_t cell,
                              std::uint32_t to_cell, Throughput& throughput, Events& events,
                              std::uint32_t skipped = no_object) {
    if (!is_place(vec_cast<float>(p)) || !is_place(vec_cast<float>(q))) return false;
    if (cell == to_cell && !Rooms::are_furnished) return true;
    Segment<T> segment;
    if (!make_segment(p, q, skipped, segment)) return true;
    return is_clear(scene, rooms, segment, cell, to_cell, throughput, events);
}

template <class Scene, class Rooms, class Events>
ENFILADE_HD bool sees(const Scene& scene, const Rooms& rooms, Vec3f p, Vec3f q, std::uint32_t cell,
                      std::uint32_t to_cell, Events& events) {
    NoThroughput throughput;
    return sees_through(scene, rooms, p, q, cell, to_cell, throughput, events);
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
