#pragma once
// A scene with what its pictures need on the host: light trees, and how bright they are made.

#include <optional>

#include "accel/lights/light_trees.h"
#include "accel/parallel_for.h"
#include "tools/gpu/exposure.h"
#include "tools/gpu/frame_ways.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// The tried scene must outlive it.
class PreparedScene {
public:
    PreparedScene(const TriedScene& scene, const accel::Executor& executor)
        : PreparedScene(scene, scene.view(), executor) {}
    /// The same in other colours (own_colours.h), whose memory must outlive it.
    PreparedScene(const TriedScene& scene, const accel::SceneView& view, const accel::Executor& executor)
        : tried_(scene) {
        frames_.scene = view;
        if (!scene.has_lamps()) return;
        trees_.emplace(build_light_trees(view, {}, executor));
        frames_.trees = trees_->view();
        frames_.exposure = picture_exposure(scene, frames_.trees, executor);
    }
    PreparedScene(const PreparedScene&) = delete;
    PreparedScene& operator=(const PreparedScene&) = delete;

    [[nodiscard]] const TriedScene& tried() const { return tried_; }
    [[nodiscard]] const FrameScene& frames() const { return frames_; }
    /// Whether there is something in the scene that the task shows, and not so much that it takes minutes: walks to all
    /// of thousands of lamps.
    [[nodiscard]] bool has(const FrameTask& task) const {
        constexpr std::size_t most_walked = 500;
        if (task.lamps == render::LampSearch::Naive && frames_.scene.lights.size() > most_walked) return false;
        return (!task.lamps || tried_.has_lamps()) && (!task.with_objects || tried_.has_objects());
    }

private:
    const TriedScene& tried_;
    std::optional<accel::LightTrees> trees_;
    FrameScene frames_;
};

}  // namespace enfilade::tools::gpu
