#pragma once
// How a function of a pixel becomes a picture's kernel. Included by .cu files alone.

#include <cstdint>

#include "render/cuda/launch.h"
#include "render/cuda/picture_job.h"
#include "render/framebuffer.h"
#include "render/isa.h"
#include "render/vec.h"

namespace enfilade::render::cuda {

/// Adds to a number that all threads share, and tells what it was. Each batch is taken once, in any order.
ENFILADE_HD std::uint32_t take_next(std::uint32_t* counter) {
#if defined(__CUDA_ARCH__)
    return atomicAdd(counter, 1u);
#else
    return __atomic_fetch_add(counter, 1u, __ATOMIC_RELAXED);
#endif
}

/// Where kernels of a picture put it.
struct PictureSink {
    float* rgb;           ///< linear; or nullptr
    std::uint32_t* rgba;  ///< where rgb is nullptr

    ENFILADE_HD void put(std::size_t pixel, Vec3f light) const {
        if (rgb == nullptr) {
            rgba[pixel] = encoded(light);
            return;
        }
        rgb[3 * pixel] = light.x;
        rgb[3 * pixel + 1] = light.y;
        rgb[3 * pixel + 2] = light.z;
    }
};

/// Pixels: plain data with `ENFILADE_HD bool at(int x, int y, Vec3f& light) const`, linear light; false: a rare case,
/// for RareKernel.
template <class Pixels>
struct PictureKernel {
    Pixels pixels;
    PixelBatches batches;
    bool is_persistent;  ///< else warp w draws batch w
    PictureCounters* counters;
    std::uint32_t* rare;  ///< [pixels of the image] those that RareKernel draws
    PictureSink sink;

    ENFILADE_HD void operator()(Warp warp, std::uint64_t w) const {
        std::uint32_t batch = is_persistent ? taken(warp) : static_cast<std::uint32_t>(w);
        while (batch < batches.count) {
            for (const int lane : warp.lanes()) draw(batch, static_cast<std::uint32_t>(lane));
            if (!is_persistent) return;
            batch = taken(warp);
        }
    }

private:
    ENFILADE_HD std::uint32_t taken(Warp warp) const {
        PerLane<std::uint32_t> number;
        for (const int lane : warp.lanes()) number[lane] = lane == 0 ? take_next(&counters->next_batch) : 0;
        return warp.of_lane(number, 0);
    }
    ENFILADE_HD void draw(std::uint32_t batch, std::uint32_t lane) const {
        std::uint32_t x, y;
        if (!batches.pixel(batch, lane, x, y)) return;
        Vec3f light;
        const bool is_drawn = pixels.at(static_cast<int>(x), static_cast<int>(y), light);
        if (is_drawn) sink.put(std::size_t{y} * batches.width + x, light);
        else rare[take_next(&counters->rare)] = y * batches.width + x;
    }
};

/// Draws the pixels that PictureKernel has left, and gets the counters of the next picture ready.
template <class Pixels>
struct RareKernel {
    Pixels pixels;
    std::uint32_t width, warps;
    const PictureCounters* counters;
    PictureCounters* next_counters;
    const std::uint32_t* rare;
    PictureSink sink;

