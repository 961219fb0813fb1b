#pragma once
// A triangle, or an instance, as leaves hold them: three loads of 16 bytes.

#include <cstdint>

#include "render/cuda/bvh_lane.h"
#include "render/vec.h"

namespace enfilade::render::cuda {

/// Fast: a corner a, and the edges b = a - (second corner), c = (third corner) - a. Watertight: the corners. In
/// numbers: a, item; b, unused; c, unused.
struct alignas(16) TriangleRecord {
    float a[3];
    std::uint32_t item;  ///< the triangle's number, or the instance's with `instance_bit`; with `end_bit`
    float b[3];
    std::uint32_t reserved_b;
    float c[3];
    std::uint32_t reserved_c;
};
static_assert(sizeof(TriangleRecord) == 48);

inline constexpr std::uint32_t end_bit = 0x80000000u;  ///< of the last record of a leaf
inline constexpr std::uint32_t instance_bit = 0x40000000u;
inline constexpr std::uint32_t item_mask = instance_bit - 1;

/// An object, as its instance is entered and its hits are shaded: four loads of 16 bytes.
struct alignas(16) BvhInstance {
    float object_from_scene[9];    ///< rows: turns what `origin` was subtracted from
    float origin[3];               ///< of the object's space, in the scene
    std::uint32_t root;            ///< of its mesh's tree
    std::uint32_t first_triangle;  ///< of its mesh
    std::uint32_t look;            ///< of the whole object; no_look: triangles have their own
    std::uint32_t reserved;
};
static_assert(sizeof(BvhInstance) == 64);

inline constexpr std::uint32_t no_look = 0xffffffffu;

/// A record in registers.
struct RecordAt {
    Vec3f a, b, c;
    std::uint32_t item;
};

ENFILADE_HD RecordAt load_record(const TriangleRecord* records, std::uint32_t k) {
    const auto* from = reinterpret_cast<const unsigned char*>(records + k);
    const Float4 a = load_float4(from), b = load_float4(from + 16), c = load_float4(from + 32);
    return {{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}, bits_of(a.w)};
}

/// An instance in registers.
struct InstanceAt {
    Vec3f x, y, z;  ///< rows
    Vec3f origin;
    std::uint32_t root, first_triangle, look;

    ENFILADE_HD Vec3f turned(Vec3f v) const {
        return {fused(x.x, v.x, fused(x.y, v.y, x.z * v.z)), fused(y.x, v.x, fused(y.y, v.y, y.z * v.z)),
                fused(z.x, v.x, fused(z.y, v.y, z.z * v.z))};
    }
    /// A normal of the object's space in the scene.
    ENFILADE_HD Vec3f turned_normal(Vec3f n) const {
        return {fused(x.x, n.x, fused(y.x, n.y, z.x * n.z)), fused(x.y, n.x, fused(y.y, n.y, z.y * n.z)),
                fused(x.z, n.x, fused(y.z, n.y, z.z * n.z))};
    }
};

ENFILADE_HD InstanceAt load_instance(const BvhInstance* instances, std::uint32_t k) {
    const auto* from = reinterpret_cast<const unsigned char*>(instances + k);
    const Float4 a = load_float4(from), b = load_float4(from + 16), c = load_float4(from + 32),
                 d = load_float4(from + 48);
    return {{a.x, a.y, a.z}, {a.w, b.x, b.y}, {b.z, b.w, c.x}, {c.y, c.z, c.w},
            bits_of(d.x),    bits_of(d.y),    bits_of(d.z)};
}

}  // namespace enfilade::render::cuda
