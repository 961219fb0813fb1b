#pragma once
// Step 1's side tests of up to 32 vertical lines at once: bit i says that line i passes on the left of the ray.

#include <cstdint>

#include "render/isa.h"
#include "render/ray.h"

#if defined(__AVX2__) && defined(__FMA__) && !defined(__CUDACC__)
#include <immintrin.h>
#define ENFILADE_WIDE_SIDES 1
#else
#define ENFILADE_WIDE_SIDES 0
#endif

namespace enfilade::render {
inline namespace ENFILADE_ISA {

template <class T>
ENFILADE_HD std::uint32_t left_bits(const Ray<T>& ray, const float* xs, const float* ys, std::uint32_t count) {
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        bits |= static_cast<std::uint32_t>(ray.zero_sign * line_side(ray, T(xs[i]), T(ys[i])) > T(0)) << i;
    return bits ^ ray.zero_mask;
}

#if ENFILADE_WIDE_SIDES
#if defined(__AVX512F__)
inline constexpr std::uint32_t wide_lines = 16;  ///< how many lines one instruction tests
using WideFloat = __m512;
ENFILADE_HD WideFloat load_wide(const float* p) { return _mm512_loadu_ps(p); }
ENFILADE_HD void store_wide(float* p, WideFloat a) { _mm512_store_ps(p, a); }
ENFILADE_HD WideFloat wide_of(const float* p) { return _mm512_set1_ps(*p); }
ENFILADE_HD WideFloat wide_fused(WideFloat a, WideFloat b, WideFloat c) { return _mm512_fmadd_ps(a, b, c); }
ENFILADE_HD WideFloat wide_minus(WideFloat a, WideFloat b) { return _mm512_sub_ps(a, b); }
ENFILADE_HD WideFloat wide_times(WideFloat a, WideFloat b) { return _mm512_mul_ps(a, b); }
/// Bit i: a, its sign exchanged where that of `flip` is minus, is more than 0 in lane i.
ENFILADE_HD std::uint32_t wide_positive(WideFloat a, WideFloat flip) {
    return _cvtmask16_u32(_mm512_cmp_ps_mask(_mm512_xor_ps(a, flip), _mm512_setzero_ps(), _CMP_GT_OQ));
}
/// Lane i.
ENFILADE_HD float wide_at(WideFloat a, std::uint32_t i) {
    return _mm512_cvtss_f32(_mm512_maskz_permutexvar_ps(0xffff, _mm512_set1_epi32(static_cast<int>(i)), a));
}
#else
inline constexpr std::uint32_t wide_lines = 8;
using WideFloat = __m256;
ENFILADE_HD WideFloat load_wide(const float* p) { return _mm256_loadu_ps(p); }
ENFILADE_HD void store_wide(float* p, WideFloat a) { _mm256_store_ps(p, a); }
ENFILADE_HD WideFloat wide_of(const float* p) { return _mm256_broadcast_ss(p); }
ENFILADE_HD WideFloat wide_fused(WideFloat a, WideFloat b, WideFloat c) { return _mm256_fmadd_ps(a, b, c); }
ENFILADE_HD WideFloat wide_minus(WideFloat a, WideFloat b) { return _mm256_sub_ps(a, b); }
ENFILADE_HD WideFloat wide_times(WideFloat a, WideFloat b) { return _mm256_mul_ps(a, b); }
ENFILADE_HD std::uint32_t wide_positive(WideFloat a, WideFloat flip) {
    return static_cast<std::uint32_t>(
        _mm256_movemask_ps(_mm256_cmp_ps(_mm256_xor_ps(a, flip), _mm256_setzero_ps(), _CMP_GT_OQ)));
}
ENFILADE_HD float wide_at(WideFloat a, std::uint32_t i) {
    return _mm256_cvtss_f32(_mm256_permutevar8x32_ps(a, _mm256_set1_epi32(static_cast<int>(i))));
}
#endif

/// Several lines an instruction. May read up to 64 bytes behind the last line.
ENFILADE_HD std::uint32_t left_bits(const Ray<float>& ray, const float* xs, const float* ys, std::uint32_t count) {
    const float minus_dy = -ray.direction.y, flip = ray.zero_mask != 0 ? -0.0f : 0.0f;
    const WideFloat dx = wide_of(&ray.direction.x), dy = wide_of(&minus_dy);
    const WideFloat moment = wide_of(&ray.moment), flips = wide_of(&flip);
    std::uint32_t bits = 0;
    std::uint32_t i = 0;
    do {
        const WideFloat side = wide_fused(load_wide(ys + i), dx, wide_fused(load_wide(xs + i), dy, moment));
        bits |= wide_positive(side, flips) << i;
        i += wide_lines;
    } while (i < count);
    return bits ^ ray.zero_mask;
}
#endif

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render

#if defined(__CUDACC__)
#include "render/sign_bits.h"
#endif
