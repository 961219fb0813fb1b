#pragma once
// The few functions of <cmath> that a kernel needs, always inlined: <cmath>'s own overloads are ordinary functions,
// of which the linker might keep the copy compiled for a newer instruction set (isa.h).

#include <cmath>
#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::render {

#if defined(__CUDA_ARCH__)
ENFILADE_HD float fused(float a, float b, float c) { return ::fmaf(a, b, c); }
ENFILADE_HD double fused(double a, double b, double c) { return ::fma(a, b, c); }
ENFILADE_HD float root(float a) { return ::sqrtf(a); }
ENFILADE_HD double root(double a) { return ::sqrt(a); }
ENFILADE_HD float magnitude(float a) { return ::fabsf(a); }
ENFILADE_HD double magnitude(double a) { return ::fabs(a); }
ENFILADE_HD int exponent_of(float a) { return ::ilogbf(a); }
ENFILADE_HD int exponent_of(double a) { return ::ilogb(a); }
ENFILADE_HD float scaled(float a, int exponent) { return ::scalbnf(a, exponent); }
ENFILADE_HD double scaled(double a, int exponent) { return ::scalbn(a, exponent); }
#else
/// a b + c, rounded once.
ENFILADE_HD float fused(float a, float b, float c) { return __builtin_fmaf(a, b, c); }
ENFILADE_HD double fused(double a, double b, double c) { return __builtin_fma(a, b, c); }
ENFILADE_HD float root(float a) { return __builtin_sqrtf(a); }
ENFILADE_HD double root(double a) { return __builtin_sqrt(a); }
ENFILADE_HD float magnitude(float a) { return __builtin_fabsf(a); }
ENFILADE_HD double magnitude(double a) { return __builtin_fabs(a); }
/// The power of two in a: 2^e <= |a| < 2^(e+1), also for denormal numbers.
ENFILADE_HD int exponent_of(float a) { return __builtin_ilogbf(a); }
ENFILADE_HD int exponent_of(double a) { return __builtin_ilogb(a); }
/// a 2^exponent.
ENFILADE_HD float scaled(float a, int exponent) { return __builtin_scalbnf(a, exponent); }
ENFILADE_HD double scaled(double a, int exponent) { return __builtin_scalbn(a, exponent); }
#endif

/// The bits of a float, and the float of bits.
ENFILADE_HD std::uint32_t bits_of(float a) {
#if defined(__CUDA_ARCH__)
    return __float_as_uint(a);
#else
    return __builtin_bit_cast(std::uint32_t, a);
#endif
}
ENFILADE_HD float float_of(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __uint_as_float(bits);
#else
    return __builtin_bit_cast(float, bits);
#endif
}

/// p[axis] of three. A device chooses: an index that is only known as it runs would put p into memory.
template <class T>
ENFILADE_HD T component(const T* p, int axis) {
#if defined(__CUDA_ARCH__)
    return axis == 0 ? p[0] : axis == 1 ? p[1] : p[2];
#else
    return p[axis];
#endif
}

template <class T>
ENFILADE_HD T larger(T a, T b) {
    return a > b ? a : b;
}

}  // namespace enfilade::render
