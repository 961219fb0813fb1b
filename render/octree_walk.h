#pragma once
// How a ray walks through the leaves of a mesh's octree: out of one by the box by which it may leave it, into the one
// behind. One ray at a time; header-only, for host and device. Everything is counted in the octree's lattice, where
// boxes are whole numbers, mirrored so that rays go up along every axis; the parameter stays the ray's own.
// lanes/octree_ray-inl.h does the same in registers, number by number.

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

/// A ray in the lattice, mirrored along the axes where its direction is negative.
struct LatticeRay {
    float origin[3];
    float direction[3];    ///< none is 0: the smallest are what moves the ray by less than roundings
    float inverse[3];      ///< of the direction
    std::uint32_t octant;  ///< towards which it goes
    int exponent;          ///< the walk's parameter is the ray's, times 2^exponent: 0 but for extreme directions

    /// A cell and this, by exclusive or, are the cell in the tree's own lattice.
    [[nodiscard]] ENFILADE_HD std::uint32_t mirror(const accel::OctreeView& tree, int axis) const {
        return (octant >> axis & 1u) != 0 ? 0 : (1u << tree.frame.depth) - 1;
    }
};

/// Directions whose largest component (in the lattice) is less than the inverse of that, or more, are scaled.
inline constexpr float extreme_direction = 0x1p90f;
/// Components smaller than that share of the largest count as that: over the whole octree they move a ray by less than
/// roundings do.
inline constexpr float least_share = 0x1p-30f;

ENFILADE_HD LatticeRay lattice_ray(const accel::OctreeView& tree, const ObjectRay& ray) {
    const float o[3] = {ray.origin_x, ray.origin_y, ray.origin_z};
    float d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    const float side = tree.frame.side();
    LatticeRay r;
    r.octant = 0;
    r.exponent = 0;
    float largest = 0;
    for (int k = 0; k < 3; ++k) largest = larger(largest, magnitude(d[k] * tree.box.cells_a_unit[k]));
    if (!(largest * extreme_direction >= 1.0f && largest <= extreme_direction)) {
        const float length = larger(larger(magnitude(d[0]), magnitude(d[1])), magnitude(d[2]));
        if (length > 0) r.exponent = exponent_of(length);
        for (float& each : d) each = scaled(each, -r.exponent);
        largest = 0;
        for (int k = 0; k < 3; ++k) largest = larger(largest, magnitude(d[k] * tree.box.cells_a_unit[k]));
    }
    const float least = largest * least_share;
    for (int k = 0; k < 3; ++k) {
        const float origin = (o[k] - tree.box.origin[k]) * tree.box.cells_a_unit[k];
        const float direction = d[k] * tree.box.cells_a_unit[k];
        const bool is_mirrored = direction < 0.0f;
        r.origin[k] = is_mirrored ? side - origin : origin;
        r.direction[k] = larger(magnitude(direction), least);
        r.inverse[k] = 1.0f / r.direction[k];
        r.octant |= is_mirrored ? 0 : 1u << k;
    }
    return r;
}

/// The part of the ray in the box of the triangles, widened by more than roundings; false: there is none.
ENFILADE_HD bool part_in_box(const accel::OctreeView& tree, const LatticeRay& r, float& enter, float& leave) {
    const float side = tree.frame.side();
    for (int k = 0; k < 3; ++k) {
        const bool is_mirrored = (r.octant >> k & 1u) == 0;
        const float low = is_mirrored ? side - tree.box.to[k] : tree.box.from[k];
        const float high = is_mirrored ? side - tree.box.from[k] : tree.box.to[k];
        const float a = (low - r.origin[k]) * r.inverse[k], b = (high - r.origin[k]) * r.inverse[k];
        enter = larger(enter, a);
        leave = b < leave ? b : leave;
    }
    return enter <= leave;
}

/// A cell of the ray's (mirrored) lattice.
struct LatticeCell {
    std::int32_t at[3];
};

ENFILADE_HD LatticeCell first_cell(const accel::OctreeView& tree, const LatticeRay& r, float enter) {
    LatticeCell cell;
    for (int k = 0; k < 3; ++k) {
        const float p = larger(r.origin[k] + enter * r.direction[k], 0.0f), most = tree.frame.side() - 1.0f;
        cell.at[k] = static_cast<std::int32_t>(p < most ? p : most);
    }
    return cell;
}

/// Bit i of a number to bit 3 i.
ENFILADE_HD std::uint64_t spread_bits(std::uint32_t number) {
    std::uint64_t x = number;
    x = (x | x << 32) & 0x001f00000000ffffu;
    x = (x | x << 16) & 0x001f0000ff0000ffu;
    x = (x | x << 8) & 0x100f00f00f00f00fu;
    x = (x | x << 4) & 0x10c30c30c30c30c3u;
    return (x | x << 2) & 0x1249249249249249u;
}

/// The same of a number below 2^10.
ENFILADE_HD std::uint32_t spread_ten_bits(std::uint32_t x) {
    x = (x | x << 16) & 0x030000ffu;
    x = (x | x << 8) & 0x0300f00fu;
    x = (x | x << 4) & 0x030c30c3u;
    return (x | x << 2) & 0x09249249u;
}

/// From a cell's bits interleaved, x lowest, to its leaf.
template <class Place, class Events>
ENFILADE_HD accel::JumpEntry leaf_at_place(const accel::OctreeView& tree, Place place, Events& events) {
    std::uint32_t shift = 3 * (tree.frame.depth - tree.jump_levels), jumps = 1;
    accel::JumpEntry entry = tree.jumps[place >> shift];
    while (!entry.is_leaf()) {
        shift -= 6;
        entry = tree.jumps[entry.bits + static_cast<std::uint32_t>(place >> shift & 63u)];
        ++jumps;
    }
    events.descended(jumps);
    return entry;
}

