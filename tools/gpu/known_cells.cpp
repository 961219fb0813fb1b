#include "tools/gpu/known_cells.h"

#include "render/trace_rays.h"

namespace enfilade::tools::gpu {

std::vector<std::uint32_t> known_cells(const accel::SceneView& scene, const TriedView& view, int side,
                                       const render::ObjectTracer* objects, const accel::Executor& executor) {
    const render::CameraFrame frame = view.frame(side);
    const auto width = static_cast<std::size_t>(side);
    std::vector<std::uint32_t> cells(width * width);
    accel::parallel_for(executor, cells.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const render::Vec3f along =
                frame.direction(static_cast<float>(i % width) + 0.5f, static_cast<float>(i / width) + 0.5f);
            const render::RayHit hit =
                trace_ray(scene, {render::vec_cast<double>(frame.origin), render::vec_cast<double>(along), view.start},
                          render::Precision::Float, objects);
            cells[i] = static_cast<std::uint32_t>(hit.cell);
        }
    });
    return cells;
}

}  // namespace enfilade::tools::gpu
