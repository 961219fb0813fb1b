#include "tools/gpu/frame_ways.h"

#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/packets.h"
#include "render/cuda/pictures.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;

/// A thread a pixel.
class Pixels : public FrameMaker {
public:
    Pixels(Device& device, const FrameScene& scene, const FrameTask& task)
        : pictures_(device, scene.scene, {.mirror_floor = task.mirror_floor}) {}

    void draw(std::size_t view) override { pictures_.draw(frames_[view], starts_[view], side_, side_); }
    void read(render::Framebuffer& framebuffer) override { pictures_.read(framebuffer); }
    std::size_t bytes() const override { return pictures_.bytes(); }

private:
    render::cuda::Pictures pictures_;
};

std::unique_ptr<FrameMaker> open_pixels(Device& device, const FrameScene& scene, const FrameTask& task,
                                        const accel::Executor& /*executor*/) {
    if (task.with_objects || task.lamps) return nullptr;
    return std::make_unique<Pixels>(device, scene, task);
}

/// Tiles by the corner rays of a warp.
class Packets : public FrameMaker {
public:
    Packets(Device& device, const FrameScene& scene, const FrameTask& task, render::cuda::PacketTiles tiles)
        : device_(device), arrays_(device), scene_(copy_scene(scene.scene, arrays_)) {
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
    render::cuda::PacketJob job_ = {};
    render::cuda::Buffer<std::uint32_t> image_;
};

template <int largest, int smallest>
std::unique_ptr<FrameMaker> open_packets(Device& device, const FrameScene& scene, const FrameTask& task,
                                         const accel::Executor& /*executor*/) {
    if (task.with_objects || task.lamps) return nullptr;
    return std::make_unique<Packets>(device, scene, task, render::cuda::PacketTiles{largest, smallest});
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

const std::vector<FrameWay>& frame_ways() {
    static const std::vector<FrameWay> ways = {
        {"a thread a pixel", true, true, render::ObjectAccelKind::Octree, open_pixels},
        {"packets 8:4", true, false, render::ObjectAccelKind::Octree, open_packets<8, 4>},
        {"packets 16:4", true, false, render::ObjectAccelKind::Octree, open_packets<16, 4>},
        {"packets 32:8", true, false, render::ObjectAccelKind::Octree, open_packets<32, 8>},
    };
    return ways;
}

}  // namespace enfilade::tools::gpu
