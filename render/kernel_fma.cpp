// The loops for x86-64 machines since 2013; compiled with -mavx2 -mfma, reached only where the machine has both.
#define ENFILADE_ISA fma
#include "render/kernel_loops.h"
#include "render/kernel_sets.h"

namespace enfilade::render::detail {

const Kernels fma_kernels = {"fma",   lambert_tile, look_tile, rays_float, rays_double,
                             nearest, visible,      path_tile, path_places};

}  // namespace enfilade::render::detail
