#include "render/path_trace.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/error.h"
#include "render/executor.h"
#include "render/kernel.h"
#include "render/path_film.h"

namespace enfilade::render {
namespace {

constexpr int most_bounces_allowed = 1000;

void refuse(const char* sentence) { throw InputError("R4", "", sentence); }

void validate(const PathOptions& o) {
    if (o.samples_per_pixel < 1 || o.samples_per_pixel > 1 << 24) refuse("a pixel takes 1 to 16777216 samples");
    if (o.most_bounces < 0 || o.most_bounces > most_bounces_allowed) refuse("a path takes 0 to 1000 bounces");
    if (o.lamps_per_bounce < 0) refuse("the number of lamps drawn at each bounce is 0 (all) or more");
    if (o.samples_per_pass < 0) refuse("a pass takes 0 (as many as there were before) or more samples a pixel");
    if (!(o.noise >= 0)) refuse("the noise at which a picture is good enough is 0 (never) or more");
    if (!(o.exposure > 0) || !(o.sky >= 0) || !(o.sun >= 0)) refuse("exposure is above 0, sky and sun are not below");
    if (!(o.clamp >= 0)) refuse("light is clamped at 0 (never) or more");
    if (!(o.sun_radius_deg >= 0 && o.sun_radius_deg < 90)) refuse("the sun's radius is 0 up to 90 degrees");
    if (!(o.mirror_floor >= 0 && o.mirror_floor <= 1)) refuse("a floor mirrors a share of the light between 0 and 1");
}

/// The cell that holds the whole ball of a lamp, or none: the walk to a place on it then knows where it leads.
std::uint32_t cell_of_ball(const accel::SceneView& scene, const accel::Light& light) {
    constexpr std::uint32_t none_of_them = 0xffffffffu;
    if (light.cell == none<accel::CellId>) return none_of_them;
    const accel::Cell& cell = scene.cells[index(light.cell)];
    const double x = light.position[0], y = light.position[1], z = light.position[2], r = light.radius;
    if (z - r < double{cell.z_floor} || z + r > double{cell.z_ceiling}) return none_of_them;
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t p = cell.first_section + i, q = cell.first_section + (i + 1u) % cell.section_count;
        const double ex = double{scene.section_x[q]} - double{scene.section_x[p]};
        const double ey = double{scene.section_y[q]} - double{scene.section_y[p]};
        const double inside = ex * (y - double{scene.section_y[p]}) - ey * (x - double{scene.section_x[p]});
        if (inside < r * std::hypot(ex, ey)) return none_of_them;
    }
    return static_cast<std::uint32_t>(light.cell);
}

/// What a picture or places need besides the scene, made once.
class Preparation {
public:
    Preparation(const accel::SceneView& scene, const PathOptions& options) : scene_(scene) {
        validate(options);
        if (options.executor == nullptr) all_cores_ = make_executor();
        executor_ = options.executor != nullptr ? options.executor : all_cores_.get();
        prepare_objects(options);
        if (options.lamps && !scene.lights.empty()) prepare_lamps(options);
        light_.lamps_a_bounce = static_cast<std::uint32_t>(options.lamps_per_bounce);
        light_.look = options.look;
        light_.look.sky_zenith = options.sky * options.look.sky_zenith;
        light_.look.sky_horizon = options.sky * options.look.sky_horizon;
        light_.look.sun = options.sun * options.look.sun;
        light_.sun_height = static_cast<float>(1 - std::cos(options.sun_radius_deg * 3.14159265358979323846 / 180));
        light_.most_bounces = static_cast<std::uint32_t>(options.most_bounces);
        light_.clamp = options.clamp;
        light_.mirror_floor = options.mirror_floor;
        light_.seed = static_cast<std::uint32_t>(options.seed ^ options.seed >> 32);
    }
    Preparation(const Preparation&) = delete;
    Preparation& operator=(const Preparation&) = delete;

    [[nodiscard]] const accel::Executor& executor() const { return *executor_; }
    [[nodiscard]] detail::PathJob job() const {
        detail::PathJob job = {};
        job.scene = &scene_;
        job.light = &light_;
        job.objects = scene_.has_objects() ? &objects_ : nullptr;
        return job;
    }

private:
    void prepare_objects(const PathOptions& options) {
        if (!scene_.has_objects()) return;
        if (options.objects == nullptr)
            own_objects_ = build_object_accel(scene_, ObjectAccelKind::Automatic, *executor_);
        objects_ = options.objects != nullptr ? *options.objects : own_objects_->tracer();
    }
    void prepare_lamps(const PathOptions& options) {
        if (options.search != LampSearch::Naive && !options.trees)
            own_trees_ = accel::build_light_trees(scene_, {.trees = options.search == LampSearch::Tree, .balls = true},
                                                  *executor_);
        lamps_ = {options.trees ? *options.trees : own_trees_.view(), options.search, options.exposure};
        for (const accel::Light& light : scene_.lights) ball_cells_.push_back(cell_of_ball(scene_, light));
        light_.lamps = &lamps_;
        light_.ball_cells = ball_cells_.data();
    }

