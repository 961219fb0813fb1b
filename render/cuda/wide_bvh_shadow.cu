#include "render/cuda/bvh_kernel.h"
#include "render/cuda/bvh_starts.h"
#include "render/cuda/wide_bvh_walk.h"

namespace enfilade::render::cuda {

void start_segments(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                    unsigned long long* taken) {
    start_bvh<WideBvhWalk, SegmentFeeder>(device, view, job, schedule, taken);
}

void start_lamps(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                 unsigned long long* taken) {
    start_bvh<WideBvhWalk, LampFeeder>(device, view, job, schedule, taken);
}

}  // namespace enfilade::render::cuda