    ENFILADE_HD void operator()(Warp warp, std::uint64_t w) const {
        const std::uint32_t count = counters->rare;
        for (const int lane : warp.lanes()) {
            if (w == 0 && lane == 0) *next_counters = {0, 0};
            for (std::uint32_t i = static_cast<std::uint32_t>(w) * warp_size + static_cast<std::uint32_t>(lane);
                 i < count; i += warps * warp_size)
                sink.put(rare[i],
                         pixels.at_length(static_cast<int>(rare[i] % width), static_cast<int>(rare[i] / width)));
        }
    }
};

#if defined(__CUDACC__)
/// A kernel as a node of a graph; `body` and `warps` are read when the graph is started.
template <int block, int least_blocks, class Kernel>
FrameGraph::Node node_of(const Kernel& body, const std::uint64_t& warps) {
    return {reinterpret_cast<const void*>(&warp_kernel<Kernel, block, least_blocks>),
            blocks_for(warps * warp_size, block),
            static_cast<unsigned>(block),
            {const_cast<Kernel*>(&body), const_cast<std::uint64_t*>(&warps)}};
}
#endif

/// One kernel after the other. The second: of rare pixels, in blocks of 128.
template <int block, int least_blocks, class First, class Second>
void start_both(Device& device, FrameGraph* graph, const First& first, std::uint64_t warps, const Second& second,
                std::uint64_t second_warps) {
#if defined(__CUDACC__)
    if (device.is_card()) {
        if (graph != nullptr)
            return graph->start({node_of<block, least_blocks>(first, warps), node_of<128, 0>(second, second_warps)});
        start_warps<First, block, least_blocks>(device, warps, first);
        return start_warps<Second, 128, 0>(device, second_warps, second);
    }
#else
    (void)graph;
#endif
    for_each_warp(device, warps, first);
    for_each_warp(device, second_warps, second);
}

template <int block, int least_blocks, class Kernel>
void start_one(Device& device, FrameGraph* graph, const Kernel& kernel, std::uint64_t warps) {
#if defined(__CUDACC__)
    if (device.is_card()) {
        if (graph != nullptr) return graph->start({node_of<block, least_blocks>(kernel, warps)});
        return start_warps<Kernel, block, least_blocks>(device, warps, kernel);
    }
#else
    (void)graph;
#endif
    for_each_warp(device, warps, kernel);
}

/// As many warps as a multiprocessor can hold, whatever a kernel's registers allow: those that come later find no work.
inline constexpr std::uint64_t most_warps_held = 64;
/// Those for rare pixels, which are few.
inline constexpr std::uint64_t rare_warps_held = 8;

template <int block, int least_blocks, class Pixels>
void start_shaped(Device& device, const PictureJob& job, const Pixels& pixels) {
    const PixelBatches batches(job.schedule.order, job.width, job.height);
    const bool is_persistent = job.schedule.work == WarpWork::Persistent;
    const auto cores = static_cast<std::uint64_t>(device.multiprocessors());
    const std::uint64_t held = most_warps_held * cores;
    const std::uint64_t warps = is_persistent && held < batches.count ? held : batches.count;
    const PictureSink sink = {job.rgb, job.rgba};
    const PictureKernel<Pixels> kernel = {pixels, batches, is_persistent, job.counters, job.rare, sink};
    if constexpr (Pixels::defers) {
        const std::uint64_t rare_warps = rare_warps_held * cores;
        const RareKernel<Pixels> second = {pixels,       batches.width,     static_cast<std::uint32_t>(rare_warps),
                                           job.counters, job.next_counters, job.rare,
                                           sink};
        start_both<block, least_blocks>(device, job.graph, kernel, warps, second, rare_warps);
    } else {
        start_one<block, least_blocks>(device, job.graph, kernel, warps);
    }
}

/// Any shape, for the kernel that is measured most.
template <class Pixels>
void start_in_any_shape(Device& device, const PictureJob& job, const Pixels& pixels) {
    switch (job.schedule.shape) {
        case KernelShape::Blocks128: return start_shaped<128, 0>(device, job, pixels);
        case KernelShape::Blocks64: return start_shaped<64, 0>(device, job, pixels);
        case KernelShape::Blocks256: return start_shaped<256, 0>(device, job, pixels);
        case KernelShape::FewRegisters: return start_shaped<128, 6>(device, job, pixels);
        case KernelShape::LeastRegisters: return start_shaped<128, 8>(device, job, pixels);
    }
}

/// Blocks of 128 threads, with as many registers as the compiler likes, or 96 where fewer are wanted.
template <class Pixels>
void start_in_two_shapes(Device& device, const PictureJob& job, const Pixels& pixels) {
    const KernelShape shape = job.schedule.shape;
    const bool is_limited = shape == KernelShape::FewRegisters || shape == KernelShape::LeastRegisters;
    if (is_limited) start_shaped<128, 5>(device, job, pixels);
    else start_shaped<128, 0>(device, job, pixels);
}

}  // namespace enfilade::render::cuda
