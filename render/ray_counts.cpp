#include "render/ray_counts.h"

#include <cmath>
#include <limits>
#include <memory>

#include "accel/locate.h"
#include "base/error.h"
#include "render/executor.h"
#include "render/trace_rays.h"

namespace enfilade::render {
namespace {

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

}  // namespace

PixelNumbers count_by_pixel(const accel::SceneView& scene, const Camera& camera, RayCount count,
                            std::optional<double> cut_z, const accel::Executor* executor) {
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
            RayStats stats;
            RayHit hit;
            trace_rays(scene, {&*ray, 1}, {&hit, 1}, Precision::Float, &stats);
            numbers.of_pixel[row * width + column] =
                static_cast<float>(count == RayCount::Cells ? stats.cells : stats.side_tests);
        }
    });
    return numbers;
}

}  // namespace enfilade::render
