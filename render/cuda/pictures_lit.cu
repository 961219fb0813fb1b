// Pictures lit by the scene's lamps.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_lit(Device& device, const PictureJob& job) {
    if (job.objects == nullptr) return start_shaped<128, 0>(device, job, lit_pixels<float>(job, BareRooms{}));
    among_furnished(job, [&](const auto& rooms) { start_shaped<128, 0>(device, job, lit_pixels<float>(job, rooms)); });
}

}  // namespace enfilade::render::cuda
