#include "render/trace.h"

#include <cmath>
#include <vector>

#include "base/error.h"
#include "render/executor.h"
#include "render/kernel.h"

namespace enfilade::render {
namespace {

constexpr int tile_side = 32;

template <class Body>
void for_each_tile(const accel::Executor& executor, const Image& image, const Body& body) {
    const int columns = (image.width + tile_side - 1) / tile_side;
    const int rows = (image.height + tile_side - 1) / tile_side;
    executor.run(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), [&](std::size_t tile) {
        const int x0 = static_cast<int>(tile % static_cast<std::size_t>(columns)) * tile_side;
        const int y0 = static_cast<int>(tile / static_cast<std::size_t>(columns)) * tile_side;
        body(tile, x0, y0, std::min(x0 + tile_side, image.width), std::min(y0 + tile_side, image.height));
    });
}

void run_tiles(const accel::Executor& executor, Image& image, const detail::TileJob& all,
               void (*kernel)(const detail::TileJob&), RayStats* stats) {
    const std::size_t tile_count = static_cast<std::size_t>((image.width + tile_side - 1) / tile_side) *
                                   static_cast<std::size_t>((image.height + tile_side - 1) / tile_side);
    std::vector<RayStats> of_tile(stats != nullptr ? tile_count : 0);
    for_each_tile(executor, image, [&](std::size_t tile, int x0, int y0, int x1, int y1) {
        detail::TileJob job = all;
        job.x0 = x0;
        job.y0 = y0;
        job.x1 = x1;
        job.y1 = y1;
        if (stats != nullptr) job.stats = &of_tile[tile];
        kernel(job);
    });
    for (const RayStats& one : of_tile) stats->add(one);
}

}  // namespace

Image trace(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options) {
    const CameraFrame frame = make_frame(camera);
    detail::TileJob job = {};
    job.scene = &scene;
    job.camera = &frame;
    job.look = &options.look;
    job.samples_a_side = std::max(1, static_cast<int>(std::ceil(std::sqrt(std::max(1, options.samples_per_pixel)))));
    job.is_cut = options.cut_z.has_value();
    if (job.is_cut) {
        job.cut_z = static_cast<float>(*options.cut_z);
        if (!(frame.origin.z > job.cut_z))
            throw InputError("R3", "", "the camera stands below the height at which the building is cut; move it up");
    } else {
        job.start_cell = static_cast<std::uint32_t>(start_cell(scene, frame));
    }
    Image image(camera.width, camera.height);
    job.rgb = image.rgb.data();
    job.width = camera.width;
    const std::unique_ptr<accel::Executor> all_cores = options.executor == nullptr ? make_executor() : nullptr;
    const accel::Executor& executor = options.executor != nullptr ? *options.executor : *all_cores;
    const bool is_plain = options.shading == Shading::Lambert && !job.is_cut && job.samples_a_side == 1;
    Look plain_look;
    if (options.shading == Shading::Lambert && !is_plain) {
        plain_look = lambert_look(options.look);
        job.look = &plain_look;
    }
    run_tiles(executor, image, job, is_plain ? detail::kernels().lambert_tile : detail::kernels().look_tile,
              options.stats);
    return image;
}

void trace_lambert(const accel::SceneView& scene, const CameraFrame& frame, accel::CellId start,
                   const accel::Executor& executor, Image& image) {
    const Look look;
    detail::TileJob job = {};
    job.scene = &scene;
    job.camera = &frame;
    job.look = &look;
    job.rgb = image.rgb.data();
    job.width = image.width;
    job.samples_a_side = 1;
    job.start_cell = static_cast<std::uint32_t>(start);
    run_tiles(executor, image, job, detail::kernels().lambert_tile, nullptr);
}

}  // namespace enfilade::render
