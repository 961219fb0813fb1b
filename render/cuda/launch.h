#pragma once
// How a function becomes a kernel: one call a thread, or one a warp. Included by .cu files alone; where there is no
// nvcc, these are compiled as C++ and run on the host.

#include <cstdint>

#include "render/cuda/device.h"
#include "render/cuda/warp.h"

#if defined(__CUDACC__)
#include "render/cuda/launch_card.h"
#endif

namespace enfilade::render::cuda {

/// Threads of a block, and how many blocks a multiprocessor shall hold at least, which limits a thread's registers (0:
/// no limit). A body may have its own: `static constexpr LaunchShape shape`.
struct LaunchShape {
    int block = 128;
    int least_blocks = 0;
};

template <class Body>
constexpr LaunchShape shape_of() {
    if constexpr (requires { Body::shape; }) return Body::shape;
    else return {};
}

/// body(i) for each i below `count`, in any order. Body: plain data; operator() is const and ENFILADE_HD.
/// \throws CudaError if the kernel cannot be started
template <class Body>
void for_each(Device& device, std::uint64_t count, const Body& body) {
    if (count == 0) return;
#if defined(__CUDACC__)
    if (device.is_card())
        return start_each<Body, shape_of<Body>().block, shape_of<Body>().least_blocks>(device, count, body);
#endif
    accel::parallel_for(device.executor(), static_cast<std::size_t>(count), 1024,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t i = begin; i < end; ++i) body(static_cast<std::uint64_t>(i));
                        });
}

/// body(warp, w) for each w below `count`, one warp each.
template <class Body>
void for_each_warp(Device& device, std::uint64_t count, const Body& body) {
    if (count == 0) return;
#if defined(__CUDACC__)
    if (device.is_card())
        return start_warps<Body, shape_of<Body>().block, shape_of<Body>().least_blocks>(device, count, body);
#endif
    accel::parallel_for(device.executor(), static_cast<std::size_t>(count), 32,
                        [&](std::size_t begin, std::size_t end) {
                            for (std::size_t w = begin; w < end; ++w) body(Warp(), static_cast<std::uint64_t>(w));
                        });
}

}  // namespace enfilade::render::cuda
