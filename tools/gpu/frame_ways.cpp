#include "tools/gpu/frame_ways.h"

#include <optional>
#include <span>

#include "render/cuda/buffer.h"
#include "render/cuda/device_objects.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/packets.h"
#include "render/cuda/pictures.h"
#include "render/lamp_lists.h"
#include "tools/gpu/baselines.h"
#include "tools/gpu/inside_tracers.h"
#include "tools/gpu/known_cells.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;
using render::cuda::FrameStart;
using render::cuda::InsideKind;
using render::cuda::PictureOptions;
using render::cuda::PictureSchedule;
using render::cuda::PixelOrder;

render::ObjectAccelKind kind_of(InsideKind inside) {
    return inside == InsideKind::Octree ? render::ObjectAccelKind::Octree : render::ObjectAccelKind::Plain;
}

/// A thread a pixel.
class Pixels : public FrameMaker {
public:
    Pixels(Device& device, const FrameScene& scene, const PictureOptions& options)
        : pictures_(device, scene.scene, options) {}

    void draw(std::size_t view) override { pictures_.draw(frames_[view], starts_[view], side_, side_); }
    void read(render::Framebuffer& framebuffer) override { pictures_.read(framebuffer); }
    std::size_t bytes() const override { return pictures_.bytes(); }

private:
    render::cuda::Pictures pictures_;
};

/// Where a way of drawing differs from others.
enum class For { Everything, Bare, Furnished };

FrameWay pixels(const std::string& name, For tasks, const PictureSchedule& schedule,
                InsideKind inside = InsideKind::Octree) {
    const auto open = [=](Device& device, const FrameScene& scene, const FrameTask& task,
                          const accel::Executor& executor) -> std::unique_ptr<FrameMaker> {
        if (tasks == For::Bare && (task.with_objects || task.lamps)) return nullptr;
        if (tasks == For::Furnished && !task.with_objects) return nullptr;
        // Walks to all lamps are slow enough without trying everything on them.
        const bool is_plain = schedule.order == PixelOrder::Tiles && schedule.start == FrameStart::Launch;
        if (task.lamps == render::LampSearch::Naive && !is_plain) return nullptr;
        PictureOptions options;
        options.has_objects = task.with_objects;
        options.inside = inside;
        options.mirror_floor = task.mirror_floor;
        if (task.lamps) options.lamps = {*task.lamps, scene.exposure, scene.trees};
        options.schedule = schedule;
        options.executor = &executor;
        return std::make_unique<Pixels>(device, scene, options);
    };
    return {name, true, true, kind_of(inside), open};
}

/// Tiles by the corner rays of a warp.
class Packets : public FrameMaker {
public:
    Packets(Device& device, const FrameScene& scene, const FrameTask& task, render::cuda::PacketTiles tiles,
            InsideKind inside, const accel::Executor& executor)
        : device_(device), arrays_(device), scene_(copy_scene(scene.scene, arrays_)) {
        if (task.with_objects)
            objects_.emplace(arrays_, scene.scene, scene_, inside, render::cuda::device_octree_options(), executor);
        job_.objects = objects_ ? &*objects_ : nullptr;
        if (task.lamps) lamps_ = {copy_trees(scene.trees, arrays_), *task.lamps, scene.exposure};
        job_.lamps = task.lamps ? &lamps_ : nullptr;
        job_.scene = &scene_;
        job_.look = render::lambert_look({});
        job_.mirror_floor = task.mirror_floor;
        job_.tiles = tiles;
    }

    void draw(std::size_t view) override {
        const std::size_t pixels = static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
        if (image_.size() != pixels) image_ = render::cuda::Buffer<std::uint32_t>(device_, pixels);
        job_.camera = frames_[view];
        job_.start = starts_[view];
        job_.width = job_.height = side_;
        job_.rgba = image_.data();
        draw_packets(device_, job_);
    }
    void read(render::Framebuffer& framebuffer) override {
        framebuffer = render::Framebuffer(job_.width, job_.height);
        device_.download(framebuffer.rgba.data(), image_.data(), image_.bytes());
    }
    std::size_t bytes() const override { return arrays_.bytes() + image_.bytes(); }

private:
    Device& device_;
    render::cuda::DeviceArrays arrays_;
    accel::SceneView scene_;
    std::optional<render::cuda::DeviceObjects> objects_;
    render::Lamps lamps_;
    render::cuda::PacketJob job_ = {};
    render::cuda::Buffer<std::uint32_t> image_;
};

FrameWay packets(const std::string& name, render::cuda::PacketTiles tiles, InsideKind inside = InsideKind::Octree) {
    const auto open = [=](Device& device, const FrameScene& scene, const FrameTask& task,
                          const accel::Executor& executor) -> std::unique_ptr<FrameMaker> {
        if (!task.with_objects && inside != InsideKind::Octree) return nullptr;
        if (task.lamps && (task.with_objects || *task.lamps != render::LampSearch::Tree)) return nullptr;
        return std::make_unique<Packets>(device, scene, task, tiles, inside, executor);
    };
    return {name, true, false, kind_of(inside), open};
}

