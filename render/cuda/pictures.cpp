#include "render/cuda/pictures.h"

#include <optional>

#include "base/error.h"
#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/picture_job.h"
#include "render/executor.h"
#include "render/picture_setup.h"

namespace enfilade::render::cuda {
namespace {

std::size_t pixels_of(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Starts the leanest kernel that knows all that the picture shows; whether it defers. is_plain: Lambert's shading of
/// one sample, uncut
bool start(Device& device, const PictureJob& job, bool is_plain) {
    if (job.is_double) {
        is_plain && !job.has_lamps ? start_lambert_in_double(device, job) : start_look_in_double(device, job);
        return false;
    }
    if (is_plain && !job.has_lamps) {
        start_lambert(device, job);
        return true;
    }
    if (is_plain && !job.scene.has_looks()) {
        start_lit(device, job);
        return true;
    }
    start_look(device, job);
    return false;
}

/// Whether corner rays of tiles know all that a frame shows.
bool suits_packets(const PictureJob& job) {
    if (job.is_double) return false;
    return !job.has_lamps || (job.lamps.search == LampSearch::Tree && job.objects == nullptr);
}

}  // namespace

struct Pictures::Parts {
    Device& device;
    PictureOptions options;
    std::unique_ptr<accel::Executor> own_cores;
    const accel::Executor& cores;
    accel::SceneView on_host;
    DeviceArrays arrays;
    accel::SceneView scene;  ///< on the device
    std::optional<DeviceObjects> objects;
    std::optional<accel::LightTreesView> trees;  ///< on the device
    bool have_beams = false;                     ///< else they tell which lamps a cell may see, no more
    int width = 0, height = 0;
    Buffer<std::uint32_t> image;
    Buffer<float> linear;
    Buffer<PictureCounters> counters;  ///< of this picture and of the next one
    std::size_t current = 0;           ///< which of them are this picture's
    Buffer<std::uint32_t> rare;
    FrameGraph graph;

    Parts(Device& device_, const accel::SceneView& scene_, const PictureOptions& options_)
        : device(device_),
          options(options_),
          own_cores(options.executor == nullptr ? make_executor() : nullptr),
          cores(options.executor != nullptr ? *options.executor : *own_cores),
          on_host(scene_),
          arrays(device_),
          scene(copy_scene(scene_, arrays)),
          counters(device_, 2),
          graph(device_) {
        counters.clear();
        if (options.has_objects && scene_.has_objects())
            objects.emplace(arrays, scene_, scene, options.inside, options.octrees, cores);
    }

    /// The scene's lamps with what finds out whether they are seen; uploads trees where they are not yet there.
    [[nodiscard]] Lamps lamps_of(const LampOptions& asked) {
        Lamps lamps = {{}, asked.search, asked.exposure};
        if (asked.search == LampSearch::Naive) return lamps;
        const bool needs_beams = asked.search == LampSearch::Tree;
        if (!trees || (needs_beams && !have_beams)) {
            accel::LightTrees own;
            trees = copy_trees(detail::prepared(on_host, asked, cores, own).trees, arrays);
            have_beams = needs_beams || asked.trees;
        }
        lamps.trees = *trees;
        return lamps;
    }

    /// What all pictures share.
    [[nodiscard]] PictureJob job_of(const CameraFrame& frame, std::uint32_t start_cell, int width_, int height_) {
        PictureJob job;
        job.scene = scene;
        job.camera = frame;
        job.start_cell = start_cell;
        job.objects = objects ? &*objects : nullptr;
        job.width = width_;
        job.height = height_;
        job.schedule = options.schedule;
        job.counters = counters.data() + current;
        job.next_counters = counters.data() + (1 - current);
        if (rare.size() < pixels_of(width_, height_)) rare = Buffer<std::uint32_t>(device, pixels_of(width_, height_));
        job.rare = rare.data();
        job.graph = options.schedule.start == FrameStart::Graph ? &graph : nullptr;
        return job;
    }

