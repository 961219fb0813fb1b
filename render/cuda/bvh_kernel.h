#pragma once
// The kernels of baselines. Included by .cu files alone.

#include <cstdint>

#include "render/cuda/bvh_job.h"
#include "render/cuda/bvh_schedule.h"
#include "render/cuda/launch.h"

namespace enfilade::render::cuda {

/// A thread's rays: one item, or persistently one item after the other.
template <class Walk, class View, class Feeder, bool is_persistent, int least_blocks>
struct BvhKernel {
    static constexpr LaunchShape shape = {bvh_block, least_blocks};
    View bvh;
    BvhJob job;
    unsigned long long* taken;  ///< items; persistent threads share it
    int fetch_below;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        NoBvhEvents none;
        Walk walk;
        typename Walk::Stack waiting;
        Feeder feeder;
        if (is_persistent) i = take_ray(taken);
        if (i >= job.count) return;
        feeder.start(job, i);
        bool is_done = true;
        while (true) {
            if (is_done) {
                BvhQuery query;
                while (!feeder.next(job, i, query)) {
                    if (!is_persistent) return;
                    i = take_ray(taken);
                    if (i >= job.count) return;
                    feeder.start(job, i);
                }
                walk.begin(bvh, query, waiting);
            }
            is_done = walk.go(bvh, is_persistent ? fetch_below : 0, waiting, none);
            if (is_done) feeder.answer(job, i, bvh, walk.hit());
            if (is_persistent) meet_lanes();
        }
    }
};

/// Threads that a multiprocessor holds at most.
inline constexpr std::uint64_t resident_threads = 2048;

/// Starts the job. taken: a number in the device's memory for persistent threads
template <class Walk, class Feeder, int least_blocks, class View>
void start_bvh(Device& device, const View& view, const BvhJob& job, const BvhSchedule& schedule,
               unsigned long long* taken) {
    if (!schedule.is_persistent) {
        for_each(device, job.count, BvhKernel<Walk, View, Feeder, false, least_blocks>{view, job, nullptr, 0});
        return;
    }
    device.clear(taken, sizeof *taken);
    const std::uint64_t threads = static_cast<std::uint64_t>(device.multiprocessors()) * resident_threads;
    for_each(device, threads < job.count ? threads : job.count,
             BvhKernel<Walk, View, Feeder, true, least_blocks>{view, job, taken, schedule.fetch_below});
}

/// The kernel for a scene with objects or without. The watertight test is for comparing answers, not for speed: a
/// thread a ray.
template <template <bool, bool, TriangleTest> class Walk, class Feeder, class View>
void start_bvh(Device& device, const View& view, const BvhJob& job, const BvhSchedule& schedule,
               unsigned long long* taken) {
    constexpr bool any = Feeder::any;
    if (job.count == 0) return;
    if (job.test == TriangleTest::Watertight)
        for_each(device, job.count,
                 BvhKernel<Walk<any, true, TriangleTest::Watertight>, View, Feeder, false, 0>{view, job, nullptr, 0});
    else if (view.instance_count == 0)
        start_bvh<Walk<any, false, TriangleTest::Fast>, Feeder, 8>(device, view, job, schedule, taken);
    else start_bvh<Walk<any, true, TriangleTest::Fast>, Feeder, 8>(device, view, job, schedule, taken);
}

}  // namespace enfilade::render::cuda
