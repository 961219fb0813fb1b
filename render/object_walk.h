#pragma once
// How a walk meets what stands in rooms: in each cell that lists objects, between entry and exit, the ray is taken into
// the space of each of them, and whoever knows its triangles is asked (object_tracer.h). Header-only, for host and
// device (README.md, "Objects").

#include <cstdint>

#include "accel/scene.h"
#include "render/bvh_walk.h"
#include "render/isa.h"
#include "render/object_tracer.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// A ray's way through a cell is made longer by that much of its parameter and by as many of its units (0.05 to 0.1
/// mm), at both ends: what lies at the border of two cells is found from one of them, and what lies in the plane of a
/// wall is seen before the wall.
inline constexpr float stretch_slack = 1e-4f;

/// Objects that touch an end of a segment are not in its way: metres.
inline constexpr float touch_slack = 2e-4f;

inline constexpr std::uint32_t no_object = 0xffffffffu;

/// The triangle that stops a ray.
template <class T>
struct ObjectHit {
    std::uint32_t object = no_object;
    std::uint32_t triangle = no_triangle;
    T t = 0;                   ///< in units of the ray's (scaled) direction
    Vec3f normal = {0, 0, 0};  ///< in the scene, of any length, on the side of its own: (b - a) x (c - a)
};

// Who is asked: function pointers, or on a device the trees themselves.
ENFILADE_HD void ask_nearest(const ObjectTracer& tracer, accel::MeshId mesh, ObjectRay& ray) {
    tracer.nearest(tracer.state, mesh, ray);
}
ENFILADE_HD bool ask_blocked(const ObjectTracer& tracer, accel::MeshId mesh, const ObjectRay& ray) {
    return tracer.blocked(tracer.state, mesh, ray);
}

/// A tree for each mesh of the scene.
struct MeshTrees {
    const BvhView* of_mesh;
};
ENFILADE_HD void ask_nearest(const MeshTrees& trees, accel::MeshId mesh, ObjectRay& ray) {
    bvh_walk<false>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], ray);
}
ENFILADE_HD bool ask_blocked(const MeshTrees& trees, accel::MeshId mesh, const ObjectRay& ray) {
    ObjectRay asked = ray;
    return bvh_walk<true>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], asked);
}

template <class T>
ENFILADE_HD Vec<T> turned(const accel::Placement& placement, Vec<T> d) {
    const auto& m = placement.rows;
    return {T(m[0]) * d.x + T(m[1]) * d.y + T(m[2]) * d.z, T(m[4]) * d.x + T(m[5]) * d.y + T(m[6]) * d.z,
            T(m[8]) * d.x + T(m[9]) * d.y + T(m[10]) * d.z};
}

/// The ray in the object's space, for its part [near, far]. The parameter stays what it is. The way from the object to
/// the origin is what is turned, so that errors are relative to it, not to coordinates of the scene.
template <class T>
ENFILADE_HD ObjectRay to_object(const accel::PlacedObject& object, const Ray<T>& ray, float near, float far) {
    const auto& at = object.scene_from_object.rows;
    const Vec<T> o = turned(object.object_from_scene,
                            Vec<T>{ray.origin.x - T(at[3]), ray.origin.y - T(at[7]), ray.origin.z - T(at[11])});
    const Vec<T> d = turned(object.object_from_scene, ray.direction);
    ObjectRay asked;
    asked.origin_x = static_cast<float>(o.x);
    asked.origin_y = static_cast<float>(o.y);
    asked.origin_z = static_cast<float>(o.z);
    asked.near = near;
    asked.direction_x = static_cast<float>(d.x);
    asked.direction_y = static_cast<float>(d.y);
    asked.direction_z = static_cast<float>(d.z);
    asked.time = 0;
    asked.far = far;
    asked.mask = ~0u;
    asked.id = asked.flags = 0;
    asked.triangle = asked.geometry = asked.instance = no_triangle;
    return asked;
}

/// What slabs of boxes are tested with.
struct SlabRay {
    Vec3f origin_low;   ///< what low planes are measured from
    Vec3f origin_high;  ///< and high planes
    Vec3f inverse;      ///< of the direction; of 2^-100 where it is less than that
};

/// slack: by that much boxes are wider on all sides
ENFILADE_HD SlabRay slab_ray(Vec3f o, Vec3f d, float slack) {
    constexpr float least = 0x1p-100f;
    return {{o.x + slack, o.y + slack, o.z + slack},
            {o.x - slack, o.y - slack, o.z - slack},
            {1.0f / (magnitude(d.x) >= least ? d.x : least), 1.0f / (magnitude(d.y) >= least ? d.y : least),
             1.0f / (magnitude(d.z) >= least ? d.z : least)}};
}

