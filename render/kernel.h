#pragma once
// Inside of render: the loops over rays, compiled once for every instruction set that has its own file.

#include <cstdint>
#include <span>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/lamps.h"
#include "render/look.h"
#include "render/object_tracer.h"
#include "render/path_job.h"
#include "render/trace_rays.h"
#include "render/tracer.h"

namespace enfilade::render::detail {

/// A rectangle of an image. Plain data: nothing with a constructor crosses the border between instruction sets.
struct TileJob {
    const accel::SceneView* scene;
    const CameraFrame* camera;
    const Look* look;
    float* rgb;           ///< of the whole image, linear; or nullptr
    std::uint32_t* rgba;  ///< of the whole framebuffer; where rgb is nullptr
    int width;            ///< of the whole image
    int x0, y0, x1, y1;
    int samples_a_side;  ///< their square a pixel
    std::uint32_t start_cell;
    bool is_cut;  ///< dollhouse: rays start where they fall through the height cut_z
    float cut_z;
    float mirror_floor;           ///< share of light that floors reflect
    PacketSizes packets;          ///< of the packet tracer
    RayStats* stats;              ///< nullptr: not counted
    bool is_double;               ///< walked in double precision, the same rays; the scalar loops alone do
    const ObjectTracer* objects;  ///< nullptr: rooms are seen bare
    const Lamps* lamps;           ///< nullptr: a lamp at the eye lights what is seen
};

struct RayJob {
    const accel::SceneView* scene;
    const RayQuery* rays;
    RayHit* hits;
    std::uint64_t count;
    RayStats* stats;
    const ObjectTracer* objects;  ///< nullptr: rooms are walked bare
};

/// Rays of a stream (ray_stream.h) by their columns; columns that are not wanted are nullptr.
struct StreamJob {
    const accel::SceneView* scene;
    const float* origin[3];
    const float* direction[3];
    const accel::CellId* start;
    const float* max_distance;  ///< nullptr: none
    float* distance;
    accel::SourceFaceId* source_face;
    accel::CellId* cell;
    WalkStatus* status;
    accel::ObjectId* object;
    std::uint32_t* triangle;
    const ObjectTracer* objects;  ///< nullptr: rooms are walked bare
    const std::uint32_t* order;   ///< which rays, in this order; nullptr: 0, 1, 2...
    std::uint64_t begin, end;     ///< places in that order
    RayStats* stats;
};

/// Segments of a stream by their columns.
struct SegmentJob {
    const accel::SceneView* scene;
    const float* from[3];
    const float* to[3];
    const accel::CellId* from_cell;
    const accel::CellId* to_cell;  ///< nullptr: not known
    std::uint8_t* visible;
    const ObjectTracer* objects;  ///< nullptr: nothing stands in the rooms
    const std::uint32_t* order;
    std::uint64_t begin, end;
    RayStats* stats;
};

/// The loops for one instruction set, one ray at a time.
struct Kernels {
    const char* name;
    void (*lambert_tile)(const TileJob&);  ///< one ray a pixel, a lamp at the eye or `lamps` alone; to rgb or rgba
    void (*look_tile)(const TileJob&);     ///< sun, sky and darkened corners; to rgb
    void (*rays_float)(const RayJob&);
    void (*rays_double)(const RayJob&);
    void (*nearest)(const StreamJob&);
    void (*visible)(const SegmentJob&);
    void (*path_tile)(const PathJob&);    ///< samples of the pixels of a rectangle
    void (*path_places)(const PathJob&);  ///< of places
};

/// The loops of many rays at once, for one instruction set (lanes.cpp).
struct LaneKernels {
    const char* name;
    int lanes;                            ///< floats in a register
    void (*simd_tile)(const TileJob&);    ///< Lambert; to rgb or rgba
    void (*packet_tile)(const TileJob&);  ///< the same
    void (*fill_tile)(const TileJob&);    ///< the limit: no tracing but of its first ray, whose face fills the tile
    void (*nearest)(const StreamJob&);
    void (*visible)(const SegmentJob&);
};

/// Those for the machine that runs, of what Highway finds there; nullptr in a build without Highway.
[[nodiscard]] const LaneKernels* lane_kernels();

/// Those for the machine that runs.
[[nodiscard]] const Kernels& kernels();

/// Those for all instruction sets that the machine has, the fastest first, those for any machine last.
[[nodiscard]] std::span<const Kernels* const> kernel_sets();

/// Those for any machine: what the tests compare with.
[[nodiscard]] const Kernels& portable_kernel_set();

/// accel::locate without std::optional: 2^32 - 1 where there is no cell. point: [3]
[[nodiscard]] std::uint32_t cell_at(const accel::SceneView& scene, const double* point);

/// accel::contains. point: [3]
[[nodiscard]] bool cell_holds(const accel::SceneView& scene, std::uint32_t cell, const double* point);

}  // namespace enfilade::render::detail
