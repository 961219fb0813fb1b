// The loops of many rays at once, by Highway: this file is compiled once for every instruction set, and the best one
// that the machine has is chosen at run time.

// Sets that add nothing here would only cost time to compile.
#include <hwy/detect_targets.h>
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lanes/lanes.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include <cmath>
#include <type_traits>

#include "render/framebuffer.h"
#include "render/kernel.h"
#include "render/mirror.h"
#include "render/object_walk.h"
#include "render/sees.h"
#include "render/shade.h"
#include "render/walk.h"

// Without registers of several floats the scalar tracer is faster.
#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {
const detail::LaneKernels* kernel_set() { return nullptr; }
}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
#else

// In the order in which they stand on each other.
#include "render/lanes/lanes-inl.h"
//
#include "render/lanes/leave-inl.h"
//
#include "render/lanes/in_view-inl.h"
//
#include "render/lanes/eye-inl.h"
//
#include "render/lanes/walk-inl.h"
//
#include "render/lanes/objects-inl.h"
//
#include "render/lanes/fill-inl.h"
//
#include "render/lanes/shade-inl.h"
//
#include "render/lanes/lamp_objects-inl.h"
//
#include "render/lanes/lamp_walks-inl.h"
//
#include "render/lanes/lamp_points-inl.h"
//
#include "render/lanes/lamp_face-inl.h"
//
#include "render/lanes/lamp_fill-inl.h"
//
#include "render/lanes/lamp_tiles-inl.h"
//
#include "render/lanes/picture-inl.h"
//
#include "render/lanes/packet-inl.h"
//
#include "render/lanes/prism-inl.h"
//
#include "render/lanes/queue-inl.h"
//
#include "render/lanes/stream-inl.h"
//
#include "render/lanes/nearest-inl.h"
//
#include "render/lanes/sight-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

template <class Job, class Body>
HWY_INLINE void counted(const Job& job, const Body& body) {
    NoEvents none;
    if (job.stats != nullptr) body(*job.stats);
    else body(none);
}

HWY_NOINLINE void simd_tile_in(const detail::TileJob& job, LitMemory* memory) {
    constexpr int block_rays = lane_count < 8 ? 16 : 32;
    constexpr int side = 32;  // of the rectangles that share an outlook on the camera's cell
    const accel::SceneView scene = *job.scene;
    ObjectsOnImage on_image(scene, *job.camera);
    counted(job, [&](auto& events) HWY_ATTR {
        for (int y = job.y0; y < job.y1; y += side)
            for (int x = job.x0; x < job.x1; x += side) {
                const Rectangle at = {x, y, x + side < job.x1 ? x + side : job.x1,
                                      y + side < job.y1 ? y + side : job.y1};
                Outlooks outlooks(scene, *job.camera, on_image, at, nullptr);
                if (memory != nullptr) {
                    memory->faces.see(at);
                    outlooks.lit = &memory->faces;
                }
                trace_blocks<block_rays>(job, scene, Bundle{job.start_cell}, outlooks, at, events);
            }
    });
}

HWY_NOINLINE void packet_tile_in(const detail::TileJob& job, LitMemory* memory) {
    const accel::SceneView scene = *job.scene;
    const Canvas canvas(job);
    counted(job, [&](auto& events) HWY_ATTR {
        Packets packets(canvas, scene, memory, events);
        for (int y = job.y0; y < job.y1; y += job.packets.largest)
            for (int x = job.x0; x < job.x1; x += job.packets.largest)
                packets.trace_all({x, y, job.packets.largest}, Bundle{job.start_cell});
    });
}

HWY_NOINLINE void lit_tile(const detail::TileJob& job, void (*trace)(const detail::TileJob&, LitMemory*)) {
    const accel::SceneView scene = *job.scene;
    LitMemory memory(job, scene);
    trace(job, &memory);
}

void simd_tile(const detail::TileJob& job) {
    if (job.lamps != nullptr) lit_tile(job, simd_tile_in);
    else simd_tile_in(job, nullptr);
}

void packet_tile(const detail::TileJob& job) {
    if (job.lamps != nullptr) lit_tile(job, packet_tile_in);
    else packet_tile_in(job, nullptr);
}

/// The whole tile as if its first ray's face filled it.
void fill_tile(const detail::TileJob& job) {
    const CameraFrame& camera = *job.camera;
    const Vec3f d = camera.direction(static_cast<float>(job.x0) + 0.5f, static_cast<float>(job.y0) + 0.5f);
    NoEvents events;
    Vec3f throughput = {1, 1, 1};
    const WalkEnd<float> end =
        walk(*job.scene, make_ray_unchecked(camera.origin, d), job.start_cell, NoLimit{}, throughput, events);
    Layers layers;
    layers.layer[layers.count++] = {false, 1, -normal_of(*job.scene, end),
                                    colour_of(*job.scene, source_face_of(*job.scene, end.target))};
    fill(Canvas(job), {job.x0, job.y0, job.x1, job.y1}, layers);
}

/// In furnished rooms rays are asked about objects one by one: strangers share no way through them.
void nearest(const detail::StreamJob& job) {
    if (job.objects != nullptr) return detail::kernels().nearest(job);
    counted(job, [&](auto& events) HWY_ATTR { nearest_rays(job, events); });
}

/// Walls first, for all; what they let pass is asked about objects.
void visible(const detail::SegmentJob& job) {
    detail::SegmentJob bare = job;
    bare.objects = nullptr;
    counted(bare, [&](auto& events) HWY_ATTR { visible_segments(bare, events); });
    if (job.objects == nullptr) return;
    detail::SegmentJob furnished = job;
    furnished.stats = nullptr;  // these walks were counted
    Alone<detail::SegmentJob> passing(furnished, detail::kernels().visible);
    const Columns columns = {job.order};
    for (std::uint64_t k = job.begin; k < job.end; ++k)
        if (const std::uint64_t ray = columns.ray_at(k); job.visible[ray] != 0) passing.add(ray);
    passing.flush();
}

const detail::LaneKernels* kernel_set() {
    static const detail::LaneKernels kernels = {
        hwy::TargetName(HWY_TARGET), lane_count, simd_tile, packet_tile, fill_tile, nearest, visible};
    return &kernels;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();

#endif

#if HWY_ONCE
namespace enfilade::render {

HWY_EXPORT(kernel_set);

const detail::LaneKernels* detail::lane_kernels() { return HWY_DYNAMIC_DISPATCH(kernel_set)(); }

}  // namespace enfilade::render
#endif
