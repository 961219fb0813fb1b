#pragma once
// Roots and inverses as a card's special units give them, for numbers whose last bits nobody needs: what fills pixels,
// and baselines. On the host they are the exact ones.

#include "accel/host_device.h"
#include "render/math.h"

namespace enfilade::render::cuda {

/// root(a), to some 2^-22 of itself. \pre a >= 0
ENFILADE_HD float quick_root(float a) {
#if defined(__CUDA_ARCH__)
    float result;
    asm("sqrt.approx.ftz.f32 %0, %1;" : "=f"(result) : "f"(a));
    return result;
#else
    return root(a);
#endif
}

/// 1 / root(a), to some 2^-22 of itself. \pre a is normal
ENFILADE_HD float quick_inverse_root(float a) {
#if defined(__CUDA_ARCH__)
    float result;
    asm("rsqrt.approx.ftz.f32 %0, %1;" : "=f"(result) : "f"(a));
    return result;
#else
    return 1.0f / root(a);
#endif
}

/// 1 / a within two units of its last place; 0 for |a| beyond 2^126.
ENFILADE_HD float quick_inverse(float a) {
#if defined(__CUDA_ARCH__)
    return __fdividef(1.0f, a);
#else
    return 1.0f / a;
#endif
}

}  // namespace enfilade::render::cuda
