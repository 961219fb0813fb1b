// Pictures of bare and furnished rooms with a lamp at the eye.
#include "render/cuda/picture_kernel.h"
#include "render/cuda/picture_pixels.h"

namespace enfilade::render::cuda {

void start_lambert(Device& device, const PictureJob& job) {
    if (job.objects == nullptr) return start_in_any_shape(device, job, lambert_pixels<float>(job, BareRooms{}));
    if (job.objects->kind() == InsideKind::Octree)
        return start_in_two_shapes(device, job,
                                   lambert_pixels<float>(job, RoomsWith<OctreeTrees>{job.objects->octrees()}));
    start_in_two_shapes(device, job, lambert_pixels<float>(job, RoomsWith<MeshTrees>{job.objects->bvhs()}));
}

}  // namespace enfilade::render::cuda
