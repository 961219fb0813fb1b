#pragma once
// Furnished rooms whose walks are functions of their own on a device. A picture's pixel walks in several places of its
// code, and each walk holds a walk through a tree: inline, they need twice the registers and many times the code. What
// a pixel holds while it walks is little, so a call costs it nothing.

#include "render/rooms.h"
#include "render/sees.h"

namespace enfilade::render::cuda {

/// OctreeTrees or MeshTrees, called.
template <class Trees>
struct CalledTrees {
    Trees trees;
};
template <class Trees>
ENFILADE_HD_COLD void ask_nearest(const CalledTrees<Trees>& called, accel::MeshId mesh, ObjectRay& ray) {
    ask_nearest(called.trees, mesh, ray);
}
template <class Trees>
ENFILADE_HD_COLD bool ask_blocked(const CalledTrees<Trees>& called, accel::MeshId mesh, const ObjectRay& ray) {
    return ask_blocked(called.trees, mesh, ray);
}

/// As RoomsWith<Trees>.
template <class Trees>
struct ApartRooms {
    static constexpr bool are_furnished = true;
    CalledTrees<Trees> objects;

    template <class T, class Stop, class Events>
    ENFILADE_HD_COLD Sight<T> look_along(const accel::SceneView& scene, Ray<T> ray, std::uint32_t cell, Stop stop,
                                         Vec3f& throughput, Events& events, T first = T(0)) const {
        return RoomsWith<Trees>{objects.trees}.look_along(scene, ray, cell, stop, throughput, events, first);
    }
    template <class T, class Stop, class Events>
    ENFILADE_HD_COLD WalkEnd<T> look_for_any(const accel::SceneView& scene, Ray<T> ray, std::uint32_t cell, Stop stop,
                                             ObjectPart part, Vec3f& throughput, Events& events) const {
        return RoomsWith<Trees>{objects.trees}.look_for_any(scene, ray, cell, stop, part, throughput, events);
    }
};

// What lamps ask, in several places of their code, too: found instead of the functions of the same names in render by
// the type of the rooms.

template <class Trees, class T, class Events>
ENFILADE_HD_COLD bool sees_through(const accel::SceneView& scene, const ApartRooms<Trees>& rooms, Vec<T> p, Vec<T> q,
                                   std::uint32_t cell, std::uint32_t to_cell, Vec3f& throughput, Events& events,
                                   std::uint32_t skipped) {
    return render::sees_through(scene, RoomsWith<Trees>{rooms.objects.trees}, p, q, cell, to_cell, throughput, events,
                                skipped);
}

template <class Trees, class T>
ENFILADE_HD_COLD bool meets_object(const accel::SceneView& scene, const CalledTrees<Trees>& inside, const Ray<T>& ray,
                                   const SlabRay& slabs, std::uint32_t id, float near, float far) {
    return render::meets_object(scene, inside.trees, ray, slabs, id, near, far);
}

}  // namespace enfilade::render::cuda
