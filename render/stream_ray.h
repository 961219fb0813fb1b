#pragma once
// One ray and one segment of a stream (kernel.h), for the loops of every instruction set and for kernels.

#include "render/kernel.h"
#include "render/rooms.h"
#include "render/sees.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// How far ray i of a stream may go: metres.
ENFILADE_HD float reach_of(const detail::StreamJob& job, std::uint64_t i) {
    return job.max_distance != nullptr ? job.max_distance[i] : 3e38f;
}

/// Ray i; false where it is none.
ENFILADE_HD bool ray_of(const detail::StreamJob& job, std::uint64_t i, float max_distance, Ray<float>& ray) {
    return make_ray(Vec3f{job.origin[0][i], job.origin[1][i], job.origin[2][i]},
                    Vec3f{job.direction[0][i], job.direction[1][i], job.direction[2][i]}, ray) &&
           max_distance == max_distance;
}

/// Writes what became of ray i to the columns that are wanted.
ENFILADE_HD void write_answer(const detail::StreamJob& job, std::uint64_t i, const Sight<float>& sight,
                              float distance) {
    const WalkEnd<float>& end = sight.end;
    const bool is_object = end.status == WalkStatus::Object;
    if (job.distance != nullptr) job.distance[i] = distance;
    if (job.source_face != nullptr)
        job.source_face[i] = static_cast<accel::SourceFaceId>(end.status == WalkStatus::Hit ? end.target.bits : ~0u);
    if (job.cell != nullptr) job.cell[i] = static_cast<accel::CellId>(end.cell);
    if (job.status != nullptr) job.status[i] = end.status;
    if (job.object != nullptr) job.object[i] = static_cast<accel::ObjectId>(is_object ? sight.hit.object : no_object);
    if (job.triangle != nullptr) job.triangle[i] = is_object ? sight.hit.triangle : no_triangle;
}

/// Of a ray that is none.
ENFILADE_HD void write_refusal(const detail::StreamJob& job, std::uint64_t i) {
    Sight<float> sight = {};
    sight.end.status = WalkStatus::Refused;
    sight.end.cell = static_cast<std::uint32_t>(job.start[i]);
    write_answer(job, i, sight, float_of(0x7fc00000u));
}

template <class Scene, class Rooms, class Events>
ENFILADE_HD void answer_ray(const Scene& scene, const Rooms& rooms, const detail::StreamJob& job, std::uint64_t i,
                            Events& events) {
    const float max_distance = reach_of(job, i);
    Ray<float> ray;
    if (!ray_of(job, i, max_distance, ray)) return write_refusal(job, i);
    const auto cell = static_cast<std::uint32_t>(job.start[i]);
    const float metres = length(ray.direction);
    NoThroughput throughput;
    const Sight<float> sight =
        job.max_distance != nullptr
            ? rooms.look_along(scene, ray, cell, Limit<float>{limit_of(max_distance, metres)}, throughput, events)
            : rooms.look_along(scene, ray, cell, NoLimit{}, throughput, events);
    write_answer(job, i, sight,
                 sight.end.status == WalkStatus::Reached ? max_distance : parameter(scene, ray, sight) * metres);
}

template <class Scene, class Rooms, class Events>
ENFILADE_HD void answer_segment(const Scene& scene, const Rooms& rooms, const detail::SegmentJob& job, std::uint64_t i,
                                Events& events) {
    const std::uint32_t to_cell = job.to_cell != nullptr ? static_cast<std::uint32_t>(job.to_cell[i]) : no_cell;
    job.visible[i] = static_cast<std::uint8_t>(sees(scene, rooms, Vec3f{job.from[0][i], job.from[1][i], job.from[2][i]},
                                                    Vec3f{job.to[0][i], job.to[1][i], job.to[2][i]},
                                                    static_cast<std::uint32_t>(job.from_cell[i]), to_cell, events));
}

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
