#include "render/ray_stream.h"

#include <algorithm>
#include <vector>

#include "render/kernel.h"

namespace enfilade::render {
namespace {

/// Rays a task. It begins with empty queues of cells (lanes/queue-inl.h) and serves them half full at its end, so few
/// large tasks cost less; where rays come in any order more of them are needed to fill the queues. From the number of
/// rays alone: what is counted does not depend on who runs it.
std::size_t rays_a_task(std::size_t count, StreamOrder order) {
    constexpr std::size_t least = 1 << 13, most = 1 << 16;
    const std::size_t tasks = order == StreamOrder::Any ? 16 : 64;
    return std::clamp(count / tasks, least, most);
}

/// Calls `kernel` for chunks of the job, each with its statistics.
template <class Job>
void run_chunks(const Job& all, std::size_t count, const StreamOptions& options, void (*kernel)(const Job&)) {
    const std::size_t chunk_rays = rays_a_task(count, options.order);
    std::vector<RayStats> of_chunk(options.stats != nullptr ? (count + chunk_rays - 1) / chunk_rays : 0);
    const accel::SerialExecutor serial;
    const accel::Executor& executor = options.executor != nullptr ? *options.executor : serial;
    accel::parallel_for(executor, count, chunk_rays, [&](std::size_t begin, std::size_t end) {
        Job job = all;
        job.begin = begin;
        job.end = end;
        if (options.stats != nullptr) job.stats = &of_chunk[begin / chunk_rays];
        kernel(job);
    });
    for (const RayStats& one : of_chunk) options.stats->add(one);
}

template <class T>
T* data_or_null(std::span<T> column) {
    return column.empty() ? nullptr : column.data();
}

}  // namespace

void nearest(const accel::SceneView& scene, const RayColumns& rays, const HitColumns& hits,
             const StreamOptions& options) {
    detail::StreamJob job = {};
    job.scene = &scene;
    job.origin[0] = rays.origin_x.data();
    job.origin[1] = rays.origin_y.data();
    job.origin[2] = rays.origin_z.data();
    job.direction[0] = rays.direction_x.data();
    job.direction[1] = rays.direction_y.data();
    job.direction[2] = rays.direction_z.data();
    job.start = rays.cell.data();
    job.max_distance = data_or_null(rays.max_distance);
    job.distance = data_or_null(hits.distance);
    job.source_face = data_or_null(hits.source_face);
    job.cell = data_or_null(hits.cell);
    job.status = data_or_null(hits.status);
    job.object = data_or_null(hits.object);
    job.triangle = data_or_null(hits.triangle);
    job.objects = scene.has_objects() ? options.objects : nullptr;
    const detail::LaneKernels* lanes = detail::lane_kernels();
    const bool is_scalar = options.tracer == Tracer::Scalar || lanes == nullptr;
    run_chunks(job, rays.cell.size(), options, is_scalar ? detail::kernels().nearest : lanes->nearest);
}

void visible(const accel::SceneView& scene, const SegmentColumns& segments, std::span<std::uint8_t> visible,
             const StreamOptions& options) {
    detail::SegmentJob job = {};
    job.scene = &scene;
    job.from[0] = segments.from_x.data();
    job.from[1] = segments.from_y.data();
    job.from[2] = segments.from_z.data();
    job.to[0] = segments.to_x.data();
    job.to[1] = segments.to_y.data();
    job.to[2] = segments.to_z.data();
    job.from_cell = segments.from_cell.data();
    job.to_cell = data_or_null(segments.to_cell);
    job.visible = visible.data();
    job.objects = scene.has_objects() ? options.objects : nullptr;
    const detail::LaneKernels* lanes = detail::lane_kernels();
    const bool is_scalar = options.tracer == Tracer::Scalar || lanes == nullptr;
    run_chunks(job, segments.from_cell.size(), options, is_scalar ? detail::kernels().visible : lanes->visible);
}

}  // namespace enfilade::render
