#pragma once
// Inside of render: the loops over rays, compiled once for every instruction set that has its own file.

#include <cstdint>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/look.h"
#include "render/trace_rays.h"

namespace enfilade::render::detail {

/// A rectangle of an image. Plain data: nothing with a constructor crosses the border between instruction sets.
struct TileJob {
    const accel::SceneView* scene;
    const CameraFrame* camera;
    const Look* look;
    float* rgb;  ///< of the whole image
    int width;   ///< of the whole image
    int x0, y0, x1, y1;
    int samples_a_side;  ///< their square a pixel
    std::uint32_t start_cell;
    bool is_cut;  ///< dollhouse: rays start where they fall through the height cut_z
    float cut_z;
    RayStats* stats;  ///< nullptr: not counted
};

struct RayJob {
    const accel::SceneView* scene;
    const RayQuery* rays;
    RayHit* hits;
    std::uint64_t count;
    RayStats* stats;
};

/// The loops for one instruction set.
struct Kernels {
    const char* name;
    void (*lambert_tile)(const TileJob&);  ///< one ray a pixel, lamp at the eye
    void (*look_tile)(const TileJob&);     ///< sun, sky and darkened corners
    void (*rays_float)(const RayJob&);
    void (*rays_double)(const RayJob&);
};

/// Those for the machine that runs.
[[nodiscard]] const Kernels& kernels();

/// Those for any machine: what the tests compare with.
[[nodiscard]] const Kernels& portable_kernel_set();

/// accel::locate without std::optional: 2^32 - 1 where there is no cell. point: [3]
[[nodiscard]] std::uint32_t cell_at(const accel::SceneView& scene, const double* point);

/// accel::contains. point: [3]
[[nodiscard]] bool cell_holds(const accel::SceneView& scene, std::uint32_t cell, const double* point);

}  // namespace enfilade::render::detail
