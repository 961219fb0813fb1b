#include "render/cuda/bvh_baseline.h"

#include <algorithm>
#include <span>

#include "render/cuda/buffer.h"
#include "render/cuda/bvh2.h"
#include "render/cuda/bvh_starts.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/wide_bvh.h"

namespace enfilade::render::cuda {
namespace {

/// So many items at a time: what a card's blocks can be numbered for.
constexpr std::uint64_t most_items = std::uint64_t{1} << 30;

TriangleScene triangles_of(const accel::SceneView& scene, const BvhBaselineOptions& options) {
    return options.mesh ? TriangleScene::of_mesh(scene, *options.mesh) : TriangleScene(scene, !options.with_objects);
}

template <class T>
T* from(T* column, std::uint64_t first) {
    return column == nullptr ? nullptr : column + first;
}

template <class T>
const T* copied(DeviceArrays& arrays, const std::vector<T>& values) {
    return arrays.copy(values.data(), values.size());
}

}  // namespace

struct BvhBaseline::Parts {
    Device& device;
    BvhBaselineOptions options;
    DeviceArrays arrays;
    Bvh2View binary = {};
    WideBvhView wide = {};
    std::size_t tree_bytes = 0, record_count = 0;
    BvhJob job = {};  ///< what all jobs share
    std::unique_ptr<DeviceArrays> lamp_arrays;
    Buffer<unsigned long long> taken;
    Buffer<std::uint32_t> image;
    Buffer<SeenPlace> places;
    int width = 0, height = 0;

    Parts(Device& device_, const accel::SceneView& scene, const BvhBaselineOptions& options_,
          const accel::Executor& executor)
        : device(device_), options(options_), arrays(device_), taken(device_, 1) {
        const TriangleScene triangles = triangles_of(scene, options);
        BvhForestOptions building;
        building.split_share = options.mesh ? options.mesh_split_share : options.split_share;
        building.mesh_split_share = options.mesh_split_share;
        if (options.kind == BvhKind::Wide) building.largest_leaf = 1;
        const BvhForest forest = build_forest(triangles, building, executor);
        if (options.kind == BvhKind::Binary) binary = uploaded<Bvh2View>(lay_out_bvh2(triangles, forest, options.test));
        else wide = uploaded<WideBvhView>(lay_out_wide_bvh(triangles, forest, options.test));
        job.test = options.test;
        job.skin = options.skin;
        job.look = lambert_look({});
        job.looks = copied(arrays, triangles.looks);
    }

    template <class View, class Arrays>
    View uploaded(const Arrays& host) {
        const View view = {copied(arrays, host.nodes),   copied(arrays, host.records), copied(arrays, host.instances),
                           copied(arrays, host.extents), host.view().instance_count,   host.view().is_empty};
        tree_bytes = host.nodes.size() * sizeof(host.nodes[0]) + host.records.size() * sizeof(host.records[0]);
        record_count = host.records.size();
        return view;
    }

    /// Calls start(view) for the tree that there is.
    template <class Start>
    void among_trees(const Start& start) const {
        if (options.kind == BvhKind::Binary) start(binary);
        else start(wide);
    }

    [[nodiscard]] BvhJob frame_job(const CameraFrame& frame, BvhAsk ask, int width_, int height_) {
        const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        if (image.size() < pixels) image = Buffer<std::uint32_t>(device, pixels);
        width = width_;
        height = height_;
        BvhJob asked = job;
        asked.ask = ask;
        asked.count = pixel_threads(width, height);
        asked.camera = frame;
        asked.width = width;
        asked.height = height;
        asked.rgba = image.data();
        return asked;
    }

