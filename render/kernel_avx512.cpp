// The loops for x86-64 machines with AVX-512; compiled with -mavx512f, -mavx512vl, -mavx512bw, -mavx512dq, -mavx2,
// -mfma, -mbmi and -mbmi2, reached only where the machine has all of them.
#define ENFILADE_ISA avx512
#include "render/kernel_loops.h"
#include "render/kernel_sets.h"

namespace enfilade::render::detail {

const Kernels avx512_kernels = {"avx512", lambert_tile, look_tile, rays_float, rays_double,
                                nearest,  visible,      path_tile, path_places};

}  // namespace enfilade::render::detail
