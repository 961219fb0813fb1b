#pragma once
// The walk of render/octree_walk.h in pieces, so that a schedule can run them when it suits a warp: to the next leaf,
// through its triangles, out of it. Between them a thread keeps what the next piece needs and no more: the normal and
// the like are found again, from the triangle, once the walk has ended. Header-only, for host and device.

#include <cstdint>

#include "render/cuda/octree_layouts.h"
#include "render/rope_walk.h"

namespace enfilade::render::cuda {

/// A ray as it lies in memory, 32 bytes. Directions are of any length; distances count in them.
struct alignas(16) OctreeRay {
    float origin[3], near;
    float direction[3], far;  ///< less than near: a ray that asks for nothing
};

[[nodiscard]] ENFILADE_HD ObjectRay object_ray_of(const OctreeRay& ray) {
    ObjectRay asked;
    asked.origin_x = ray.origin[0];
    asked.origin_y = ray.origin[1];
    asked.origin_z = ray.origin[2];
    asked.near = ray.near;
    asked.direction_x = ray.direction[0];
    asked.direction_y = ray.direction[1];
    asked.direction_z = ray.direction[2];
    asked.time = 0;
    asked.far = ray.far;
    asked.mask = ~0u;
    asked.id = asked.flags = 0;
    asked.normal_x = asked.normal_y = asked.normal_z = asked.u = asked.v = 0;
    asked.triangle = asked.geometry = asked.instance = no_triangle;
    return asked;
}

/// The nearest triangle, if any.
template <class Place>
struct OctreeFound {
    float t;
    std::uint32_t triangle;  ///< no_triangle: none
    Place place;
};

/// A ray on its way through the leaves.
template <class Tree>
struct OctreeTravel {
    LatticeRay r;
    ShearedRay sheared;
    LatticeCell cell;
    float near;
    float end;  ///< of the walk, in its own parameter
    LeafHead leaf;
    OctreeFound<typename Tree::Place> found;  ///< t: as the moved ray counts; what is not less far does not count
};

/// False: the ray meets nothing.
template <class Tree>
ENFILADE_HD bool begin_travel(const Tree& tree, const OctreeRay& ray, OctreeTravel<Tree>& travel) {
    if (tree.view.leaves == nullptr || !(ray.near <= ray.far)) return false;
    ObjectRay asked = object_ray_of(ray);
    bring_near(tree.view.low, tree.view.high, asked);
    travel.r = lattice_ray(tree.view, asked);
    float enter = travel.r.exponent == 0 ? asked.near : scaled(asked.near, travel.r.exponent);
    travel.end = travel.r.exponent == 0 ? asked.far : scaled(asked.far, travel.r.exponent);
    if (!part_in_box(tree.view, travel.r, enter, travel.end)) return false;
    travel.sheared = sheared_ray(asked);
    travel.cell = first_cell(tree.view, travel.r, enter);
    travel.near = asked.near;
    travel.found.t = asked.far;
    return true;
}

/// Looks up the leaf about the cell.
template <class Tree, class Events>
ENFILADE_HD void enter_leaf(const Tree& tree, OctreeTravel<Tree>& travel, Events& events) {
    const accel::JumpEntry entry = leaf_at(tree.view, travel.r, travel.cell, events);
    travel.leaf = tree.leaf(entry, travel.r.octant);
    events.entered_leaf(entry.number(), travel.leaf.count);
}

/// Goes to the cell behind the leaf; false: the walk has ended.
template <class Tree>
ENFILADE_HD bool leave_leaf(const Tree& tree, OctreeTravel<Tree>& travel) {
    const BoxExit exit = exit_by(tree.view, travel.leaf.exits, travel.leaf.width, travel.r, travel.cell);
    if (!(exit.least < travel.end)) return false;
    step(travel.r, exit, travel.cell);
    return true;
}

/// Triangle i of the leaf; true with `any` if it is met.
template <bool any, class Tree>
ENFILADE_HD bool test_triangle(const Tree& tree, std::uint32_t i, OctreeTravel<Tree>& travel) {
    const typename Tree::Place place = Tree::place(travel.leaf, i);
    std::uint32_t loaded = 0;
    const TriangleCorners corners = tree.triangle(place, loaded);
    TriangleMeeting meeting;
    if (!meets_triangle(travel.sheared, corners.at(), meeting) || !(meeting.t >= travel.near)) return false;
    if (!(meeting.t <= travel.found.t)) return false;
    const std::uint32_t number = tree.number(place, loaded);
    if (!(meeting.t < travel.found.t || number < travel.found.triangle)) return false;
    if (any) return true;
    travel.found = {meeting.t, number, place};
    const float t = travel.r.exponent == 0 ? meeting.t : scaled(meeting.t, travel.r.exponent);
    travel.end = t < travel.end ? t : travel.end;
    return false;
}

template <bool any, class Tree>
ENFILADE_HD bool test_leaf(const Tree& tree, OctreeTravel<Tree>& travel) {
    for (std::uint32_t i = 0; i < travel.leaf.count; ++i)
        if (test_triangle<any>(tree, i, travel)) return true;
    return false;
}

/// How far a walk has brought the ray near: what is found is that much farther along it. It is computed again, so that
/// no thread keeps it.
template <class Tree>
ENFILADE_HD float moved_by(const Tree& tree, const OctreeRay& ray) {
    ObjectRay asked = object_ray_of(ray);
    return bring_near(tree.view.low, tree.view.high, asked);
}
template <class T>
ENFILADE_HD float moved_by(const RopeTree<T>& /*tree*/, const OctreeRay& /*ray*/) {
    return 0;  // rope_walk counts it
}

/// Of the triangle in a place, of any length.
template <class Tree>
ENFILADE_HD Vec3f normal_of(const Tree& tree, const typename Tree::Place& place) {
    std::uint32_t number = 0;
    const TriangleCorners p = tree.triangle(place, number);
    return cross(Vec3f{p.b[0] - p.a[0], p.b[1] - p.a[1], p.b[2] - p.a[2]},
                 Vec3f{p.c[0] - p.a[0], p.c[1] - p.a[1], p.c[2] - p.a[2]});
}

/// One ray from begin to end; true with `any` once something is met. goes_through: leaves without triangles are passed
/// in a loop of their own, so that a warp's threads test triangles together. \pre travel.found.triangle is set
template <bool any, class Tree, class Events>
ENFILADE_HD bool travel_on(const Tree& tree, const OctreeRay& ray, bool goes_through, OctreeTravel<Tree>& travel,
                           Events& events) {
    bool goes_on = begin_travel(tree, ray, travel);
    while (goes_on) {
        enter_leaf(tree, travel, events);
        while (goes_through && goes_on && travel.leaf.count == 0) {
            goes_on = leave_leaf(tree, travel);
            if (goes_on) enter_leaf(tree, travel, events);
        }
        if (!goes_on) break;
        if (test_leaf<any>(tree, travel)) return true;
        goes_on = leave_leaf(tree, travel);
    }
    return false;
}

/// What octree_walk finds, to the last bit, but that t lacks moved_by.
template <bool any, class Tree, class Events>
ENFILADE_HD OctreeFound<typename Tree::Place> find_nearest(const Tree& tree, const OctreeRay& ray, bool goes_through,
                                                           Events& events) {
    OctreeTravel<Tree> travel = {};
    travel.found.triangle = no_triangle;
    if (travel_on<any>(tree, ray, goes_through, travel, events)) travel.found.triangle = 0;
    return travel.found;
}

/// As octree_walk, to the last bit and in all that it writes: for walks through rooms.
template <bool any, class Tree, class Events>
ENFILADE_HD bool walk_octree(const Tree& tree, ObjectRay& ray, Events& events) {
    const OctreeRay asked = {{ray.origin_x, ray.origin_y, ray.origin_z},
                             ray.near,
                             {ray.direction_x, ray.direction_y, ray.direction_z},
                             ray.far};
    OctreeTravel<Tree> travel = {};
    travel.found.triangle = ray.triangle;
    if (travel_on<any>(tree, asked, true, travel, events)) return true;
    if (any || travel.found.triangle == ray.triangle) return false;
    std::uint32_t number = 0;
    const TriangleCorners corners = tree.triangle(travel.found.place, number);
    TriangleMeeting meeting;
    if (meets_triangle(travel.sheared, corners.at(), meeting)) describe_meeting(corners.at(), meeting, ray);
    ray.far = travel.found.t + moved_by(tree, asked);
    ray.triangle = travel.found.triangle;
    return true;
}

/// What is found through ropes: its normal comes with it.
struct RopeFound {
    float x, y, z;
};
template <class T>
ENFILADE_HD Vec3f normal_of(const RopeTree<T>& /*tree*/, const RopeFound& normal) {
    return {normal.x, normal.y, normal.z};
}
template <bool any, class T, class Events>
ENFILADE_HD OctreeFound<RopeFound> find_nearest(const RopeTree<T>& tree, const OctreeRay& ray, bool /*goes_through*/,
                                                Events& events) {
    ObjectRay asked = object_ray_of(ray);
    const bool is_met = rope_walk<T, any>(tree.view, asked, events);
    if (any) return {asked.far, is_met ? 0u : no_triangle, {0, 0, 0}};
    return {asked.far, asked.triangle, {asked.normal_x, asked.normal_y, asked.normal_z}};
}

/// Of both kinds of walks, when nothing is asked of them.
struct NoEventsInOctree : NoOctreeEvents {
    ENFILADE_HD void recovered_exit(accel::RopeAddress /*leaf*/) {}
    ENFILADE_HD void came_back(accel::RopeAddress /*leaf*/) {}
};

}  // namespace enfilade::render::cuda
