// Pictures with all that light does.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_look(Device& device, const PictureJob& job) {
    among_any(job, [&](const auto& rooms) { start_shaped<128, 0>(device, job, look_pixels<float>(job, rooms)); });
}

}  // namespace enfilade::render::cuda
