#pragma once
// The loops over single rays, streams and segments. Included by loops alone, which are compiled once for each
// instruction set.

#include "render/kernel.h"
#include "render/rooms.h"
#include "render/sees.h"

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
    for (std::uint64_t k = job.begin; k < job.end; ++k) {
        const std::uint64_t i = job.order != nullptr ? job.order[k] : k;
        const float max_distance = job.max_distance != nullptr ? job.max_distance[i] : 3e38f;
        Sight<float> sight = {};
        WalkEnd<float>& end = sight.end;
        end.status = WalkStatus::Refused;
        end.cell = static_cast<std::uint32_t>(job.start[i]);
        float distance = __builtin_nanf("");
        Ray<float> ray;
        if (make_ray(Vec3f{job.origin[0][i], job.origin[1][i], job.origin[2][i]},
                     Vec3f{job.direction[0][i], job.direction[1][i], job.direction[2][i]}, ray) &&
            max_distance == max_distance) {
            const float metres = length(ray.direction);
            Vec3f throughput = {1, 1, 1};
            sight = job.max_distance != nullptr
                        ? rooms.look_along(scene, ray, end.cell, Limit<float>{limit_of(max_distance, metres)},
                                           throughput, events)
                        : rooms.look_along(scene, ray, end.cell, NoLimit{}, throughput, events);
            distance = end.status == WalkStatus::Reached ? max_distance : parameter(scene, ray, sight) * metres;
        }
        const bool is_object = end.status == WalkStatus::Object;
        if (job.distance != nullptr) job.distance[i] = distance;
        if (job.source_face != nullptr)
            job.source_face[i] =
                static_cast<accel::SourceFaceId>(end.status == WalkStatus::Hit ? end.target.bits : ~0u);
        if (job.cell != nullptr) job.cell[i] = static_cast<accel::CellId>(end.cell);
        if (job.status != nullptr) job.status[i] = end.status;
        if (job.object != nullptr)
            job.object[i] = static_cast<accel::ObjectId>(is_object ? sight.hit.object : no_object);
        if (job.triangle != nullptr) job.triangle[i] = is_object ? sight.hit.triangle : no_triangle;
    }
}

template <class Rooms, class Events>
void trace_segments(const detail::SegmentJob& job, const Rooms& rooms, Events& events) {
    const accel::SceneView scene = *job.scene;
    for (std::uint64_t k = job.begin; k < job.end; ++k) {
        const std::uint64_t i = job.order != nullptr ? job.order[k] : k;
        const std::uint32_t to_cell = job.to_cell != nullptr ? static_cast<std::uint32_t>(job.to_cell[i]) : no_cell;
        job.visible[i] = static_cast<std::uint8_t>(sees(scene, rooms, {job.from[0][i], job.from[1][i], job.from[2][i]},
                                                        {job.to[0][i], job.to[1][i], job.to[2][i]},
                                                        static_cast<std::uint32_t>(job.from_cell[i]), to_cell, events));
    }
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
