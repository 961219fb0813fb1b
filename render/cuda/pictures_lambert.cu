// Pictures of bare and furnished rooms with a lamp at the eye.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_lambert(Device& device, const PictureJob& job) {
    if (job.objects == nullptr) return start_in_any_shape(device, job, lambert_pixels<float>(job, BareRooms{}));
    among_furnished(job,
                    [&](const auto& rooms) { start_in_two_shapes(device, job, lambert_pixels<float>(job, rooms)); });
}

}  // namespace enfilade::render::cuda
