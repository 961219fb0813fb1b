#pragma once
// How a ray walks through the leaves of a mesh's octree: out of one by the face by which it leaves its box, into the
// one behind. One ray at a time; header-only, for host and device. Everything is counted in the octree's lattice, where
// boxes are whole numbers; the parameter stays the ray's own.

#include <cstdint>

#include "accel/octree/linked_octree.h"
#include "render/isa.h"
#include "render/math.h"
#include "render/near_ray.h"
#include "render/triangle_test.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// What a walk may be asked to tell: how much it does.
struct NoOctreeEvents {
    ENFILADE_HD void entered_leaf(std::uint32_t /*leaf*/, std::uint32_t /*triangles*/) {}
    ENFILADE_HD void descended(std::uint32_t /*levels*/) {}
};

/// A ray in the lattice.
struct LatticeRay {
    float origin[3];
    float direction[3];
    float inverse[3];  ///< of the direction; 0 where it is as good as 0: by those faces nothing is left
};

ENFILADE_HD LatticeRay lattice_ray(const accel::OctreeFrame& frame, const ObjectRay& ray) {
    const float o[3] = {ray.origin_x, ray.origin_y, ray.origin_z};
    const float d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    LatticeRay r;
    for (int k = 0; k < 3; ++k) {
        r.origin[k] = (o[k] - frame.low.data()[k]) * frame.cells_a_unit.data()[k];
        r.direction[k] = d[k] * frame.cells_a_unit.data()[k];
        r.inverse[k] = magnitude(r.direction[k]) >= 0x1p-100f ? 1.0f / r.direction[k] : 0.0f;
    }
    return r;
}

/// The part of the ray in the box of the triangles, widened by more than roundings; false: there is none.
ENFILADE_HD bool part_in_box(const accel::OctreeView& tree, const LatticeRay& r, float& enter, float& leave) {
    const float slack = static_cast<float>(accel::octree_slack) * tree.frame.side();
    for (int k = 0; k < 3; ++k) {
        const float scale = tree.frame.cells_a_unit.data()[k], base = tree.frame.low.data()[k];
        const float low = (tree.low[k] - base) * scale - slack, high = (tree.high[k] - base) * scale + slack;
        if (r.inverse[k] == 0.0f) {
            if (r.origin[k] < low || r.origin[k] > high) return false;
            continue;
        }
        const float a = (low - r.origin[k]) * r.inverse[k], b = (high - r.origin[k]) * r.inverse[k];
        enter = larger(enter, a < b ? a : b);
        leave = (a < b ? b : a) < leave ? (a < b ? b : a) : leave;
    }
    return enter <= leave;
}

/// A cell of the lattice.
struct LatticeCell {
    std::uint32_t at[3];
};

ENFILADE_HD std::uint32_t within(float p, float low, float high) {
    const float q = p > low ? p : low;
    return static_cast<std::uint32_t>(q < high - 1 ? q : high - 1);
}

/// The leaf that holds a cell, from a node at `level` that holds it.
template <class Events>
ENFILADE_HD std::uint32_t leaf_at(const accel::OctreeView& tree, accel::OctreeEntry from, std::uint32_t level,
                                  const LatticeCell& cell, Events& events) {
    std::uint32_t levels = 0;
    while (!from.is_leaf()) {
        const std::uint32_t bit = tree.frame.depth - 1 - level++;
        const std::uint32_t octant =
            (cell.at[0] >> bit & 1u) | (cell.at[1] >> bit & 1u) << 1 | (cell.at[2] >> bit & 1u) << 2;
        from = tree.children[8 * std::size_t{from.number()} + octant];
        ++levels;
    }
    events.descended(levels);
    return from.number();
}

/// The triangle in a place of its leaf.
struct LeafTriangle {
    float a[3], b[3], c[3];
    std::uint32_t number;
};

ENFILADE_HD LeafTriangle triangle_in(const accel::OctreeView& tree, const accel::LinkedLeaf& leaf, std::uint32_t i) {
    const float* at = tree.corners + leaf.first + i;
    const std::size_t n = leaf.count;
    return {{at[0], at[n], at[2 * n]},
            {at[3 * n], at[4 * n], at[5 * n]},
            {at[6 * n], at[7 * n], at[8 * n]},
            bits_of(at[9 * n])};
}

