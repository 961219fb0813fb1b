#pragma once
// Memory that the 32 threads of a warp share: on a card a part of its block's shared memory, on the host what it is.

#include "render/cuda/warp.h"

namespace enfilade::render::cuda {

/// One T a warp, for kernels of `block` threads. What is in it at the start is not defined; what one lane writes the
/// others see after Warp::meet. A kernel has one of each type at most. T: plain data
template <class T, int block>
class WarpMemory {
public:
    static_assert(block % warp_size == 0);
    /// Not where the code that follows is not reached by the whole warp.
#if defined(__CUDA_ARCH__)
    ENFILADE_HD T& get() {
        __shared__ T of_warps[block / warp_size];
        return of_warps[threadIdx.x / warp_size];
    }
#else
    ENFILADE_HD T& get() { return own_; }

private:
    T own_;
#endif
};

}  // namespace enfilade::render::cuda
