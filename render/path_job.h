#pragma once
// Inside of render: what the loops of path tracing are given, compiled once for every instruction set (kernel.h).

#include <cstdint>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/lamps.h"
#include "render/look.h"
#include "render/object_tracer.h"
#include "render/path_sampler.h"
#include "render/walk_events.h"

namespace enfilade::render::detail {

/// What the samples of a pixel (or place) have come to. Sums are made in the order of samples, so that they do not
/// depend on how these are split into passes.
struct PathSum {
    double rgb[3];
    double luminance[path_sequences];  ///< of each sequence of samples
};

/// The light of a scene and how it is followed. Plain data.
struct PathLight {
    const Lamps* lamps;               ///< nullptr: none shine
    const std::uint32_t* ball_cells;  ///< [lamps] the cell that holds a lamp's whole ball; no_cell: none does
    std::uint32_t lamps_a_bounce;     ///< that many are drawn at each place; 0: all are asked
    Look look;                        ///< sky and sun, their strength multiplied in
    float sun_height;                 ///< 1 - cosine of the sun's angular radius
    std::uint32_t most_bounces;
    float clamp;         ///< no light by way of a bounce counts for more; 0: all of it counts
    float mirror_floor;  ///< share of light that floors reflect
    std::uint32_t seed;
};

/// Samples [begin, end) of the pixels of a rectangle, or of places.
struct PathJob {
    const accel::SceneView* scene;
    const PathLight* light;
    const ObjectTracer* objects;  ///< nullptr: rooms are bare
    RayStats* stats;              ///< nullptr: not counted
    std::uint32_t begin, end;
    PathSum* sums;  ///< of the whole image, or of all places

    // Of a picture.
    const CameraFrame* camera;
    int width;  ///< of the whole image
    int x0, y0, x1, y1;
    std::uint32_t start_cell;
    bool is_cut;  ///< dollhouse: rays of the camera start where they fall through the height cut_z
    float cut_z;

    // Of places: columns; a picture has none.
    const Vec3f* points;
    const Vec3f* normals;  ///< of length 1, on the light's side
    const accel::CellId* cells;
    std::uint32_t first_place, end_place;
};

}  // namespace enfilade::render::detail
