#pragma once
// The octree of one mesh in the layouts that kernels walk: where its leaves and its triangles lie, and how many loads
// they take. Plain pointers into a device's memory; header-only, for host and device.

#include <cstdint>

#include "accel/octree/rope_octree.h"
#include "render/octree_walk.h"

namespace enfilade::render::cuda {

/// Three numbers and a fourth, loaded at once.
struct alignas(16) Quad {
    float x, y, z;
    std::uint32_t w;
};

/// What a ray towards one octant reads of a leaf, loaded at once.
struct alignas(8) OctantLeaf {
    std::uint32_t first;  ///< of its triangles, among all references
    std::uint32_t rest;   ///< three bytes of exits, then the count; many_triangles: that or more
};
inline constexpr std::uint32_t many_triangles = 255;

/// A leaf as a ray came to it.
struct LeafHead {
    std::uint32_t first, count;
    PackedExits exits;
    std::uint32_t width;  ///< as a power of two
};

struct TriangleCorners {
    float a[3], b[3], c[3];
    [[nodiscard]] ENFILADE_HD TriangleAt at() const { return {a, b, c}; }
};

/// A leaf's 24 bytes of exits by two words instead of three bytes; its count and first by one load.
[[nodiscard]] ENFILADE_HD LeafHead head_of(const accel::LinkedLeaf& leaf, std::uint32_t octant, std::uint32_t width) {
    LeafHead head;
#if defined(__CUDA_ARCH__)
    const std::uint32_t byte = 3 * octant;
    const auto* words = reinterpret_cast<const std::uint32_t*>(&leaf);
    head.exits = {__funnelshift_r(words[byte / 4], words[byte / 4 + 1], 8 * (byte % 4))};
    const uint2 triangles = *reinterpret_cast<const uint2*>(words + 6);
    head.first = triangles.x;
    head.count = triangles.y;
#else
    const std::uint8_t* exits = leaf.exits[octant];
    head.exits = {exits[0] | std::uint32_t{exits[1]} << 8 | std::uint32_t{exits[2]} << 16};
    head.first = leaf.first;
    head.count = leaf.count;
#endif
    head.width = width;
    return head;
}

/// The arrays of accel::LinkedOctree as they are: 32 bytes a leaf, triangles by columns of their leaf, ten loads each.
struct ColumnTree {
    accel::OctreeView view;

    struct Place {
        std::uint32_t at, stride;
    };
    [[nodiscard]] ENFILADE_HD LeafHead leaf(accel::JumpEntry entry, std::uint32_t octant) const {
        return head_of(view.leaves[entry.number()], octant, entry.width());
    }
    [[nodiscard]] static ENFILADE_HD Place place(const LeafHead& leaf, std::uint32_t i) {
        return {leaf.first + i, leaf.count};
    }
    [[nodiscard]] ENFILADE_HD TriangleCorners triangle(const Place& place, std::uint32_t& /*number*/) const {
        const float* at = view.corners + place.at;
        const std::size_t n = place.stride;
        return {{at[0], at[n], at[2 * n]}, {at[3 * n], at[4 * n], at[5 * n]}, {at[6 * n], at[7 * n], at[8 * n]}};
    }
    /// Of the triangle loaded last.
    [[nodiscard]] ENFILADE_HD std::uint32_t number(const Place& place, std::uint32_t /*number*/) const {
        return bits_of(view.corners[place.at + 9 * std::size_t{place.stride}]);
    }
};

/// Leaves as each octant's rays read them: 8 bytes, by octant, so that of a cache line's leaves all are of use; or the
/// 32 bytes of ColumnTree, with `first` among all references.
struct LeafArrays {
    const OctantLeaf* by_octant;         ///< [octant][leaf], or nullptr
    const accel::LinkedLeaf* as_linked;  ///< [leaf]; with by_octant only where there are many_triangles
    std::uint32_t count;

    [[nodiscard]] ENFILADE_HD LeafHead leaf(accel::JumpEntry entry, std::uint32_t octant) const {
        if (by_octant == nullptr) return head_of(as_linked[entry.number()], octant, entry.width());
        const OctantLeaf leaf = by_octant[std::size_t{octant} * count + entry.number()];
        std::uint32_t triangles = leaf.rest >> 24;
        if (triangles == many_triangles) triangles = as_linked[entry.number()].count;
        return {leaf.first, triangles, {leaf.rest & 0xffffffu}, entry.width()};
    }
};

/// 48 bytes a reference: a and the triangle's number, b, c. Three loads.
struct RecordTree {
    accel::OctreeView view;
    LeafArrays leaves;
    const Quad* records;  ///< [reference][3]

    struct Place {
        std::uint32_t at;
    };
    [[nodiscard]] ENFILADE_HD LeafHead leaf(accel::JumpEntry entry, std::uint32_t octant) const {
        return leaves.leaf(entry, octant);
    }
    [[nodiscard]] static ENFILADE_HD Place place(const LeafHead& leaf, std::uint32_t i) { return {leaf.first + i}; }
    [[nodiscard]] ENFILADE_HD TriangleCorners triangle(const Place& place, std::uint32_t& number) const {
        const Quad* at = records + 3 * std::size_t{place.at};
        const Quad a = at[0], b = at[1], c = at[2];
        number = a.w;
        return {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
    }
    [[nodiscard]] ENFILADE_HD std::uint32_t number(const Place& /*place*/, std::uint32_t number) const {
        return number;
    }
};

/// 16 bytes a reference, which lead to the mesh's corners: four loads, the first before the others, and the least
/// memory.
struct IndexedTree {
    accel::OctreeView view;
    LeafArrays leaves;
    struct alignas(16) Reference {
        std::uint32_t a, b, c, number;
    };
    const Reference* references;
    const Quad* corners;  ///< [vertex of the mesh]

    struct Place {
        std::uint32_t at;
    };
    [[nodiscard]] ENFILADE_HD LeafHead leaf(accel::JumpEntry entry, std::uint32_t octant) const {
        return leaves.leaf(entry, octant);
    }
    [[nodiscard]] static ENFILADE_HD Place place(const LeafHead& leaf, std::uint32_t i) { return {leaf.first + i}; }
    [[nodiscard]] ENFILADE_HD TriangleCorners triangle(const Place& place, std::uint32_t& number) const {
        const Reference to = references[place.at];
        const Quad a = corners[to.a], b = corners[to.b], c = corners[to.c];
        number = to.number;
        return {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}};
    }
    [[nodiscard]] ENFILADE_HD std::uint32_t number(const Place& /*place*/, std::uint32_t number) const {
        return number;
    }
};

/// The paper's octree, sides of edges in float or double.
template <class T>
struct RopeTree {
    accel::RopeView view;
};

}  // namespace enfilade::render::cuda
