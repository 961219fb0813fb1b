#pragma once
// Counters that the threads of a kernel share.

#include <cstdint>

#include "render/cuda/warp.h"

namespace enfilade::render::cuda {

/// Adds `n`; what the counter was before. In no order: results may not depend on who gets which number.
ENFILADE_HD std::uint32_t atomic_add(std::uint32_t* counter, std::uint32_t n) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(counter, n);
#else
    return __atomic_fetch_add(counter, n, __ATOMIC_RELAXED);
#endif
}

ENFILADE_HD std::uint32_t count_bits(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return static_cast<std::uint32_t>(__popc(bits));
#else
    return static_cast<std::uint32_t>(__builtin_popcount(bits));
#endif
}

/// Numbers for the lanes in `takers`, one after the other, of a counter: one atomic a warp. Called by all lanes.
ENFILADE_HD PerLane<std::uint32_t> take_numbers(Warp warp, std::uint32_t takers, std::uint32_t* counter) {
    PerLane<std::uint32_t> numbers;
    for (int lane : warp.lanes()) numbers[lane] = lane == 0 ? atomic_add(counter, count_bits(takers)) : 0;
    const std::uint32_t first = warp.of_lane(numbers, 0);
    for (int lane : warp.lanes()) numbers[lane] = first + count_bits(takers & ((1u << lane) - 1));
    return numbers;
}

/// Rays that a kernel leaves to another one.
struct RayList {
    std::uint32_t* rays;  ///< room for all that could come
    std::uint32_t* count;

    ENFILADE_HD void add(std::uint64_t ray) const { rays[atomic_add(count, 1)] = static_cast<std::uint32_t>(ray); }
};

}  // namespace enfilade::render::cuda
