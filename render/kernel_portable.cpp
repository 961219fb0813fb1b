// The loops for any machine. Where the instruction set has no fused multiply-add, the library's exact one is called:
// slow, but the same numbers everywhere.
#include "render/kernel_loops.h"
#include "render/kernel_sets.h"

namespace enfilade::render::detail {

const Kernels portable_kernels = {"portable", lambert_tile, look_tile, rays_float, rays_double,
                                  nearest,    visible,      path_tile, path_places};

}  // namespace enfilade::render::detail
