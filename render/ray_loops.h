#pragma once
// The loops over single rays, streams and segments. Included by loops alone, which are compiled once for each
// instruction set.

#include "render/kernel.h"
#include "render/rooms.h"
#include "render/sees.h"
#include "render/stream_ray.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

template <class T, class Rooms, class Events>
void trace_each(const detail::RayJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t i = 0; i < job.count; ++i) {
        const RayQuery& query = job.rays[i];
        RayHit& hit = job.hits[i];
        hit.throughput = {1, 1, 1};
        hit.cell = query.cell;
        hit.status = WalkStatus::Refused;
        hit.object = static_cast<accel::ObjectId>(no_object);
        hit.triangle = no_triangle;
        Ray<T> ray;
        if (!make_ray(vec_cast<T>(query.origin), vec_cast<T>(query.direction), ray) ||
            !(query.max_distance == query.max_distance))
            continue;
        const T metres = length(ray.direction);
        const T limit = static_cast<T>(query.max_distance) / metres;
        const bool is_limited = query.max_distance < 1e30;
        const auto cell = static_cast<std::uint32_t>(query.cell);
        const Sight<T> sight = is_limited ? rooms.look_along(scene, ray, cell, Limit<T>{limit}, hit.throughput, events)
                                          : rooms.look_along(scene, ray, cell, NoLimit{}, hit.throughput, events);
        const WalkEnd<T>& end = sight.end;
        hit.status = end.status;
        hit.source_face = static_cast<accel::SourceFaceId>(end.target.bits);
        hit.cell = static_cast<accel::CellId>(end.cell);
        hit.exit = end.exit;
        hit.section = end.section;
        hit.face = end.face;
        if (end.status == WalkStatus::Object) {
            hit.object = static_cast<accel::ObjectId>(sight.hit.object);
            hit.triangle = sight.hit.triangle;
        }
        hit.distance = end.status == WalkStatus::Reached ? query.max_distance
                                                         : static_cast<double>(parameter(scene, ray, sight) * metres);
    }
}

template <class Rooms, class Events>
void trace_stream(const detail::StreamJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; ++k)
        answer_ray(scene, rooms, job, job.order != nullptr ? job.order[k] : k, events);
}

template <class Rooms, class Events>
void trace_segments(const detail::SegmentJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; ++k)
        answer_segment(scene, rooms, job, job.order != nullptr ? job.order[k] : k, events);
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