ENFILADE_HD void cut_by_slab(float low, float high, float inverse, float& enter, float& leave) {
    const float a = low * inverse, b = high * inverse;
    const float first = a < b ? a : b, second = a < b ? b : a;
    enter = first > enter ? first : enter;
    leave = second < leave ? second : leave;
}

/// Whether the ray may come through the box in its part [near, far]; rather yes than no: parameters may be wrong by
/// a few roundings.
ENFILADE_HD bool may_meet_box(const SlabRay& ray, const float* low, const float* high, float near, float far) {
    float enter = near, leave = far;
    cut_by_slab(low[0] - ray.origin_low.x, high[0] - ray.origin_high.x, ray.inverse.x, enter, leave);
    cut_by_slab(low[1] - ray.origin_low.y, high[1] - ray.origin_high.y, ray.inverse.y, enter, leave);
    cut_by_slab(low[2] - ray.origin_low.z, high[2] - ray.origin_high.z, ray.inverse.z, enter, leave);
    return enter <= leave + 0x1p-20f * leave;
}

/// For the boxes of objects in the scene, which are wider than the objects: by more than the roundings of the origin.
template <class T>
ENFILADE_HD SlabRay scene_slabs(const Ray<T>& ray) {
    const Vec3f o = vec_cast<float>(ray.origin);
    return slab_ray(o, vec_cast<float>(ray.direction), 0x1p-21f * largest_part(o));
}

/// Whether the ray may meet the mesh's box, widened by more than the roundings of to_object.
ENFILADE_HD bool may_meet(const accel::ObjectMesh& mesh, const ObjectRay& ray) {
    const float *low = reinterpret_cast<const float*>(&mesh.low), *high = reinterpret_cast<const float*>(&mesh.high);
    const Vec3f o = {ray.origin_x, ray.origin_y, ray.origin_z};
    const float farthest = larger(larger(larger(magnitude(low[0] - o.x), magnitude(high[0] - o.x)),
                                         larger(magnitude(low[1] - o.y), magnitude(high[1] - o.y))),
                                  larger(magnitude(low[2] - o.z), magnitude(high[2] - o.z)));
    const SlabRay slabs = slab_ray(o, Vec3f{ray.direction_x, ray.direction_y, ray.direction_z}, 0x1p-20f * farthest);
    return may_meet_box(slabs, low, high, ray.near, ray.far);
}

/// The normal in the scene of one in the object's space.
ENFILADE_HD Vec3f scene_normal(const accel::PlacedObject& object, const ObjectRay& met) {
    const auto& m = object.object_from_scene.rows;
    return {m[0] * met.normal_x + m[4] * met.normal_y + m[8] * met.normal_z,
            m[1] * met.normal_x + m[5] * met.normal_y + m[9] * met.normal_z,
            m[2] * met.normal_x + m[6] * met.normal_y + m[10] * met.normal_z};
}

/// What an object is made of at one of its triangles.
ENFILADE_HD std::uint32_t object_material(const accel::SceneView& scene, std::uint32_t object, std::uint32_t triangle) {
    const accel::PlacedObject& placed = scene.objects[object];
    const accel::ObjectMesh& mesh = scene.meshes[static_cast<std::uint32_t>(placed.mesh)];
    const accel::MaterialId of_object = placed.material;
    return static_cast<std::uint32_t>(static_cast<std::uint32_t>(of_object) != 0xffffffffu
                                          ? of_object
                                          : scene.mesh_triangles[mesh.first_triangle + triangle].material);
}

/// What an object shows at one of its triangles: its plain colour.
ENFILADE_HD Vec3f object_colour(const accel::SceneView& scene, std::uint32_t object, std::uint32_t triangle) {
    const auto* c = reinterpret_cast<const float*>(&scene.materials[object_material(scene, object, triangle)]);
    return {c[0], c[1], c[2]};
}

/// Whether light goes through a triangle of an object, tinted or not. \pre scene.has_looks()
ENFILADE_HD bool is_glass(const accel::SceneView& scene, std::uint32_t object, std::uint32_t triangle) {
    const accel::MaterialLook& look = scene.material_looks[object_material(scene, object, triangle)];
    const auto* through = reinterpret_cast<const float*>(&look.through);
    return through[0] + through[1] + through[2] > 0;
}

/// Whether all triangles of the object that lie in the ray's part are glass: sixteen of them, else they block. `asked`
/// is a ray in the object's space.
template <class Inside>
ENFILADE_HD_COLD bool is_only_glass(const accel::SceneView& scene, const Inside& inside, std::uint32_t object,
                                    ObjectRay asked) {
    constexpr int most_panes = 16;
    const float far = asked.far;
    for (int pane = 0; pane < most_panes; ++pane) {
        ask_nearest(inside, scene.objects[object].mesh, asked);
        if (asked.triangle == no_triangle) return true;
        if (!is_glass(scene, object, asked.triangle)) return false;
        asked.near = asked.far * (1 + 0x1p-20f) + 1e-30f;
        if (!(asked.near < far)) return true;
        asked.far = far;
        asked.triangle = no_triangle;
    }
    return false;
}

