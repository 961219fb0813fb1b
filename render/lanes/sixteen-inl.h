// Sixteen floats in as many registers as they take, and masks as 16 bits. Included by lanes.cpp, once for every
// instruction set; no include guard is needed.

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int rays_at_once = 16;
using D = hn::CappedTag<float, rays_at_once>;
using DU = hn::RebindToUnsigned<D>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
using VU = hn::Vec<DU>;
inline constexpr int lane_count = static_cast<int>(hn::MaxLanes(D()));
inline constexpr int vector_count = rays_at_once / lane_count;

/// A lane each bit, the lowest first.
using Bits = std::uint32_t;
inline constexpr Bits all_bits = 0xffffu;

HWY_INLINE hn::Mask<D> mask_of(Bits bits, int vector) {
    const std::uint64_t part = bits >> (vector * lane_count);
    std::uint8_t bytes[8];
    std::memcpy(bytes, &part, 8);
    return hn::LoadMaskBits(D(), bytes);
}

HWY_INLINE Bits bits_of(hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D(), mask, bytes);
    Bits bits;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

/// Sixteen floats.
struct F16 {
    V v[vector_count];
};

HWY_INLINE F16 broadcast(float value) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::Set(D(), value);
    return r;
}
HWY_INLINE F16 load(const float* HWY_RESTRICT p) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::LoadU(D(), p + k * lane_count);
    return r;
}
HWY_INLINE void store(F16 a, float* HWY_RESTRICT p) {
    for (int k = 0; k < vector_count; ++k) hn::StoreU(a.v[k], D(), p + k * lane_count);
}
#define ENFILADE_LANEWISE(name, expression)                         \
    HWY_INLINE F16 name(F16 a, F16 b) {                             \
        F16 r;                                                      \
        for (int k = 0; k < vector_count; ++k) r.v[k] = expression; \
        return r;                                                   \
    }
ENFILADE_LANEWISE(operator+, hn::Add(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator-, hn::Sub(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator*, hn::Mul(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator/, hn::Div(a.v[k], b.v[k]))
ENFILADE_LANEWISE(largest, hn::Max(a.v[k], b.v[k]))
#undef ENFILADE_LANEWISE

HWY_INLINE F16 operator-(F16 a) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::Neg(a.v[k]);
    return r;
}
HWY_INLINE F16 root_of(F16 a) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::Sqrt(a.v[k]);
    return r;
}
HWY_INLINE F16 magnitude_of(F16 a) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::Abs(a.v[k]);
    return r;
}
/// a b + c: rounded once where the instruction set can.
HWY_INLINE F16 fused_lanes(F16 a, F16 b, F16 c) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::MulAdd(a.v[k], b.v[k], c.v[k]);
    return r;
}
/// Lanes of a where bits are set, else of b.
HWY_INLINE F16 choose(Bits bits, F16 a, F16 b) {
    F16 r;
    for (int k = 0; k < vector_count; ++k) r.v[k] = hn::IfThenElse(mask_of(bits, k), a.v[k], b.v[k]);
    return r;
}
HWY_INLINE Bits is_less(F16 a, F16 b) {
    Bits bits = 0;
    for (int k = 0; k < vector_count; ++k) bits |= bits_of(hn::Lt(a.v[k], b.v[k])) << (k * lane_count);
    return bits;
}
HWY_INLINE Bits is_at_most(F16 a, F16 b) {
    Bits bits = 0;
    for (int k = 0; k < vector_count; ++k) bits |= bits_of(hn::Le(a.v[k], b.v[k])) << (k * lane_count);
    return bits;
}
HWY_INLINE Bits is_equal(F16 a, F16 b) {
    Bits bits = 0;
    for (int k = 0; k < vector_count; ++k) bits |= bits_of(hn::Eq(a.v[k], b.v[k])) << (k * lane_count);
    return bits;
}

/// Three of them.
struct Vec16 {
    F16 x, y, z;
};
HWY_INLINE F16 dot16(const Vec16& a, const Vec16& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
