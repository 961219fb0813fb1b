// N floats in as many registers as they take, and masks as bits. Included by lanes.cpp, once for every instruction
// set; no include guard is needed.

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using DU = hn::RebindToUnsigned<D>;
using DI = hn::RebindToSigned<D>;
using V = hn::Vec<D>;
inline constexpr int lane_count = static_cast<int>(hn::MaxLanes(D()));

/// A ray each bit, the lowest first.
using Bits = std::uint32_t;
template <int N>
inline constexpr Bits all_bits = ~Bits(0) >> (32 - N);

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

/// N floats, a multiple of `lane_count`, at most 32.
template <int N>
struct Floats {
    static constexpr int vectors = N / lane_count;
    static_assert(vectors * lane_count == N && N <= 32);
    V v[vectors];

    Floats() = default;
    HWY_INLINE explicit Floats(float value) {
        for (int k = 0; k < vectors; ++k) v[k] = hn::Set(D(), value);
    }
};

template <int N>
HWY_INLINE Floats<N> load(const float* HWY_RESTRICT p) {
    Floats<N> r;
    for (int k = 0; k < r.vectors; ++k) r.v[k] = hn::LoadU(D(), p + k * lane_count);
    return r;
}
template <int N>
HWY_INLINE void store(Floats<N> a, float* HWY_RESTRICT p) {
    for (int k = 0; k < a.vectors; ++k) hn::StoreU(a.v[k], D(), p + k * lane_count);
}

#define ENFILADE_LANEWISE(name, expression)                      \
    template <int N>                                             \
    HWY_INLINE Floats<N> name(Floats<N> a, Floats<N> b) {        \
        Floats<N> r;                                             \
        for (int k = 0; k < r.vectors; ++k) r.v[k] = expression; \
        return r;                                                \
    }
ENFILADE_LANEWISE(operator+, hn::Add(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator-, hn::Sub(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator*, hn::Mul(a.v[k], b.v[k]))
ENFILADE_LANEWISE(operator/, hn::Div(a.v[k], b.v[k]))
ENFILADE_LANEWISE(largest, hn::Max(a.v[k], b.v[k]))
ENFILADE_LANEWISE(least, hn::Min(a.v[k], b.v[k]))
#undef ENFILADE_LANEWISE

template <int N>
HWY_INLINE Floats<N> operator-(Floats<N> a) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::Neg(a.v[k]);
    return a;
}
template <int N>
HWY_INLINE Floats<N> root_of(Floats<N> a) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::Sqrt(a.v[k]);
    return a;
}
/// 1 / root(a), to 12 bits or better.
template <int N>
HWY_INLINE Floats<N> quick_inverse_root(Floats<N> a) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::ApproximateReciprocalSqrt(a.v[k]);
    return a;
}
/// 1 / a, to 11 bits or better.
template <int N>
HWY_INLINE Floats<N> quick_inverse(Floats<N> a) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::ApproximateReciprocal(a.v[k]);
    return a;
}
template <int N>
HWY_INLINE Floats<N> magnitude_of(Floats<N> a) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::Abs(a.v[k]);
    return a;
}
/// a b + c: rounded once where the instruction set can.
template <int N>
HWY_INLINE Floats<N> fused_lanes(Floats<N> a, Floats<N> b, Floats<N> c) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::MulAdd(a.v[k], b.v[k], c.v[k]);
    return a;
}
/// Lanes of a where bits are set, else of b.
template <int N>
HWY_INLINE Floats<N> choose(Bits bits, Floats<N> a, Floats<N> b) {
    for (int k = 0; k < a.vectors; ++k) a.v[k] = hn::IfThenElse(mask_of(bits, k), a.v[k], b.v[k]);
    return a;
}
#define ENFILADE_COMPARE(name, compare)                                                                       \
    template <int N>                                                                                          \
    HWY_INLINE Bits name(Floats<N> a, Floats<N> b) {                                                          \
        Bits bits = 0;                                                                                        \
        for (int k = 0; k < a.vectors; ++k) bits |= bits_of(hn::compare(a.v[k], b.v[k])) << (k * lane_count); \
        return bits;                                                                                          \
    }
ENFILADE_COMPARE(is_less, Lt)
ENFILADE_COMPARE(is_at_most, Le)
ENFILADE_COMPARE(is_equal, Eq)
#undef ENFILADE_COMPARE

template <int N>
HWY_INLINE float least_lane(const Floats<N>& a) {
    V v = a.v[0];
    for (int k = 1; k < a.vectors; ++k) v = hn::Min(v, a.v[k]);
    return hn::GetLane(hn::MinOfLanes(D(), v));
}
template <int N>
HWY_INLINE float largest_lane(const Floats<N>& a) {
    V v = a.v[0];
    for (int k = 1; k < a.vectors; ++k) v = hn::Max(v, a.v[k]);
    return hn::GetLane(hn::MaxOfLanes(D(), v));
}

/// N points or directions.
template <int N>
struct Points {
    Floats<N> x, y, z;
};
template <int N>
HWY_INLINE Floats<N> dot_lanes(const Points<N>& a, const Points<N>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
