#include "render/cuda/bvh2_walk.h"
#include "render/cuda/bvh_kernel.h"
#include "render/cuda/bvh_starts.h"

namespace enfilade::render::cuda {

void start_segments(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                    unsigned long long* taken) {
    start_bvh<Bvh2Walk, SegmentFeeder>(device, view, job, schedule, taken);
}

void start_lamps(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                 unsigned long long* taken) {
    start_bvh<Bvh2Walk, LampFeeder>(device, view, job, schedule, taken);
}

}  // namespace enfilade::render::cuda