    void ask_nearest(const BvhJob& asked) const {
        among_trees([&](const auto& view) { start_nearest(device, view, asked, options.schedule, taken.data()); });
    }
};

BvhBaseline::BvhBaseline(Device& device, const accel::SceneView& scene, const BvhBaselineOptions& options,
                         const accel::Executor& executor)
    : parts_(std::make_unique<Parts>(device, scene, options, executor)) {}

BvhBaseline::~BvhBaseline() = default;

void BvhBaseline::draw(const CameraFrame& frame, int width, int height) {
    Parts& p = *parts_;
    p.ask_nearest(p.frame_job(frame, BvhAsk::Pixels, width, height));
}

void BvhBaseline::set_lamps(const accel::SceneView& scene, const LampLists& lists, float exposure) {
    Parts& p = *parts_;
    p.device.wait();  // for frames that read the lists before
    p.lamp_arrays = std::make_unique<DeviceArrays>(p.device);
    p.job.lamps.lights = p.lamp_arrays->copy(scene.lights).data();
    p.job.lamps.offsets = copied(*p.lamp_arrays, lists.offsets);
    p.job.lamps.lamps = copied(*p.lamp_arrays, lists.lamps);
    p.job.lamps.exposure = exposure;
}

void BvhBaseline::draw_lit(const CameraFrame& frame, int width, int height, const std::uint32_t* cells,
                           bool from_lamps) {
    Parts& p = *parts_;
    BvhJob asked = p.frame_job(frame, BvhAsk::Places, width, height);
    if (p.places.size() < asked.count) p.places = Buffer<SeenPlace>(p.device, asked.count);
    asked.places = p.places.data();
    asked.lamps.cells = cells;
    asked.lamps.from_lamps = from_lamps;
    p.ask_nearest(asked);
    p.among_trees([&](const auto& view) { start_lamps(p.device, view, asked, p.options.schedule, p.taken.data()); });
}

const std::uint32_t* BvhBaseline::image() const { return parts_->image.data(); }

void BvhBaseline::read(Framebuffer& framebuffer) const {
    const Parts& p = *parts_;
    if (framebuffer.width != p.width || framebuffer.height != p.height) framebuffer = Framebuffer(p.width, p.height);
    p.device.wait();
    if (!framebuffer.rgba.empty())
        p.device.download(framebuffer.rgba.data(), p.image.data(), framebuffer.rgba.size() * sizeof(std::uint32_t));
}

void BvhBaseline::nearest(const DeviceRays& rays, const DeviceHits& hits) {
    Parts& p = *parts_;
    for (std::uint64_t first = 0; first < rays.count; first += most_items) {
        BvhJob asked = p.job;
        asked.ask = BvhAsk::Columns;
        asked.count = std::min(most_items, rays.count - first);
        for (int k = 0; k < 3; ++k) {
            asked.rays.origin[k] = rays.origin[k] + first;
            asked.rays.direction[k] = rays.direction[k] + first;
        }
        asked.rays.max_distance = from(rays.max_distance, first);
        asked.hits = {from(hits.distance, first), from(hits.source_face, first), nullptr,
                      from(hits.status, first),   from(hits.object, first),      from(hits.triangle, first)};
        p.ask_nearest(asked);
    }
}

void BvhBaseline::visible(const DeviceSegments& segments, std::uint8_t* visible) {
    Parts& p = *parts_;
    for (std::uint64_t first = 0; first < segments.count; first += most_items) {
        BvhJob asked = p.job;
        asked.count = std::min(most_items, segments.count - first);
        for (int k = 0; k < 3; ++k) {
            asked.segments.from[k] = segments.from[k] + first;
            asked.segments.to[k] = segments.to[k] + first;
        }
        asked.visible = visible + first;
        p.among_trees(
            [&](const auto& view) { start_segments(p.device, view, asked, p.options.schedule, p.taken.data()); });
    }
}

void BvhBaseline::nearest(const OctreeRay* rays, OctreeAnswer* answers, std::uint64_t count) {
    Parts& p = *parts_;
    for (std::uint64_t first = 0; first < count; first += most_items) {
        BvhJob asked = p.job;
        asked.ask = BvhAsk::OfMesh;
        asked.count = std::min(most_items, count - first);
        asked.mesh_rays = rays + first;
        asked.answers = answers + first;
        p.ask_nearest(asked);
    }
}

void BvhBaseline::set_schedule(const BvhSchedule& schedule) { parts_->options.schedule = schedule; }

std::size_t BvhBaseline::bytes() const {
    return parts_->arrays.bytes() + (parts_->lamp_arrays != nullptr ? parts_->lamp_arrays->bytes() : 0);
}
std::size_t BvhBaseline::tree_bytes() const { return parts_->tree_bytes; }
std::size_t BvhBaseline::record_count() const { return parts_->record_count; }

}  // namespace enfilade::render::cuda