/// A general ray tracer. Lit, it is told the cell of each pixel and asks for the lamps of that cell's list.
class BaselineFrames : public FrameMaker {
public:
    BaselineFrames(Device& device, const FrameScene& scene, const FrameTask& task,
                   const render::cuda::BvhBaselineOptions& options, bool from_lamps, const accel::Executor& executor)
        : device_(device),
          scene_(scene.scene),
          executor_(executor),
          is_lit_(task.lamps.has_value()),
          from_lamps_(from_lamps),
          bvh_(device, scene.scene, options, executor) {
        if (!is_lit_) return;
        bvh_.set_lamps(scene.scene, render::lamp_lists(scene.trees), scene.exposure);
        if (task.with_objects) inside_ = std::make_unique<InsideTracers>(scene.scene, executor);
    }

    void set_views(const std::vector<TriedView>& views, int side) override {
        FrameMaker::set_views(views, side);
        cells_.clear();
        if (!is_lit_) return;
        const render::ObjectTracer* objects = inside_ ? inside_->of(render::ObjectAccelKind::Plain) : nullptr;
        for (const TriedView& view : views) {
            const std::vector<std::uint32_t> cells = known_cells(scene_, view, side, objects, executor_);
            cells_.emplace_back(device_, std::span<const std::uint32_t>(cells));
        }
    }
    void draw(std::size_t view) override {
        if (is_lit_) bvh_.draw_lit(frames_[view], side_, side_, cells_[view].data(), from_lamps_);
        else bvh_.draw(frames_[view], side_, side_);
    }
    void read(render::Framebuffer& framebuffer) override { bvh_.read(framebuffer); }
    std::size_t bytes() const override { return bvh_.bytes(); }

private:
    Device& device_;
    accel::SceneView scene_;
    const accel::Executor& executor_;
    bool is_lit_, from_lamps_;
    render::cuda::BvhBaseline bvh_;
    std::unique_ptr<InsideTracers> inside_;
    std::vector<render::cuda::Buffer<std::uint32_t>> cells_;
};

FrameWay baseline(const BaselineWay& way, bool from_lamps) {
    const auto open = [=](Device& device, const FrameScene& scene, const FrameTask& task,
                          const accel::Executor& executor) -> std::unique_ptr<FrameMaker> {
        if (task.mirror_floor > 0 || task.lamps == render::LampSearch::Naive) return nullptr;
        if (from_lamps && !task.lamps) return nullptr;
        render::cuda::BvhBaselineOptions options = way.options;
        options.with_objects = task.with_objects;
        options.skin = task.lamps ? baseline_skin : 0;
        return std::make_unique<BaselineFrames>(device, scene, task, options, from_lamps, executor);
    };
    return {way.name + (from_lamps ? ", from lamps" : ""), false, false, render::ObjectAccelKind::Plain, open};
}

}  // namespace

std::vector<FrameTask> frame_tasks() {
    using render::LampSearch;
    return {{"Lambert", 0, false, {}},
            {"mirror floor", 0.25f, false, {}},
            {"lamps, naive", 0, false, LampSearch::Naive},
            {"lamps, PVS", 0, false, LampSearch::Pvs},
            {"lamps, trees", 0, false, LampSearch::Tree},
            {"objects", 0, true, {}},
            {"objects and lamps, PVS", 0, true, LampSearch::Pvs},
            {"objects and lamps, trees", 0, true, LampSearch::Tree}};
}

namespace {

std::vector<FrameWay> all_ways() {
    using render::cuda::KernelShape;
    using render::cuda::WarpWork;
    std::vector<FrameWay> ways = {
        pixels("a thread a pixel", For::Everything, {}),
        pixels("a thread a pixel, by rows", For::Everything, {.order = PixelOrder::Rows}),
        pixels("a thread a pixel, along a Z curve", For::Everything, {.order = PixelOrder::Morton}),
        pixels("a thread a pixel, persistent", For::Everything, {.work = WarpWork::Persistent}),
        pixels("a thread a pixel, as a graph", For::Everything, {.start = FrameStart::Graph}),
        pixels("a thread a pixel, blocks of 64", For::Bare, {.shape = KernelShape::Blocks64}),
        pixels("a thread a pixel, blocks of 256", For::Bare, {.shape = KernelShape::Blocks256}),
        pixels("a thread a pixel, 80 registers", For::Bare, {.shape = KernelShape::FewRegisters}),
        pixels("a thread a pixel, 64 registers", For::Bare, {.shape = KernelShape::LeastRegisters}),
        pixels("a thread a pixel, BVHs inside", For::Furnished, {}, InsideKind::Bvh),
        pixels("a thread a pixel, persistent, BVHs inside", For::Furnished, {.work = WarpWork::Persistent},
               InsideKind::Bvh),
        packets("packets 8:4", {8, 4}),
        packets("packets 8:8", {8, 8}),
        packets("packets 16:4", {16, 4}),
        packets("packets 16:8", {16, 8}),
        packets("packets 32:8", {32, 8}),
        packets("packets 64:8", {64, 8}),
        packets("packets 16:4, BVHs inside", {16, 4}, InsideKind::Bvh),
    };
    for (const BaselineWay& way : baseline_ways())
        for (const bool from_lamps : {false, true}) ways.push_back(baseline(way, from_lamps));
    return ways;
}

}  // namespace

const std::vector<FrameWay>& frame_ways() {
    static const std::vector<FrameWay> ways = all_ways();
    return ways;
}

}  // namespace enfilade::tools::gpu
