// Pictures walked in double precision.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_lambert_in_double(Device& device, const PictureJob& job) {
    among_any(job, [&](const auto& rooms) { start_shaped<128, 0>(device, job, lambert_pixels<double>(job, rooms)); });
}

void start_look_in_double(Device& device, const PictureJob& job) {
    among_any(job, [&](const auto& rooms) { start_shaped<128, 0>(device, job, look_pixels<double>(job, rooms)); });
}

}  // namespace enfilade::render::cuda