/// Nearest: which triangle stops the ray. Any: whether one does, which costs less.
enum class ObjectsAsked { Nearest, Any };

/// The ray in the object's space, for its part [near, far]; false where boxes tell that it does not meet the object.
/// slabs: scene_slabs of the ray
template <class T>
ENFILADE_HD bool comes_near(const accel::SceneView& scene, const accel::PlacedObject& object, const Ray<T>& ray,
                            const SlabRay& slabs, float near, float far, ObjectRay& asked) {
    if (!may_meet_box(slabs, reinterpret_cast<const float*>(&object.low), reinterpret_cast<const float*>(&object.high),
                      near, far))
        return false;
    asked = to_object(object, ray, near, far);
    return may_meet(scene.meshes[static_cast<std::uint32_t>(object.mesh)], asked);
}

/// Whether an object has a triangle in the ray's part [near, far] that is no glass.
template <class Inside, class T>
ENFILADE_HD bool meets_object(const accel::SceneView& scene, const Inside& inside, const Ray<T>& ray,
                              const SlabRay& slabs, std::uint32_t id, float near, float far) {
    const accel::PlacedObject& object = scene.objects[id];
    ObjectRay asked;
    return comes_near(scene, object, ray, slabs, near, far, asked) && ask_blocked(inside, object.mesh, asked) &&
           !(scene.has_looks() && is_only_glass(scene, inside, id, asked));
}

/// The objects of a cell: places in `cell_objects`.
struct ObjectList {
    std::uint32_t first, end;
};
ENFILADE_HD ObjectList objects_of(const accel::SceneView& scene, std::uint32_t cell) {
    return {scene.cell_object_offsets[cell], scene.cell_object_offsets[cell + 1]};
}

/// Asks the objects of a cell, by ascending id, for the nearest triangle of the ray's part [near, far]; of equally near
/// ones that of the first object stands. skipped: an object that is not asked, or no_object
template <ObjectsAsked asked_for, class Scene, class Inside, class T>
ENFILADE_HD bool meets_objects(const Scene& scene, const Inside& inside, const Ray<T>& ray, const SlabRay& slabs,
                               std::uint32_t cell, float near, float far, ObjectHit<T>& hit,
                               std::uint32_t skipped = no_object) {
    bool is_hit = false;
    const ObjectList list = objects_of(scene, cell);
    for (std::uint32_t k = list.first; k < list.end; ++k) {
        const auto id = static_cast<std::uint32_t>(scene.cell_objects[k]);
        if (id == skipped) continue;
        if constexpr (asked_for == ObjectsAsked::Any) {
            if (!meets_object(scene, inside, ray, slabs, id, near, far)) continue;
            hit.object = id;
            return true;
        } else {
            const accel::PlacedObject& object = scene.objects[id];
            ObjectRay asked;
            if (!comes_near(scene, object, ray, slabs, near, far, asked)) continue;
            ask_nearest(inside, object.mesh, asked);
            if (asked.triangle == no_triangle || (is_hit && !(asked.far < far))) continue;
            is_hit = true;
            far = asked.far;
            hit = {id, asked.triangle, T(asked.far), scene_normal(object, asked)};
        }
    }
    return is_hit;
}

template <class Scene>
ENFILADE_HD bool has_objects(const Scene& scene, std::uint32_t cell) {
    const ObjectList list = objects_of(scene, cell);
    return list.first != list.end;
}

ENFILADE_HD float stretch_start(float t, float first) {
    const float widened = t - (stretch_slack + stretch_slack * t);
    return widened > first ? widened : first;
}
ENFILADE_HD float stretch_end(float t, float last) {
    const float widened = t + (stretch_slack + stretch_slack * t);
    return widened < last ? widened : last;
}

/// The part of a ray in which objects count. `near` is also where it is known to be in its first cell.
struct ObjectPart {
    float near = 0;
    float far = 3e38f;
    std::uint32_t skipped = no_object;  ///< one object that does not: a lamp throws no shadow of its own light
};

/// That of a walk which stops there.
ENFILADE_HD float objects_until(NoLimit) { return 3e38f; }
template <class T>
ENFILADE_HD float objects_until(const Limit<T>& stop) {
    return static_cast<float>(stop.t);
}
template <class T>
ENFILADE_HD float objects_until(const ToPoint<T>& stop) {
    return static_cast<float>(stop.t);
}

