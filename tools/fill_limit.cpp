#include "tools/fill_limit.h"

#include <algorithm>

#include "render/kernel.h"

namespace enfilade::tools {

bool has_fill_limit() { return render::detail::lane_kernels() != nullptr; }

void fill_limit(const accel::SceneView& scene, const PreparedView& view, const accel::Executor& executor,
                render::Framebuffer& image) {
    constexpr int side = 64;
    const int columns = (image.width + side - 1) / side, rows = (image.height + side - 1) / side;
    const render::Look look;
    const render::detail::LaneKernels& lanes = *render::detail::lane_kernels();
    executor.run(std::size_t(columns) * std::size_t(rows), [&](std::size_t tile) {
        render::detail::TileJob job = {};
        job.scene = &scene;
        job.camera = &view.frame;
        job.look = &look;
        job.rgba = image.rgba.data();
        job.width = image.width;
        job.samples_a_side = 1;
        job.start_cell = static_cast<std::uint32_t>(view.start);
        job.x0 = int(tile) % columns * side;
        job.y0 = int(tile) / columns * side;
        job.x1 = std::min(job.x0 + side, image.width);
        job.y1 = std::min(job.y0 + side, image.height);
        lanes.fill_tile(job);
    });
}

}  // namespace enfilade::tools
