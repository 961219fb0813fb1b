#pragma once
// The ways by which a device makes pictures: everybody who takes part in checks and in contests of frames stands in one
// table (frame_ways.cpp), a line each.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accel/lights/light_trees.h"
#include "accel/parallel_for.h"
#include "render/camera.h"
#include "render/cuda/device.h"
#include "render/framebuffer.h"
#include "render/lamps.h"
#include "render/object_tracer.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// What a picture shows.
struct FrameTask {
    std::string name;  ///< as tables have it
    float mirror_floor = 0;
    bool with_objects = false;
    std::optional<render::LampSearch> lamps;  ///< nothing: a lamp at the eye
};

/// All rows of the paper's table 2, and its table 3's: ours of both.
[[nodiscard]] std::vector<FrameTask> frame_tasks();

/// What all pictures of one scene are made of. The memory is the caller's.
struct FrameScene {
    accel::SceneView scene;
    accel::LightTreesView trees;  ///< of its lamps; empty where it has none
    float exposure = 1;
};

/// A scene on a device, ready for frames of one task.
class FrameMaker {
public:
    virtual ~FrameMaker() = default;
    /// From where frames will be asked for, and their width and height in pixels; before the first one.
    virtual void set_views(const std::vector<TriedView>& views, int side) {
        frames_.clear();
        starts_.clear();
        side_ = side;
        for (const TriedView& view : views) {
            frames_.push_back(view.frame(side));
            starts_.push_back(view.start);
        }
    }
    /// Asks for a frame; it stays on the device.
    virtual void draw(std::size_t view) = 0;
    /// A copy of it; waits.
    virtual void read(render::Framebuffer& framebuffer) = 0;
    /// In the device's memory.
    [[nodiscard]] virtual std::size_t bytes() const = 0;

protected:
    std::vector<render::CameraFrame> frames_;
    std::vector<accel::CellId> starts_;
    int side_ = 0;
};

struct FrameWay {
    std::string name;
    bool is_ours;   ///< else a baseline
    bool is_exact;  ///< the same formulas in the same order as the scalar tracer's: on the host the same bits
    render::ObjectAccelKind inside;  ///< with which structures inside of objects the scalar tracer is to be compared
    /// nullptr: this way has no such pictures.
    std::function<std::unique_ptr<FrameMaker>(render::cuda::Device& device, const FrameScene& scene,
                                              const FrameTask& task, const accel::Executor& executor)>
        open;
};

[[nodiscard]] const std::vector<FrameWay>& frame_ways();

}  // namespace enfilade::tools::gpu
