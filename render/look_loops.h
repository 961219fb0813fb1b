// The loops of pictures with sun, sky and darkened corners. Included by kernel_loops.h alone, once for each instruction
// set: no include guard is needed.

#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/look_pixel.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

void store(const detail::TileJob& job, int x, int y, Vec3f colour) {
    const std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x;
    if (job.rgb == nullptr) {
        job.rgba[pixel] = encoded(colour);
        return;
    }
    float* p = job.rgb + 3 * pixel;
    p[0] = colour.x;
    p[1] = colour.y;
    p[2] = colour.z;
}

template <class T, class Rooms, class Events>
void look_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const LookPicture picture = {&scene,     &camera,   job.look,        job.lamps, job.start_cell, job.samples_a_side,
                                 job.is_cut, job.cut_z, job.mirror_floor};
    const LookTools<Rooms, Events> tools = {picture, scene, *job.look, rooms, events};
    std::uint32_t near_cell = no_cell;
    for (int y = job.y0; y < job.y1; ++y)
        for (int x = job.x0; x < job.x1; ++x) store(job, x, y, look_pixel<T>(tools, x, y, near_cell));
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
