#include "render/ray_counts.h"

#include <cmath>
#include <limits>
#include <memory>

#include "accel/locate.h"
#include "base/error.h"
#include "render/executor.h"
#include "render/object_walk.h"
#include "render/octree_counter.h"
#include "render/trace_rays.h"

namespace enfilade::render {
namespace {

/// Who is asked by a furnished walk, and how much that costs.
struct CountedOctrees {
    const OctreeCounter* octrees;
    OctreeWork* work;
};
void ask_nearest(const CountedOctrees& counted, accel::MeshId mesh, ObjectRay& ray) {
    counted.octrees->nearest_counted(mesh, ray, *counted.work);
}

/// The ray of a pixel, or of what is left of it below the cut.
std::optional<RayQuery> ray_of(const accel::SceneView& scene, Vec3f eye, Vec3f direction,
                               std::optional<accel::CellId> start, std::optional<double> cut_z) {
    if (start) return RayQuery{vec_cast<double>(eye), vec_cast<double>(direction), *start};
    const float z = static_cast<float>(*cut_z);
    if (!(direction.z < 0)) return std::nullopt;
    const float t = (z - eye.z) / direction.z;
    const Vec3d point = {eye.x + t * direction.x, eye.y + t * direction.y, z};
    const std::optional<accel::CellId> cell = accel::locate(scene, {point.x, point.y, point.z});
    if (!cell) return std::nullopt;
    return RayQuery{point, vec_cast<double>(direction), *cell};
}

std::uint64_t cell_count(const accel::SceneView& scene, const RayQuery& ray, RayCount count,
                         std::span<const std::uint32_t> of_cell) {
    RayStats stats;
    RayHit hit;
    trace_rays(scene, {&ray, 1}, {&hit, 1}, Precision::Float, &stats);
    if (count == RayCount::OfCell) return of_cell[index(hit.cell)];
    return count == RayCount::Cells ? stats.cells : stats.side_tests;
}

std::uint64_t octree_count(const accel::SceneView& scene, const OctreeCounter& octrees, const RayQuery& query,
                           RayCount count) {
    Ray<float> ray;
    if (!make_ray(vec_cast<float>(query.origin), vec_cast<float>(query.direction), ray)) return 0;
    OctreeWork work;
    NoEvents events;
    Vec3f throughput = {1, 1, 1};
    ObjectHit<float> hit;
    (void)walk_furnished(scene, CountedOctrees{&octrees, &work}, ray, static_cast<std::uint32_t>(query.cell), NoLimit{},
                         throughput, events, hit);
    return count == RayCount::Leaves ? work.leaves : work.blocks;
}

}  // namespace

PixelNumbers count_by_pixel(const accel::SceneView& scene, const Camera& camera, RayCount count,
                            std::optional<double> cut_z, const accel::Executor* executor, const OctreeCounter* octrees,
                            std::span<const std::uint32_t> of_cell) {
    const CameraFrame frame = make_frame(camera);
    if (cut_z && !(frame.origin.z > static_cast<float>(*cut_z)))
        throw InputError("R3", "", "the camera stands below the height at which the building is cut; move it up");
    const std::optional<accel::CellId> start =
        cut_z ? std::nullopt : std::optional<accel::CellId>(start_cell(scene, frame));
    PixelNumbers numbers{camera.width, camera.height, {}};
    const std::size_t width = static_cast<std::size_t>(camera.width);
    numbers.of_pixel.assign(width * static_cast<std::size_t>(camera.height), std::numeric_limits<float>::quiet_NaN());
    const std::unique_ptr<accel::Executor> all_cores = executor == nullptr ? make_executor() : nullptr;
    (executor != nullptr ? *executor : *all_cores).run(static_cast<std::size_t>(camera.height), [&](std::size_t row) {
        for (std::size_t column = 0; column < width; ++column) {
            const Vec3f direction = frame.direction(static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f);
            const std::optional<RayQuery> ray = ray_of(scene, frame.origin, direction, start, cut_z);
            if (!ray) continue;
            const bool counts_cells = count != RayCount::Leaves && count != RayCount::Blocks;
            const std::uint64_t counted = counts_cells ? cell_count(scene, *ray, count, of_cell)
                                          : octrees != nullptr && scene.has_objects()
                                              ? octree_count(scene, *octrees, *ray, count)
                                              : 0;
            numbers.of_pixel[row * width + column] = static_cast<float>(counted);
        }
    });
    return numbers;
}

}  // namespace enfilade::render
