// The loops over rays. Included by one file for each instruction set, which names its namespace (isa.h); no include
// guard is needed, and no standard container may appear here.

#include "render/block_loops.h"
#include "render/block_streams.h"
#include "render/kernel.h"
#include "render/mirror.h"
#include "render/path_loops.h"
#include "render/ray_loops.h"
#include "render/rooms.h"
#include "render/shade.h"
#include "render/walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// What a lamp at the eye shows of where a walk ended; throughput not yet counted.
template <class Rooms, class T>
Vec3f lambert_colour(const accel::SceneView& scene, const Look& look, const Ray<T>& ray, const Sight<T>& sight) {
    const WalkEnd<T>& end = sight.end;
    if constexpr (Rooms::are_furnished) {
        if (end.status == WalkStatus::Object)
            return headlight_cosine(ray, sight.hit) * object_colour(scene, sight.hit.object, sight.hit.triangle);
    }
    if (end.status != WalkStatus::Hit) return {1, 0, 1};  // a leak shows
    const accel::SourceFace& face = scene.source_faces[end.target.bits];
    return face.surface == accel::Surface::Sky ? sky_colour(look, vec_cast<float>(ray.direction))
                                               : headlight_cosine(scene, ray, end) * colour_of(scene, face);
}

/// What the mirror at which `ray` ended shows: the eye and its lamp have their images below it.
template <class Rooms, class T, class Events>
Vec3f lambert_in_mirror(const detail::TileJob& job, const accel::SceneView& scene, const Rooms& rooms,
                        const Ray<T>& ray, const WalkEnd<T>& end, Vec3f own, Events& events) {
    const Ray<T> image = mirrored(ray, T(scene.cells[end.cell].z_floor));
    Vec3f throughput = {1, 1, 1};
    const Sight<T> seen =
        rooms.look_along(scene, image, end.cell, NoLimit{}, throughput, events, parameter(scene, ray, end));
    return in_mirror(job.mirror_floor, own, throughput * lambert_colour<Rooms>(scene, *job.look, image, seen));
}

template <class T, class Rooms, class Events>
void lambert_rows(const detail::TileJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    const CameraFrame camera = *job.camera;
    const Look& look = *job.look;
    const Vec<T> eye = vec_cast<T>(camera.origin);
    for (int y = job.y0; y < job.y1; ++y) {
        for (int x = job.x0; x < job.x1; ++x) {
            const Vec3f direction = camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
            const Ray<T> ray = make_ray_unchecked(eye, vec_cast<T>(direction));
            Vec3f throughput = {1, 1, 1};
            const Sight<T> sight = rooms.look_along(scene, ray, job.start_cell, NoLimit{}, throughput, events);
            Vec3f colour = lambert_colour<Rooms>(scene, look, ray, sight);
            if (job.mirror_floor > 0 && is_mirror_hit(scene, sight.end))
                colour = lambert_in_mirror(job, scene, rooms, ray, sight.end, colour, events);
            store(job, x, y, throughput * colour);
        }
    }
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

void lambert_tile(const detail::TileJob& job) {
    if (job.lamps != nullptr) return look_tile(job);
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
