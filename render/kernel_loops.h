// The loops over rays. Included by one file for each instruction set, which names its namespace (isa.h); no include
// guard is needed, and no standard container may appear here.

#include "render/block_loops.h"
#include "render/block_streams.h"
#include "render/kernel.h"
#include "render/lambert.h"
#include "render/lit_pixel.h"
#include "render/path_loops.h"
#include "render/ray_loops.h"
#include "render/rooms.h"
#include "render/shade.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

template <class T, class Rooms, class Events>
void lambert_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const LambertPicture picture = {&scene, &camera, job.look, job.start_cell, job.mirror_floor};
    for (int y = job.y0; y < job.y1; ++y)
        for (int x = job.x0; x < job.x1; ++x) store(job, x, y, lambert_pixel<T>(picture, rooms, x, y, events));
}

template <class T, class Rooms, class Events>
void lit_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const LitPicture picture = {&scene, &camera, job.look, job.lamps, job.start_cell, job.mirror_floor};
    for (int y = job.y0; y < job.y1; ++y)
        for (int x = job.x0; x < job.x1; ++x) store(job, x, y, lit_pixel<T>(picture, rooms, x, y, events));
}

template <class Job, class Body>
void counted(const Job& job, const Body& body) {
    NoEvents none;
    if (job.stats != nullptr) body(*job.stats);
    else body(none);
}

/// body(rooms, events), for what the job is to meet and whether that is counted.
template <class Job, class Body>
void traced(const Job& job, const Body& body) {
    among(job, [&](const auto& rooms) { counted(job, [&](auto& events) { body(rooms, events); }); });
}

/// Blocks of rays walk faces alone, in float, and count nothing.
template <class Job>
bool suits_blocks(const Job& job) {
    return job.stats == nullptr && (job.objects == nullptr || !job.scene->has_objects());
}

void look_tile(const detail::TileJob& job) {
    traced(job, [&](const auto& rooms, auto& events) {
        if (job.is_double) look_rows<double>(job, rooms, events);
        else look_rows<float>(job, rooms, events);
    });
}

void lit_tile(const detail::TileJob& job) {
    if (job.scene->has_looks()) return look_tile(job);
    traced(job, [&](const auto& rooms, auto& events) {
        if (job.is_double) lit_rows<double>(job, rooms, events);
        else lit_rows<float>(job, rooms, events);
    });
}

void lambert_tile(const detail::TileJob& job) {
    if (job.lamps != nullptr) return lit_tile(job);
#if ENFILADE_WIDE_SIDES
    if (suits_blocks(job) && !job.is_double) return lambert_blocks(job);
#endif
    traced(job, [&](const auto& rooms, auto& events) {
        if (job.is_double) lambert_rows<double>(job, rooms, events);
        else lambert_rows<float>(job, rooms, events);
    });
}

void path_tile(const detail::PathJob& job) {
    traced(job, [&](const auto& rooms, auto& events) { path_rows(job, rooms, events); });
}

void path_places(const detail::PathJob& job) {
    traced(job, [&](const auto& rooms, auto& events) { path_each_place(job, rooms, events); });
}

void rays_float(const detail::RayJob& job) {
    traced(job, [&](const auto& rooms, auto& events) { trace_each<float>(job, rooms, events); });
}

void rays_double(const detail::RayJob& job) {
    traced(job, [&](const auto& rooms, auto& events) { trace_each<double>(job, rooms, events); });
}

void nearest(const detail::StreamJob& job) {
#if ENFILADE_WIDE_SIDES
    if (suits_blocks(job)) return nearest_blocks(job);
#endif
    traced(job, [&](const auto& rooms, auto& events) { trace_stream(job, rooms, events); });
}

void visible(const detail::SegmentJob& job) {
#if ENFILADE_WIDE_SIDES
    if (suits_blocks(job)) return visible_blocks(job);
#endif
    traced(job, [&](const auto& rooms, auto& events) { trace_segments(job, rooms, events); });
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
