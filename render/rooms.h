#pragma once
// What walks meet in the loops over rays: faces alone, or what stands in rooms as well. Loops are compiled for both, so
// that scenes without objects pay nothing for them. Included by loops alone, which are compiled once for each
// instruction set (isa.h).

#include "render/object_walk.h"
#include "render/shade.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// Where a walk ended, and at what.
template <class T>
struct Sight {
    WalkEnd<T> end;
    ObjectHit<T> hit;  ///< where the status is Object
};

struct BareRooms {
    static constexpr bool are_furnished = false;

    template <class Scene, class T, class Stop, class Throughput, class Events>
    ENFILADE_HD Sight<T> look_along(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                                    Throughput& throughput, Events& events, T = T(0)) const {
        return {walk(scene, ray, cell, stop, throughput, events), {}};
    }
    /// Status Object where anything is in the way.
    template <class Scene, class T, class Stop, class Throughput, class Events>
    ENFILADE_HD WalkEnd<T> look_for_any(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                                        ObjectPart, Throughput& throughput, Events& events) const {
        return walk(scene, ray, cell, stop, throughput, events);
    }
};

/// Inside: who is asked (ask_nearest, ask_blocked).
template <class Inside>
struct RoomsWith {
    static constexpr bool are_furnished = true;
    Inside objects;

    /// first: the parameter from which objects count
    template <class Scene, class T, class Stop, class Throughput, class Events>
    ENFILADE_HD Sight<T> look_along(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                                    Throughput& throughput, Events& events, T first = T(0)) const {
        Sight<T> sight;
        sight.end = walk_furnished(scene, objects, ray, cell, stop, throughput, events, sight.hit, first);
        return sight;
    }
    template <class Scene, class T, class Stop, class Throughput, class Events>
    ENFILADE_HD WalkEnd<T> look_for_any(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                                        ObjectPart part, Throughput& throughput, Events& events) const {
        ObjectHit<T> hit;
        return walk_asking<ObjectsAsked::Any>(scene, objects, ray, cell, stop, part, throughput, events, hit);
    }
};

using FurnishedRooms = RoomsWith<ObjectTracer>;

/// Calls body(rooms) for what a job is to meet.
template <class Job, class Body>
void among(const Job& job, const Body& body) {
    if (job.objects != nullptr && job.scene->has_objects()) body(FurnishedRooms{*job.objects});
    else body(BareRooms{});
}

/// The ray's parameter where it ended.
template <class Scene, class T>
ENFILADE_HD T parameter(const Scene& scene, const Ray<T>& ray, const Sight<T>& sight) {
    return sight.end.status == WalkStatus::Object ? sight.hit.t : parameter(scene, ray, sight.end);
}

/// The unit normal of the triangle that was met, on the ray's side.
template <class T>
ENFILADE_HD Vec3f facing_normal(const Ray<T>& ray, const ObjectHit<T>& hit) {
    const Vec3f normal = normalized(hit.normal);
    return dot(normal, vec_cast<float>(ray.direction)) > 0 ? -normal : normal;
}

/// Lambert's cosine for a lamp at the eye, at a triangle of an object.
template <class T>
ENFILADE_HD float headlight_cosine(const Ray<T>& ray, const ObjectHit<T>& hit) {
    const Vec3f d = vec_cast<float>(ray.direction);
    return magnitude(dot(hit.normal, d)) / root(dot(hit.normal, hit.normal) * dot(d, d));
}

/// Where rays that go on from a triangle start: off it, on the side of `normal` (of length 1), by 16 and more of the
/// roundings that led there, so that they do not meet it again.
template <class T>
ENFILADE_HD Vec<T> off_object(const Ray<T>& ray, const ObjectHit<T>& hit, Vec3f normal) {
    const Vec<T> way = hit.t * ray.direction;
    const T offset = T(0x1p-18f) * (largest_part(ray.origin) + largest_part(way)) + T(0x1p-16f);
    return ray.origin + way + offset * vec_cast<T>(normal);
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
