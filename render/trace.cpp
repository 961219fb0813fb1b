#include "render/trace.h"

#include <cmath>
#include <vector>

#include "base/error.h"
#include "render/executor.h"
#include "render/kernel.h"

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
    if (!(options.mirror_floor >= 0 && options.mirror_floor <= 1))
        refuse("a floor mirrors a share of the light between 0 and 1");
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

/// own: holds the trees where the caller brings none.
Lamps prepared(const accel::SceneView& scene, const LampOptions& options, const accel::Executor& executor,
               accel::LightTrees& own) {
    const bool needs_trees = options.search != LampSearch::Naive;
    if (needs_trees && !options.trees)
        own = accel::build_light_trees(scene, {.trees = options.search == LampSearch::Tree}, executor);
    return {options.trees ? *options.trees : own.view(), options.search, options.exposure};
}

}  // namespace

Image trace(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options) {
    validate(options);
    const CameraFrame frame = make_frame(camera);
    // A lamp at the eye alone shows plain colours, whoever traces, with any number of samples.
    accel::SceneView plain_scene = scene;
    if (options.shading == Shading::Lambert && !options.lamps) plain_scene.material_looks = {};
    detail::TileJob job = {};
    job.scene = &plain_scene;
    job.camera = &frame;
    job.look = &options.look;
    job.samples_a_side = std::max(1, static_cast<int>(std::ceil(std::sqrt(std::max(1, options.samples_per_pixel)))));
    job.mirror_floor = options.mirror_floor;
    job.packets = options.packets;
    job.is_double = options.precision == Precision::Double;
    job.is_cut = options.cut_z.has_value();
    if (job.is_cut) {
        job.cut_z = static_cast<float>(*options.cut_z);
        if (!(frame.origin.z > job.cut_z))
            throw InputError("R3", "", "the camera stands below the height at which the building is cut; move it up");
    } else {
        job.start_cell = static_cast<std::uint32_t>(options.start ? *options.start : start_cell(scene, frame));
    }
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
        lamps = prepared(scene, *options.lamps, executor, own_trees);
        job.lamps = &lamps;
    }
    const bool is_plain = options.shading == Shading::Lambert && !job.is_cut && job.samples_a_side == 1;
    Look plain_look;
    if (options.shading == Shading::Lambert && (!is_plain || job.lamps != nullptr)) {
        plain_look = lambert_look(options.look);
        job.look = &plain_look;
    }
    run_tiles(executor, camera, job, is_plain ? lambert_kernel(options.tracer, job) : detail::kernels().look_tile,
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
