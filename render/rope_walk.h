#pragma once
// The walk of Portalez and Duguet (2016, section 4) through a RopeOctree, completed: the nearest triangle whatever
// leaves it spans, rays from inside, neighbours of any size, and what to do where rounding makes the tables silent.
// One ray at a time; header-only, for host and device; sides in float or double.
//
// A walk ends: each step leaves by a face whose outward side the ray's octant faces, so leaves come in the Morton order
// of mirrored octants, each at most once, whatever is rounded.

#include <cstdint>

#include "accel/octree/rope_octree.h"
#include "render/isa.h"
#include "render/math.h"
#include "render/near_ray.h"
#include "render/rope_exit.h"
#include "render/triangle_test.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// What a walk may be asked to tell.
struct NoRopeEvents {
    ENFILADE_HD void entered_leaf(accel::RopeAddress /*leaf*/, std::uint32_t /*triangles*/) {}
    ENFILADE_HD void descended(std::uint32_t /*levels*/) {}
    ENFILADE_HD void recovered_exit(accel::RopeAddress /*leaf*/) {}  ///< the table did not say
    /// It left a leaf before it came to it: the step before was to a neighbour that the ray misses by a rounding.
    /// What such a step passes over lies within octree_slack, so its triangles are those of the leaves around.
    ENFILADE_HD void came_back(accel::RopeAddress /*leaf*/) {}
};

/// Where a ray is in the octree's cube, if it is there at all within [near, far].
template <class T>
struct RopePart {
    T enter, leave;
    std::uint32_t face;  ///< by which it enters; invalid_exit: it starts inside
};

/// The cube is widened by octree_slack: rays that touch it within rounding are walked through its outermost leaves.
template <class T>
ENFILADE_HD bool part_in_cube(const accel::RopeView& tree, const RopeRay<T>& r, RopePart<T>& part) {
    const T slack = T(accel::octree_slack) * T(tree.frame.side()), high = T(tree.frame.side()) + slack;
    for (int k = 0; k < 3; ++k) {
        if (r.inverse[k] == 0) {
            if (r.origin[k] < -slack || r.origin[k] > high) return false;
            continue;
        }
        const bool is_up = r.inverse[k] > 0;
        const T a = ((is_up ? -slack : high) - r.origin[k]) * r.inverse[k];
        const T b = ((is_up ? high : -slack) - r.origin[k]) * r.inverse[k];
        if (a > part.enter) {
            part.enter = a;
            part.face = accel::face_at(k, !is_up);
        }
        part.leave = b < part.leave ? b : part.leave;
    }
    return part.enter <= part.leave;
}

/// A coordinate as that of a cell in [low, low + width).
template <class T>
ENFILADE_HD std::uint32_t cell_within(T p, std::uint32_t low, std::uint32_t width) {
    const T least = static_cast<T>(low), most = static_cast<T>(low + width - 1);
    const T q = p > least ? p : least;
    return q < most ? static_cast<std::uint32_t>(q) : low + width - 1;
}

/// The leaf that holds a cell, from a node at `level` that does.
template <class Events>
ENFILADE_HD accel::RopeAddress rope_leaf_at(const accel::RopeView& tree, accel::RopeAddress node, std::uint32_t level,
                                            const std::uint32_t* cell, Events& events) {
    std::uint32_t levels = 0;
    for (; (node & accel::inner_bit) != 0; ++levels) {
        const std::uint32_t bit = tree.frame.depth - 1 - level++;
        const std::uint32_t octant = (cell[0] >> bit & 1u) | (cell[1] >> bit & 1u) << 1 | (cell[2] >> bit & 1u) << 2;
        node = tree.words[(node & ~accel::inner_bit) + octant];
    }
    events.descended(levels);
    return node;
}

/// The leaf where the ray's part begins: by the cube map from outside, else down the tree.
template <class T, class Events>
ENFILADE_HD accel::RopeAddress first_leaf(const accel::RopeView& tree, const RopeRay<T>& r, const RopePart<T>& part,
                                          Events& events) {
    const std::uint32_t side = 1u << tree.frame.depth;
    const bool is_inside = part.face == invalid_exit;
    const int axis = is_inside ? 3 : accel::axis_of(part.face);
    std::uint32_t cell[3];
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t border = accel::is_high(part.face) ? side - 1 : 0;
        const std::uint32_t within = cell_within(r.origin[k] + part.enter * r.direction[k], 0u, side);
        cell[k] = k == axis ? border : within;
    }
    if (is_inside) return rope_leaf_at(tree, tree.root, 0, cell, events);
    const std::uint32_t down = tree.frame.depth - tree.cube_map_level;
    const std::uint32_t u = (axis == 0 ? cell[1] : cell[0]) >> down, v = (axis == 2 ? cell[1] : cell[2]) >> down;
    const std::size_t row = (std::size_t{part.face} << tree.cube_map_level) + v;
    return rope_leaf_at(tree, tree.cube_map[(row << tree.cube_map_level) + u], tree.cube_map_level, cell, events);
}

/// Neighbours before a face's, from nCount.
ENFILADE_HD std::uint32_t neighbours_before(std::uint32_t counts, std::uint32_t face) {
    const std::uint32_t before = counts & ((1u << 4 * face) - 1);
    return (((before & 0x0f0f0fu) + (before >> 4 & 0x0f0f0fu)) * 0x010101u >> 16) & 0xffu;
}

