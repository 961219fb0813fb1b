#pragma once
// Inside of render/cuda: what kernels of pictures are given, and who starts them.

#include <cstdint>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/device.h"
#include "render/cuda/device_objects.h"
#include "render/cuda/frame_graph.h"
#include "render/cuda/picture_options.h"
#include "render/lamps.h"
#include "render/look.h"

namespace enfilade::render::cuda {

/// What the threads of a picture count together.
struct PictureCounters {
    std::uint32_t next_batch;  ///< that no warp has taken, of WarpWork::Persistent
    std::uint32_t rare;        ///< pixels that are left for the second kernel
};

/// One picture. Plain data but for what only the host reads; pointers are the device's.
struct PictureJob {
    accel::SceneView scene;
    CameraFrame camera;
    Look look;
    bool has_lamps = false;  ///< else a lamp at the eye
    Lamps lamps;
    std::uint32_t start_cell = 0;
    int samples_a_side = 1;
    bool is_cut = false;
    float cut_z = 0;
    float mirror_floor = 0;
    const DeviceObjects* objects = nullptr;  ///< nullptr: rooms are seen bare
    bool is_double = false;
    int width = 0, height = 0;
    float* rgb = nullptr;           ///< [3 * width * height] linear; or nullptr
    std::uint32_t* rgba = nullptr;  ///< [width * height] as Framebuffer; where rgb is nullptr
    PictureSchedule schedule;
    PictureCounters* counters = nullptr;       ///< all 0
    PictureCounters* next_counters = nullptr;  ///< of the next picture; 0 after a kernel that defers
    std::uint32_t* rare = nullptr;             ///< [width * height]
    FrameGraph* graph = nullptr;               ///< of FrameStart::Graph
};

// Those in float leave rare cases of walks (deferring.h) to a second kernel, which leaves the next counters at 0; the
// others leave `counters` as they become.

/// A lamp at the eye, plain colours, one sample a pixel (lambert.h); in float.
void start_lambert(Device& device, const PictureJob& job);
/// Lamps, plain colours, one sample (lit_pixel.h); in float.
void start_lit(Device& device, const PictureJob& job);
/// Everything that pictures may have (look_pixel.h); in float.
void start_look(Device& device, const PictureJob& job);
/// The same as start_lambert and start_look, in double.
void start_lambert_in_double(Device& device, const PictureJob& job);
void start_look_in_double(Device& device, const PictureJob& job);

}  // namespace enfilade::render::cuda
