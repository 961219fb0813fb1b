#include "render/trace.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "render/executor.h"
#include "render/kernel.h"
#include "render/picture_setup.h"

namespace enfilade::render {
namespace {

constexpr int tile_side = 64;

/// One job a tile of the picture, each with statistics of its own.
template <class Picture>
void run_tiles(const accel::Executor& executor, const Picture& picture, const detail::TileJob& all,
               void (*kernel)(const detail::TileJob&), RayStats* stats) {
    const int side = std::max(tile_side, all.packets.largest);
    const int columns = (picture.width + side - 1) / side;
    const int rows = (picture.height + side - 1) / side;
    const std::size_t tile_count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    std::vector<RayStats> of_tile(stats != nullptr ? tile_count : 0);
    executor.run(tile_count, [&](std::size_t tile) {
        detail::TileJob job = all;
        job.x0 = static_cast<int>(tile % static_cast<std::size_t>(columns)) * side;
        job.y0 = static_cast<int>(tile / static_cast<std::size_t>(columns)) * side;
        job.x1 = std::min(job.x0 + side, picture.width);
        job.y1 = std::min(job.y0 + side, picture.height);
        if (stats != nullptr) job.stats = &of_tile[tile];
        kernel(job);
    });
    for (const RayStats& one : of_tile) stats->add(one);
}

void refuse(const char* sentence) { throw InputError("R4", "", sentence); }

bool is_power_of_two(int value) { return value > 0 && (value & (value - 1)) == 0; }

void validate(const TraceOptions& options) {
    const PacketSizes& sizes = options.packets;
    if (!is_power_of_two(sizes.largest) || !is_power_of_two(sizes.smallest) || sizes.largest < 16 ||
        sizes.largest > 256 || sizes.smallest < 4 || sizes.smallest > sizes.largest)
        refuse("packets are powers of two: the largest 16 to 256 pixels a side, the smallest from 4 up to that");
    if (options.precision == Precision::Double && options.tracer != Tracer::Scalar)
        refuse("only the scalar tracer walks in double precision");
}

/// Whether lanes know all that lights a picture: not materials that are more than a colour, nor objects that trees know
/// nothing of.
bool suits_lanes(const detail::TileJob& job) {
    if (job.lamps == nullptr) return true;
    const bool asks_trees = job.lamps->search == LampSearch::Tree && job.objects != nullptr;
    return !job.scene->has_looks() && (!asks_trees || job.lamps->trees.beam_object_lists.count != 0);
}

/// Lambert's loop of a tracer; the scalar one where there are no lanes, or what they know nothing of.
auto lambert_kernel(Tracer tracer, const detail::TileJob& job) {
    const detail::LaneKernels* lanes = detail::lane_kernels();
    if (tracer == Tracer::Scalar || lanes == nullptr || !suits_lanes(job)) return detail::kernels().lambert_tile;
    return tracer == Tracer::Simd ? lanes->simd_tile : lanes->packet_tile;
}

}  // namespace

Image trace(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options) {
    validate(options);
    const detail::PictureSetup setup = detail::set_up(scene, camera, options);
    detail::TileJob job = {};
    job.scene = &setup.scene;
    job.camera = &setup.frame;
    job.look = &setup.look;
    job.samples_a_side = setup.samples_a_side;
    job.start_cell = setup.start_cell;
    job.is_cut = setup.is_cut;
    job.cut_z = setup.cut_z;
    job.mirror_floor = options.mirror_floor;
    job.packets = options.packets;
    job.is_double = options.precision == Precision::Double;
    Image image(camera.width, camera.height);
    job.rgb = image.rgb.data();
    job.width = camera.width;
    const std::unique_ptr<accel::Executor> all_cores = options.executor == nullptr ? make_executor() : nullptr;
    const accel::Executor& executor = options.executor != nullptr ? *options.executor : *all_cores;
    std::unique_ptr<ObjectAccel> own_accel;
    ObjectTracer objects;
    if (scene.has_objects()) {
        if (options.objects == nullptr) own_accel = build_object_accel(scene, ObjectAccelKind::Automatic, executor);
        objects = options.objects != nullptr ? *options.objects : own_accel->tracer();
        job.objects = &objects;
    }
    accel::LightTrees own_trees;
    Lamps lamps;
    if (options.lamps) {
        lamps = detail::prepared(scene, *options.lamps, executor, own_trees);
        job.lamps = &lamps;
    }
    run_tiles(executor, camera, job, setup.is_plain ? lambert_kernel(options.tracer, job) : detail::kernels().look_tile,
              options.stats);
    return image;
}

void trace_lambert(const accel::SceneView& scene, const CameraFrame& frame, accel::CellId start,
                   const LambertOptions& options, const accel::Executor& executor, Framebuffer& framebuffer) {
    const Look look = lambert_look({});
    accel::SceneView plain_scene = scene;
    plain_scene.material_looks = {};
    detail::TileJob job = {};
    job.scene = &plain_scene;
    job.camera = &frame;
    job.look = &look;
    job.rgba = framebuffer.rgba.data();
    job.width = framebuffer.width;
    job.objects = scene.has_objects() ? options.objects : nullptr;
    job.samples_a_side = 1;
    job.start_cell = static_cast<std::uint32_t>(start);
    job.mirror_floor = options.mirror_floor;
    job.packets = options.packets;
    job.lamps = options.lamps;
    run_tiles(executor, framebuffer, job, lambert_kernel(options.tracer, job), options.stats);
}

}  // namespace enfilade::render