/// The leaf behind a face; `is_border`: there is none. from: as for exit_of.
template <class T, class Events>
ENFILADE_HD accel::RopeAddress next_leaf(const accel::RopeView& tree, accel::RopeAddress leaf,
                                         const accel::RopeCube& cube, const RopeRay<T>& r, const T* from,
                                         const RopeExit<T>& exit, bool& is_border, Events& events) {
    const std::uint32_t counts = tree.words[leaf + 3], count = counts >> 4 * exit.face & 15u;
    is_border = count == 0;
    if (is_border) return leaf;
    const std::uint32_t at = leaf + tree.header + neighbours_before(counts, exit.face);
    if (tree.is_balanced) return tree.words[at + count / 4 * quarter_left_by(r, cube, from, exit.face)];
    const accel::RopeAddress node = tree.words[at];
    if ((node & accel::inner_bit) == 0) return node;
    const int axis = accel::axis_of(exit.face);
    std::uint32_t cell[3];
    for (int k = 0; k < 3; ++k) {
        const std::uint32_t behind = accel::is_high(exit.face) ? cube.low[k] + cube.width : cube.low[k] - 1;
        const std::uint32_t within = cell_within(r.origin[k] + exit.t * r.direction[k], cube.low[k], cube.width);
        cell[k] = k == axis ? behind : within;
    }
    return rope_leaf_at(tree, node, cube.level, cell, events);
}

/// The triangles of a leaf; true with `any` once one is met.
template <bool any>
ENFILADE_HD bool meets_rope_leaf(const accel::RopeView& tree, accel::RopeAddress leaf, const ShearedRay& sheared,
                                 ObjectRay& ray) {
    const accel::RopeTriangle* triangle = tree.triangles + tree.words[leaf + 1];
    const accel::RopeTriangle* end = triangle + tree.words[leaf];
    for (; triangle != end; ++triangle) {
        const TriangleAt at = {triangle->corners[0], triangle->corners[1], triangle->corners[2]};
        TriangleMeeting meeting;
        if (!meets_triangle(sheared, at, meeting) || !(meeting.t >= ray.near)) continue;
        if (!(meeting.t < ray.far || (meeting.t == ray.far && triangle->number < ray.triangle))) continue;
        if (any) return true;
        ray.far = meeting.t;
        ray.triangle = triangle->number;
        describe_meeting(at, meeting, ray);
    }
    return false;
}

/// Walks from leaf to leaf. visit(leaf): true ends the walk. is_past(t): whether nothing is asked for from there on.
template <class T, class Visit, class IsPast, class Events>
ENFILADE_HD void walk_ropes(const accel::RopeView& tree, const RopeRay<T>& r, const RopePart<T>& part,
                            const Visit& visit, const IsPast& is_past, Events& events) {
    accel::RopeAddress leaf = first_leaf(tree, r, part, events);
    T so_far = part.enter;
    while (true) {
        events.entered_leaf(leaf, tree.words[leaf]);
        if (visit(leaf)) return;
        const accel::RopeCube cube = accel::cube_of(tree, leaf);
        T from[3];
        from_leaving_corner(r, cube, from);
        const RopeExit<T> exit = exit_of(r, from);
        if (exit.is_recovered) events.recovered_exit(leaf);
        if (exit.face == invalid_exit) return;
        if (exit.t < so_far) events.came_back(leaf);
        else so_far = exit.t;
        if (is_past(so_far) || exit.t > part.leave) return;
        bool is_border;
        leaf = next_leaf(tree, leaf, cube, r, from, exit, is_border, events);
        if (is_border) return;
    }
}

/// Finds the nearest triangle in [near, far] as ObjectTracer::nearest tells; of several at one distance the one that
/// comes first in the mesh. With `any` the first that is found will do. The origin may be anywhere, also inside. A hit
/// beyond the leaf that lists its triangle is kept, and holds once no leaf is left before it: the paper's walk, which
/// returns it at once, finds the wrong one.
template <class T, bool any, class Events>
ENFILADE_HD bool rope_walk(const accel::RopeView& tree, ObjectRay& ray, Events& events) {
    if (tree.words == nullptr || !(ray.near <= ray.far)) return false;
    ObjectRay asked = ray;
    const float moved = bring_near(tree.low, tree.high, asked);
    const float origin[3] = {asked.origin_x, asked.origin_y, asked.origin_z};
    const float direction[3] = {asked.direction_x, asked.direction_y, asked.direction_z};
    const RopeRay<T> r = rope_ray<T>(tree.frame, origin, direction);
    RopePart<T> part = {T(asked.near), T(asked.far), invalid_exit};
    if (!part_in_cube(tree, r, part)) return false;
    const ShearedRay sheared = sheared_ray(asked);
    bool is_met = false;
    walk_ropes(
        tree, r, part,
        [&](accel::RopeAddress leaf) { return is_met = meets_rope_leaf<any>(tree, leaf, sheared, asked); },
        [&](T t) { return !(t < T(asked.far)); }, events);
    if (any || asked.triangle == ray.triangle) return is_met;
    bring_back(asked, moved, ray);
    return true;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
