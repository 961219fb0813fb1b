#include "render/cuda/bvh2_walk.h"
#include "render/cuda/bvh_kernel.h"
#include "render/cuda/bvh_starts.h"

namespace enfilade::render::cuda {

void start_nearest(Device& device, const Bvh2View& view, const BvhJob& job, const BvhSchedule& schedule,
                   unsigned long long* taken) {
    start_bvh<Bvh2Walk, NearestFeeder>(device, view, job, schedule, taken);
}

}  // namespace enfilade::render::cuda
