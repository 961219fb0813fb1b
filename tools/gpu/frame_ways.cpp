#include "tools/gpu/frame_ways.h"

#include "render/cuda/pictures.h"

namespace enfilade::tools::gpu {

namespace {

using render::cuda::Device;

/// A thread a pixel.
class Pixels : public FrameMaker {
public:
    Pixels(Device& device, const FrameScene& scene, const FrameTask& task)
        : pictures_(device, scene.scene, {.mirror_floor = task.mirror_floor}) {}

    void draw(const render::CameraFrame& frame, accel::CellId start, int side) override {
        pictures_.draw(frame, start, side, side);
    }
    void read(render::Framebuffer& framebuffer) override { pictures_.read(framebuffer); }
    std::size_t bytes() const override { return pictures_.bytes(); }

private:
    render::cuda::Pictures pictures_;
};

std::unique_ptr<FrameMaker> open_pixels(Device& device, const FrameScene& scene, const FrameTask& task) {
    if (task.with_objects || task.lamps) return nullptr;
    return std::make_unique<Pixels>(device, scene, task);
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
        {"a thread a pixel", true, true, open_pixels},
    };
    return ways;
}

}  // namespace enfilade::tools::gpu
