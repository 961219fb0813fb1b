#pragma once
// Inside of render: one table of loops for each instruction set.

#include "render/kernel.h"

namespace enfilade::render::detail {

extern const Kernels portable_kernels;
#if defined(ENFILADE_HAS_FMA_KERNELS)
extern const Kernels fma_kernels;
extern const Kernels avx512_kernels;
#endif

}  // namespace enfilade::render::detail