    /// Counters are 0 whenever a picture is asked for: a kernel that defers sees to it, without a piece of work more.
    void ask_for(const PictureJob& job, bool is_plain) {
        if (start(device, job, is_plain)) current = 1 - current;
        else counters.clear();
    }
};

Pictures::Pictures(Device& device, const accel::SceneView& scene, const PictureOptions& options)
    : parts_(std::make_unique<Parts>(device, scene, options)) {
    if (options.lamps) (void)parts_->lamps_of(*options.lamps);
}

Pictures::~Pictures() = default;

void Pictures::draw(const CameraFrame& frame, accel::CellId start_cell, int width, int height) {
    Parts& p = *parts_;
    const std::size_t pixels = pixels_of(width, height);
    if (p.image.size() < pixels) p.image = Buffer<std::uint32_t>(p.device, pixels);
    p.width = width;
    p.height = height;
    PictureJob job = p.job_of(frame, static_cast<std::uint32_t>(start_cell), width, height);
    job.scene.material_looks = {};
    job.look = lambert_look({});
    job.mirror_floor = p.options.mirror_floor;
    job.is_double = p.options.precision == Precision::Double;
    job.has_lamps = p.options.lamps.has_value();
    if (job.has_lamps) job.lamps = p.lamps_of(*p.options.lamps);
    job.rgba = p.image.data();
    if (!p.options.packets || !suits_packets(job)) return p.ask_for(job, true);
    draw_packets(p.device, {&job.scene, frame, job.look, start_cell, job.mirror_floor, width, height, job.rgba,
                            *p.options.packets, job.objects, job.has_lamps ? &job.lamps : nullptr});
}

const std::uint32_t* Pictures::image() const { return parts_->image.data(); }

void Pictures::read(Framebuffer& framebuffer) const {
    const Parts& p = *parts_;
    if (framebuffer.width != p.width || framebuffer.height != p.height) framebuffer = Framebuffer(p.width, p.height);
    p.device.wait();
    if (!framebuffer.rgba.empty())
        p.device.download(framebuffer.rgba.data(), p.image.data(), framebuffer.rgba.size() * sizeof(std::uint32_t));
}

Image Pictures::trace(const Camera& camera, const TraceOptions& options) {
    Parts& p = *parts_;
    if (options.stats != nullptr)
        throw InputError("R4", "", "rays are counted by tracers of the CPU alone; choose another --tracer");
    const detail::PictureSetup setup = detail::set_up(p.on_host, camera, options);
    const std::size_t pixels = pixels_of(camera.width, camera.height);
    if (p.linear.size() < 3 * pixels) p.linear = Buffer<float>(p.device, 3 * pixels);
    PictureJob job = p.job_of(setup.frame, setup.start_cell, camera.width, camera.height);
    if (!setup.scene.has_looks()) job.scene.material_looks = {};
    job.look = setup.look;
    job.samples_a_side = setup.samples_a_side;
    job.is_cut = setup.is_cut;
    job.cut_z = setup.cut_z;
    job.mirror_floor = options.mirror_floor;
    job.is_double = options.precision == Precision::Double;
    job.has_lamps = options.lamps.has_value();
    if (job.has_lamps) job.lamps = p.lamps_of(*options.lamps);
    job.rgb = p.linear.data();
    p.ask_for(job, setup.is_plain);
    Image image(camera.width, camera.height);
    p.device.download(image.rgb.data(), p.linear.data(), 3 * pixels * sizeof(float));
    return image;
}

void Pictures::set_schedule(const PictureSchedule& schedule) { parts_->options.schedule = schedule; }

std::size_t Pictures::object_bytes() const { return parts_->objects ? parts_->objects->bytes() : 0; }

std::size_t Pictures::bytes() const {
    const Parts& p = *parts_;
    return p.arrays.bytes() + p.image.bytes() + p.linear.bytes() + p.counters.bytes() + p.rare.bytes();
}

Image trace_on(Device& device, const accel::SceneView& scene, const Camera& camera, const TraceOptions& options,
               const PictureOptions& how) {
    return Pictures(device, scene, how).trace(camera, options);
}

}  // namespace enfilade::render::cuda
