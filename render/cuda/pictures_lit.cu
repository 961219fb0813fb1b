// Pictures lit by the scene's lamps.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_lit(Device& device, const PictureJob& job) {
    among_each(job, [&](const auto& rooms) { start_shaped<128, 0>(device, job, lit_pixels<float>(job, rooms)); });
}

}  // namespace enfilade::render::cuda