/// The leaf that holds a cell.
template <class Events>
ENFILADE_HD accel::JumpEntry leaf_at(const accel::OctreeView& tree, const LatticeRay& r, const LatticeCell& cell,
                                     Events& events) {
    if (tree.frame.depth <= 10) {  // nearly all: half the instructions, and registers, of 64 bits
        std::uint32_t place = 0;
        for (int k = 0; k < 3; ++k)
            place |= spread_ten_bits(static_cast<std::uint32_t>(cell.at[k]) ^ r.mirror(tree, k)) << k;
        return leaf_at_place(tree, place, events);
    }
    std::uint64_t place = 0;
    for (int k = 0; k < 3; ++k) place |= spread_bits(static_cast<std::uint32_t>(cell.at[k]) ^ r.mirror(tree, k)) << k;
    return leaf_at_place(tree, place, events);
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

/// Where the ray leaves the box about a leaf.
struct BoxExit {
    std::int32_t plane[3];  ///< the cells behind the box's faces
    float t[3], least;      ///< where it meets those faces, and the first of them
};

/// The octree's own faces count as being far behind: rays leave it where they leave the box of its triangles. exits:
/// [axis], of the ray's octant, as in LinkedLeaf
template <class Exits>
ENFILADE_HD BoxExit exit_by(const accel::OctreeView& tree, const Exits& exits, std::uint32_t width, const LatticeRay& r,
                            const LatticeCell& cell) {
    BoxExit exit;
    const std::uint32_t unit = accel::exit_unit(width);
    for (int k = 0; k < 3; ++k) {
        const std::int32_t low = cell.at[k] & -(1 << width);
        exit.plane[k] = low + static_cast<std::int32_t>(std::uint32_t{exits[k]} << unit);
        const bool is_border = exit.plane[k] >= (1 << tree.frame.depth);
        const float plane = is_border ? 0x1p60f : static_cast<float>(exit.plane[k]);
        exit.t[k] = (plane - r.origin[k]) * r.inverse[k];
    }
    exit.least = exit.t[0] < exit.t[1] ? exit.t[0] : exit.t[1];
    exit.least = exit.least < exit.t[2] ? exit.least : exit.t[2];
    return exit;
}

/// The exits of a leaf towards one octant, in the lowest three bytes.
struct PackedExits {
    std::uint32_t bits;
    ENFILADE_HD std::uint32_t operator[](int axis) const { return bits >> 8 * axis & 255u; }
};

ENFILADE_HD BoxExit exit_of(const accel::OctreeView& tree, const accel::LinkedLeaf& leaf, std::uint32_t width,
                            const LatticeRay& r, const LatticeCell& cell) {
    return exit_by(tree, leaf.exits[r.octant], width, r, cell);
}

/// The cell behind the face. No step goes back along any axis, and each goes on along one, so a walk ends.
ENFILADE_HD void step(const LatticeRay& r, const BoxExit& exit, LatticeCell& cell) {
    for (int k = 0; k < 3; ++k) {
        if (exit.t[k] <= exit.least) {
            cell.at[k] = exit.plane[k];
        } else {
            const auto to = static_cast<std::int32_t>(r.origin[k] + exit.least * r.direction[k]);
            const std::int32_t inside = to < exit.plane[k] ? to : exit.plane[k] - 1;
            cell.at[k] = inside > cell.at[k] ? inside : cell.at[k];
        }
    }
}

/// Where the walk ends: at what was found, or where the ray leaves the triangles' box.
ENFILADE_HD float end_of_walk(const LatticeRay& r, float far, float leave) {
    const float t = r.exponent == 0 ? far : scaled(far, r.exponent);
    return t < leave ? t : leave;
}

/// Finds the nearest triangle in [near, far] as ObjectTracer::nearest tells; of several at one distance the one that
/// comes first in the mesh. With `any` the first that is found will do. The origin may be anywhere, also inside.
template <bool any, class Events>
ENFILADE_HD bool octree_walk(const accel::OctreeView& tree, ObjectRay& ray, Events& events) {
    if (tree.leaves == nullptr || !(ray.near <= ray.far)) return false;
    ObjectRay asked = ray;
    const float moved = bring_near(tree.low, tree.high, asked);
    const LatticeRay r = lattice_ray(tree, asked);
    float enter = r.exponent == 0 ? asked.near : scaled(asked.near, r.exponent);
    float leave = r.exponent == 0 ? asked.far : scaled(asked.far, r.exponent);
    if (!part_in_box(tree, r, enter, leave)) return false;
    const ShearedRay sheared = sheared_ray(asked);
    LatticeCell cell = first_cell(tree, r, enter);
    while (true) {
        const accel::JumpEntry entry = leaf_at(tree, r, cell, events);
        const accel::LinkedLeaf& leaf = tree.leaves[entry.number()];
        events.entered_leaf(entry.number(), leaf.count);
        if (meets_leaf<any>(tree, leaf, sheared, asked)) return true;
        const BoxExit exit = exit_of(tree, leaf, entry.width(), r, cell);
        if (!(exit.least < end_of_walk(r, asked.far, leave))) break;
        step(r, exit, cell);
    }
    if (asked.triangle == ray.triangle) return false;
    bring_back(asked, moved, ray);
    return true;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
