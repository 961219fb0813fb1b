#pragma once
// The kernels of both baselines, each compiled in a file of its own.

#include "render/cuda/bvh2_walk.h"
#include "render/cuda/bvh_job.h"
#include "render/cuda/bvh_schedule.h"
#include "render/cuda/device.h"
#include "render/cuda/wide_node.h"

namespace enfilade::render::cuda {

// taken: a number in the device's memory for persistent threads.

/// The nearest hits of job.ask.
void start_nearest(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                   unsigned long long* taken);
void start_nearest(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                   unsigned long long* taken);
/// job.visible of job.segments.
void start_segments(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                    unsigned long long* taken);
void start_segments(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                    unsigned long long* taken);
/// The pixels of job.places by job.lamps.
void start_lamps(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                 unsigned long long* taken);
void start_lamps(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                 unsigned long long* taken);

}  // namespace enfilade::render::cuda