/// As walk_in, in furnished rooms: status Object and `hit` where a triangle stops the ray.
template <ObjectsAsked asked_for, class Scene, class Inside, class T, class Stop, class Throughput, class Events>
ENFILADE_HD WalkEnd<T> walk_furnished_in(const Scene& scene, const Inside& inside, const Ray<T>& ray,
                                         std::uint32_t cell, const Stop& stop, ObjectPart part, Throughput& throughput,
                                         Events& events, ObjectHit<T>& hit) {
    WalkEnd<T> end;
    events.began_walk();
    const SlabRay slabs = scene_slabs(ray);
    std::uint32_t entry = no_section, entry_next = no_section;
    const std::uint32_t turn_back = most_steps(scene);
    for (std::uint32_t steps = 2 * turn_back; steps > 0; --steps) {
        const bool is_first = steps == 2 * turn_back;
        const bool is_furnished = has_objects(scene, cell);
        // Until the next exit is found, `end` is that by which the ray came here.
        const float from = !is_furnished ? 0.0f
                           : is_first    ? part.near
                                         : stretch_start(static_cast<float>(parameter(scene, ray, end)), part.near);
        const bool is_last = !is_first && stop.ends_in(cell);
        if (is_last) {
            end.cell = cell;
            end.status = WalkStatus::Reached;
        } else {
            events.entered_cell(walked_cell(scene, cell).section_count);
            leave_cell(scene, ray, cell, entry, entry_next, steps > turn_back, stop, events, end);
        }
        if (is_furnished) {
            const float to = is_last ? part.far : stretch_end(static_cast<float>(parameter(scene, ray, end)), part.far);
            if (meets_objects<asked_for>(scene, inside, ray, slabs, cell, from, to, hit, part.skipped)) {
                end.status = WalkStatus::Object;
                return end;
            }
        }
        if (end.status == WalkStatus::Reached || !end.target.is_portal()) return end;
        if (end.target.is_glass()) {
            tint_by_glass(scene, cell, end.exit, end.face, throughput);
            events.crossed_glass();
        }
        entry = end.exit == Exit::Side ? end.section : no_section;
        entry_next = end.next_section;
        cell = static_cast<std::uint32_t>(end.target.neighbour());
        events.crossed(cell);
    }
    end.status = WalkStatus::Leak;
    events.leaked();
    return end;
}

template <ObjectsAsked asked_for, class Inside, class Stop, class Throughput, class Events>
ENFILADE_HD_COLD WalkEnd<float> walk_furnished_in_double(const accel::SceneView& scene, const Inside& inside,
                                                         Ray<float> ray, std::uint32_t cell, const Stop& stop,
                                                         ObjectPart part, Throughput& throughput, Events& events,
                                                         ObjectHit<float>& hit) {
    const Ray<double> exact = make_ray_unchecked(vec_cast<double>(ray.origin), vec_cast<double>(ray.direction));
    ObjectHit<double> met;
    const WalkEnd<double> end =
        walk_furnished_in<asked_for>(scene, inside, exact, cell, in_double(stop), part, throughput, events, met);
    hit = {met.object, met.triangle, static_cast<float>(met.t), met.normal};
    return in_float(end);
}

/// Follows the ray as `walk` does, with its double fallback. `hit` is written where the status is Object; asked for
/// any, its object alone.
template <ObjectsAsked asked_for, class Scene, class Inside, class T, class Stop, class Throughput, class Events>
ENFILADE_HD WalkEnd<T> walk_asking(const Scene& scene, const Inside& inside, const Ray<T>& ray, std::uint32_t cell,
                                   const Stop& stop, ObjectPart part, Throughput& throughput, Events& events,
                                   ObjectHit<T>& hit) {
    const Throughput before = throughput;
    const WalkEnd<T> end = walk_furnished_in<asked_for>(scene, inside, ray, cell, stop, part, throughput, events, hit);
    if constexpr (sizeof(T) == sizeof(float)) {
        if (ends_behind(ray, end)) [[unlikely]] {
            throughput = before;
            return walk_furnished_in_double<asked_for>(scene, inside, ray, cell, stop, part, throughput, events, hit);
        }
    }
    return end;
}

/// The nearest face or triangle; glass lets the ray pass. first: the parameter from which objects count, for rays that
/// begin before (mirror.h).
template <class Scene, class Inside, class T, class Stop, class Throughput, class Events>
ENFILADE_HD WalkEnd<T> walk_furnished(const Scene& scene, const Inside& inside, const Ray<T>& ray, std::uint32_t cell,
                                      const Stop& stop, Throughput& throughput, Events& events, ObjectHit<T>& hit,
                                      T first = T(0)) {
    const ObjectPart part = {static_cast<float>(first), objects_until(stop)};
    return walk_asking<ObjectsAsked::Nearest>(scene, inside, ray, cell, stop, part, throughput, events, hit);
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
