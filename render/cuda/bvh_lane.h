#pragma once
// What walks through trees of boxes ask of a lane in one instruction, and what the host does in its stead. Unlike the
// rest of render/, these round as is fastest: baselines are not held to our walk's numbers.

#include <cstdint>
#include <cstring>

#include "accel/host_device.h"
#include "render/math.h"

namespace enfilade::render::cuda {

/// Threads of a block of baselines.
inline constexpr int bvh_block = 128;

/// Before a loop whose few rounds a kernel does one after the other without counting.
#if defined(__CUDA_ARCH__)
#define ENFILADE_UNROLL _Pragma("unroll")
#else
#define ENFILADE_UNROLL
#endif

/// 16 bytes in one load.
struct Float4 {
    float x, y, z, w;
};

/// \pre aligned to 16 bytes; nobody writes there while the kernel runs
ENFILADE_HD Float4 load_float4(const void* from) {
#if defined(__CUDA_ARCH__)
    const float4 q = __ldg(static_cast<const float4*>(from));
    return {q.x, q.y, q.z, q.w};
#else
    Float4 q;
    std::memcpy(&q, from, sizeof q);
    return q;
#endif
}

ENFILADE_HD float least(float a, float b) {
#if defined(__CUDA_ARCH__)
    return ::fminf(a, b);
#else
    return a < b ? a : b;
#endif
}
ENFILADE_HD float most(float a, float b) {
#if defined(__CUDA_ARCH__)
    return ::fmaxf(a, b);
#else
    return a > b ? a : b;
#endif
}

ENFILADE_HD std::uint32_t bits_in(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return static_cast<std::uint32_t>(__popc(bits));
#else
    return static_cast<std::uint32_t>(__builtin_popcount(bits));
#endif
}

/// \pre bits is not 0
ENFILADE_HD std::uint32_t highest_bit(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return 31u - static_cast<std::uint32_t>(__clz(bits));
#else
    return 31u - static_cast<std::uint32_t>(__builtin_clz(bits));
#endif
}

/// 2^15 + byte k of the word: the byte lies at the end of a mantissa, one permutation instead of a conversion, of which
/// multiprocessors do a quarter as many.
ENFILADE_HD float byte_above_2_15(std::uint32_t word, int k) {
#if defined(__CUDA_ARCH__)
    return __uint_as_float(__byte_perm(word, 0x47000000u, 0x7604u | static_cast<unsigned>(k) << 4));
#else
    return float_of(0x47000000u | (word >> (8 * k) & 0xffu) << 8);
#endif
}

/// 0xff for each byte whose bit 4 is set, 0 for the others. \pre no other bits are set
ENFILADE_HD std::uint32_t bytes_of_bit_4(std::uint32_t word) { return (word >> 4) * 0xffu; }

/// Whether it holds for any of the lanes that run this together: no more than a hint which way is faster.
ENFILADE_HD bool any_here(bool holds) {
#if defined(__CUDA_ARCH__)
    return __any_sync(__activemask(), holds) != 0;
#else
    return holds;
#endif
}

/// How many lanes run this together; a hint, too.
ENFILADE_HD int lanes_here() {
#if defined(__CUDA_ARCH__)
    return __popc(__activemask());
#else
    return 1;
#endif
}

/// Waits for the other lanes of the warp that have not ended.
ENFILADE_HD void meet_lanes() {
#if defined(__CUDA_ARCH__)
    __syncwarp();
#endif
}

/// The next number that nobody has taken yet: lanes that ask together ask once.
ENFILADE_HD std::uint64_t take_ray(unsigned long long* taken) {
#if defined(__CUDA_ARCH__)
    const unsigned together = __activemask();
    const int leader = __ffs(static_cast<int>(together)) - 1;
    unsigned below;
    asm("mov.u32 %0, %%lanemask_lt;" : "=r"(below));
    unsigned long long first = 0;
    if ((together & below) == 0) first = atomicAdd(taken, static_cast<unsigned long long>(__popc(together)));
    first = __shfl_sync(together, first, leader);
    return first + static_cast<unsigned>(__popc(together & below));
#else
    return __atomic_fetch_add(taken, 1ull, __ATOMIC_RELAXED);
#endif
}

}  // namespace enfilade::render::cuda
