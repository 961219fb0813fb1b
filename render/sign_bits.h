#pragma once
// Side tests as a device does them fastest: two fused multiply-adds, an addition and a shift a line, whose bits are the
// signs of the sides. The same answers as left_bits.

#include <cstdint>

#include "render/isa.h"
#include "render/ray.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Bits from the upper end downward: the newest is bit 0.
class SignBits {
public:
    /// 1 for a number below zero. -0 counts as zero.
    ENFILADE_HD void push(float number) {
        const std::uint32_t bits = bits_of(number + 0.0f);
#if defined(__CUDA_ARCH__)
        bits_ = __funnelshift_l(bits, bits_, 1);
#else
        bits_ = bits_ << 1 | bits >> 31;
#endif
    }
    /// Of `count` numbers pushed, 1 to 32 of them, bit i is the i-th.
    ENFILADE_HD std::uint32_t in_order(std::uint32_t count) const {
#if defined(__CUDA_ARCH__)
        return __brev(bits_ << (32 - count));
#else
        std::uint32_t ordered = 0;
        for (std::uint32_t i = 0; i < count; ++i) ordered |= (bits_ >> (count - 1 - i) & 1u) << i;
        return ordered;
#endif
    }

private:
    std::uint32_t bits_ = 0;
};

/// line_side of a ray, negated where zero counts as negative, and negated once more: below zero is what left_bits calls
/// positive. Rounding to nearest is the same for numbers and their negatives.
struct NegatedSide {
    float x, y, moment;

    ENFILADE_HD explicit NegatedSide(const Ray<float>& ray)
        : x(ray.zero_sign * ray.direction.y),
          y(-ray.zero_sign * ray.direction.x),
          moment(-ray.zero_sign * ray.moment) {}
    ENFILADE_HD float operator()(float line_x, float line_y) const {
        return fused(line_y, y, fused(line_x, x, moment));
    }
};

/// left_bits of 1 to 32 lines.
ENFILADE_HD std::uint32_t left_bits_by_signs(const Ray<float>& ray, const float* xs, const float* ys,
                                             std::uint32_t count) {
    const NegatedSide side(ray);
    SignBits bits;
    const std::size_t size = count;
    for (std::size_t i = 0; i < size; ++i) bits.push(side(xs[i], ys[i]));
    return bits.in_order(count) ^ ray.zero_mask;
}

#if defined(__CUDACC__)
/// What kernels, and they alone, take for the general one of left_bits.h.
ENFILADE_HD std::uint32_t left_bits(const Ray<float>& ray, const float* xs, const float* ys, std::uint32_t count) {
    return left_bits_by_signs(ray, xs, ys, count);
}
#endif

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
