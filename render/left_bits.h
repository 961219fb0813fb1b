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
/// Eight lines an instruction: the operations and roundings of `line_side`. May read up to 32 bytes behind the
/// last line: each array of a scene has 64 bytes of zeros behind it.
ENFILADE_HD std::uint32_t left_bits(const Ray<float>& ray, const float* xs, const float* ys, std::uint32_t count) {
    const __m256 dx = _mm256_set1_ps(ray.direction.x);
    const __m256 minus_dy = _mm256_set1_ps(-ray.direction.y);
    const __m256 moment = _mm256_set1_ps(ray.moment);
    const __m256 flip = _mm256_castsi256_ps(_mm256_slli_epi32(_mm256_set1_epi32(static_cast<int>(ray.zero_mask)), 31));
    std::uint32_t bits = 0;
    std::uint32_t i = 0;
    do {
        const __m256 side =
            _mm256_fmadd_ps(_mm256_loadu_ps(ys + i), dx, _mm256_fmadd_ps(_mm256_loadu_ps(xs + i), minus_dy, moment));
        const __m256 left = _mm256_cmp_ps(_mm256_xor_ps(side, flip), _mm256_setzero_ps(), _CMP_GT_OQ);
        bits |= static_cast<std::uint32_t>(_mm256_movemask_ps(left)) << i;
        i += 8;
    } while (i < count);
    return bits ^ ray.zero_mask;
}
#endif

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
