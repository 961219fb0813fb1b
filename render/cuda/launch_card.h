#pragma once
// Inside of launch.h: kernels of a card. The body lies in the launch's constant memory, so a scene's view costs a
// thread no copy.

#include <cuda_runtime.h>

#include <cstdint>

#include "render/cuda/check_call.h"
#include "render/cuda/device.h"
#include "render/cuda/warp.h"

namespace enfilade::render::cuda {

template <class Body, int block, int least_blocks>
__global__ void __launch_bounds__(block, least_blocks)
    each_kernel(const __grid_constant__ Body body, std::uint64_t count) {
    const std::uint64_t i = std::uint64_t{blockIdx.x} * block + threadIdx.x;
    if (i < count) body(i);
}

template <class Body, int block, int least_blocks>
__global__ void __launch_bounds__(block, least_blocks)
    warp_kernel(const __grid_constant__ Body body, std::uint64_t count) {
    const std::uint64_t w = (std::uint64_t{blockIdx.x} * block + threadIdx.x) / warp_size;
    if (w < count) body(Warp(), w);
}

/// Blocks for so many threads. \throws CudaError if there are more than a card can number
inline unsigned blocks_for(std::uint64_t threads, int block) {
    const std::uint64_t blocks = (threads + static_cast<std::uint64_t>(block) - 1) / static_cast<std::uint64_t>(block);
    if (blocks > 0x7fffffffu)
        throw CudaError("A card cannot be asked for so many threads at once; ask for fewer rays.");
    return static_cast<unsigned>(blocks);
}

template <class Body, int block, int least_blocks>
void start_each(Device& device, std::uint64_t count, const Body& body) {
    each_kernel<Body, block, least_blocks>
        <<<blocks_for(count, block), block, 0, static_cast<cudaStream_t>(device.stream())>>>(body, count);
    check_call(cudaGetLastError(), "starting a kernel");
}

template <class Body, int block, int least_blocks>
void start_warps(Device& device, std::uint64_t count, const Body& body) {
    static_assert(block % warp_size == 0);
    warp_kernel<Body, block, least_blocks>
        <<<blocks_for(count * warp_size, block), block, 0, static_cast<cudaStream_t>(device.stream())>>>(body, count);
    check_call(cudaGetLastError(), "starting a kernel");
}

}  // namespace enfilade::render::cuda