/// The triangles of a leaf; true with `any` once one is met.
template <bool any>
ENFILADE_HD bool meets_leaf(const accel::OctreeView& tree, const accel::LinkedLeaf& leaf, const ShearedRay& sheared,
                            ObjectRay& ray) {
    for (std::uint32_t i = 0; i < leaf.count; ++i) {
        const LeafTriangle triangle = triangle_in(tree, leaf, i);
        const TriangleAt at = {triangle.a, triangle.b, triangle.c};
        TriangleMeeting meeting;
        if (!meets_triangle(sheared, at, meeting) || !(meeting.t >= ray.near)) continue;
        if (!(meeting.t < ray.far || (meeting.t == ray.far && triangle.number < ray.triangle))) continue;
        if (any) return true;
        ray.far = meeting.t;
        ray.triangle = triangle.number;
        describe_meeting(at, meeting, ray);
    }
    return false;
}

/// By which face the ray leaves a box, and where.
struct BoxExit {
    int axis;
    float t;
};

ENFILADE_HD BoxExit exit_of(const accel::LinkedLeaf& leaf, const LatticeRay& r) {
    BoxExit exit = {-1, 0};
    for (int k = 0; k < 3; ++k) {
        if (r.inverse[k] == 0.0f) continue;
        const float t = ((r.inverse[k] > 0 ? leaf.high[k] : leaf.low[k]) - r.origin[k]) * r.inverse[k];
        if (exit.axis < 0 || t < exit.t) exit = {k, t};
    }
    return exit;
}

/// The cell behind the face. No step goes back along any axis, so a walk ends.
ENFILADE_HD void step(const accel::LinkedLeaf& leaf, const LatticeRay& r, const BoxExit& exit, LatticeCell& cell) {
    for (int k = 0; k < 3; ++k) {
        const bool is_up = r.inverse[k] > 0;
        if (k == exit.axis) {
            cell.at[k] = static_cast<std::uint32_t>(is_up ? leaf.high[k] : leaf.low[k] - 1);
        } else {
            const std::uint32_t to = within(r.origin[k] + exit.t * r.direction[k], leaf.low[k], leaf.high[k]);
            if (is_up ? to > cell.at[k] : to < cell.at[k]) cell.at[k] = to;
        }
    }
}

/// Finds the nearest triangle in [near, far] as ObjectTracer::nearest tells; of several at one distance the one that
/// comes first in the mesh. With `any` the first that is found will do. The origin may be anywhere, also inside.
template <bool any, class Events>
ENFILADE_HD bool octree_walk(const accel::OctreeView& tree, ObjectRay& ray, Events& events) {
    if (tree.leaves == nullptr || !(ray.near <= ray.far)) return false;
    ObjectRay asked = ray;
    const float moved = bring_near(tree.low, tree.high, asked);
    const LatticeRay r = lattice_ray(tree.frame, asked);
    float enter = asked.near, leave = asked.far;
    if (!part_in_box(tree, r, enter, leave)) return false;
    const ShearedRay sheared = sheared_ray(asked);
    LatticeCell cell;
    for (int k = 0; k < 3; ++k) cell.at[k] = within(r.origin[k] + enter * r.direction[k], 0.0f, tree.frame.side());
    accel::OctreeEntry from = tree.root;
    std::uint32_t level = 0;
    while (true) {
        const std::uint32_t number = leaf_at(tree, from, level, cell, events);
        const accel::LinkedLeaf& leaf = tree.leaves[number];
        events.entered_leaf(number, leaf.count);
        if (meets_leaf<any>(tree, leaf, sheared, asked)) return true;
        const BoxExit exit = exit_of(leaf, r);
        if (exit.axis < 0 || !(exit.t < asked.far) || exit.t > leave) break;
        const int face = 2 * exit.axis + (r.inverse[exit.axis] > 0 ? 1 : 0);
        if (leaf.rope_level[face] == accel::no_neighbour) break;
        step(leaf, r, exit, cell);
        from = leaf.rope[face];
        level = leaf.rope_level[face];
    }
    if (asked.triangle == ray.triangle) return false;
    ray.far = asked.far + moved;
    ray.triangle = asked.triangle;
    ray.normal_x = asked.normal_x;
    ray.normal_y = asked.normal_y;
    ray.normal_z = asked.normal_z;
    ray.u = asked.u;
    ray.v = asked.v;
    return true;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
