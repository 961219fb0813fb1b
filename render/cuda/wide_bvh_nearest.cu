#include "render/cuda/bvh_kernel.h"
#include "render/cuda/bvh_starts.h"
#include "render/cuda/wide_bvh_walk.h"

namespace enfilade::render::cuda {

void start_nearest(Device& device, const WideBvhView& view, const BvhJob& job, const BvhSchedule& schedule,
                   unsigned long long* taken) {
    start_bvh<WideBvhWalk, NearestFeeder>(device, view, job, schedule, taken);
}

}  // namespace enfilade::render::cuda