    const accel::SceneView& scene_;
    std::unique_ptr<accel::Executor> all_cores_;
    const accel::Executor* executor_ = nullptr;
    std::unique_ptr<ObjectAccel> own_objects_;
    ObjectTracer objects_;
    accel::LightTrees own_trees_;
    Lamps lamps_;
    std::vector<std::uint32_t> ball_cells_;
    detail::PathLight light_ = {};
};

int rounded_samples(int samples) {
    const int sequences = static_cast<int>(path_sequences);
    return (samples + sequences - 1) / sequences * sequences;
}

/// Chunks of work with statistics of their own.
void run_counted(const accel::Executor& executor, std::size_t count, RayStats* stats,
                 const std::function<void(std::size_t, RayStats*)>& body) {
    std::vector<RayStats> of_chunk(stats != nullptr ? count : 0);
    executor.run(count, [&](std::size_t i) { body(i, stats != nullptr ? &of_chunk[i] : nullptr); });
    for (const RayStats& one : of_chunk) stats->add(one);
}

/// How many samples there are after the pass that begins with `done`.
int pass_end(int done, int wanted, const PathOptions& options) {
    const int doubled = done == 0 ? 8 : 2 * done;
    return std::min(options.samples_per_pass > 0 ? done + rounded_samples(options.samples_per_pass) : doubled, wanted);
}

}  // namespace

PathResult trace_paths(const accel::SceneView& scene, const Camera& camera, const PathOptions& options) {
    const Preparation prepared(scene, options);
    const CameraFrame frame = make_frame(camera);
    detail::PathJob all = prepared.job();
    all.camera = &frame;
    all.width = camera.width;
    all.is_cut = options.cut_z.has_value();
    if (all.is_cut) {
        all.cut_z = static_cast<float>(*options.cut_z);
        if (!(frame.origin.z > all.cut_z))
            throw InputError("R3", "", "the camera stands below the height at which the building is cut; move it up");
    } else {
        all.start_cell = static_cast<std::uint32_t>(options.start ? *options.start : start_cell(scene, frame));
    }
    detail::PathFilm film(camera.width, camera.height);
    all.sums = film.sums();
    const int wanted = rounded_samples(options.samples_per_pixel);
    std::vector<std::size_t> tiles = film.all_tiles();
    for (int done = 0; done < wanted && !tiles.empty();) {
        const int stop = pass_end(done, wanted, options);
        run_counted(prepared.executor(), tiles.size(), options.stats, [&](std::size_t i, RayStats* stats) {
            detail::PathJob job = all;
            const detail::FilmTile at = film.tile(tiles[i]);
            job.x0 = at.x0;
            job.y0 = at.y0;
            job.x1 = at.x1;
            job.y1 = at.y1;
            job.begin = static_cast<std::uint32_t>(done);
            job.end = static_cast<std::uint32_t>(stop);
            job.stats = stats;
            detail::kernels().path_tile(job);
            film.set_samples(tiles[i], stop);
        });
        done = stop;
        if (options.noise > 0 && done >= 16)
            std::erase_if(tiles, [&](std::size_t tile) { return film.noise(tile) < options.noise; });
        if (options.progress && !options.progress({done, wanted, film.noise().typical, film.share_without(tiles)}))
            break;
    }
    return film.result();
}

std::vector<PlaceLight> measure_light(const accel::SceneView& scene, const LitPlaces& places,
                                      const PathOptions& options) {
    const Preparation prepared(scene, options);
    const std::size_t count = std::min({places.points.size(), places.normals.size(), places.cells.size()});
    std::vector<detail::PathSum> sums(count);
    detail::PathJob all = prepared.job();
    all.points = places.points.data();
    all.normals = places.normals.data();
    all.cells = places.cells.data();
    all.sums = sums.data();
    const int samples = rounded_samples(options.samples_per_pixel);
    all.end = static_cast<std::uint32_t>(samples);
    constexpr std::size_t grain = 64;
    run_counted(prepared.executor(), (count + grain - 1) / grain, options.stats, [&](std::size_t i, RayStats* stats) {
        detail::PathJob job = all;
        job.first_place = static_cast<std::uint32_t>(i * grain);
        job.end_place = static_cast<std::uint32_t>(std::min(count, (i + 1) * grain));
        job.stats = stats;
        detail::kernels().path_places(job);
    });
    const double lux = 3.14159265358979323846 / double{options.exposure};
    std::vector<PlaceLight> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double n = samples;
        result[i].lux = {lux * sums[i].rgb[0] / n, lux * sums[i].rgb[1] / n, lux * sums[i].rgb[2] / n};
        result[i].standard_error = lux * detail::standard_error(sums[i], samples);
    }
    return result;
}

Image under_shoulder(Image image, float shoulder) {
    const float room = 1 - shoulder;
    for (float& value : image.rgb) {
        const float over = value - shoulder;
        if (over > 0 && room > 0) value = shoulder + room * over / (over + room);
    }
    return image;
}

}  // namespace enfilade::render
