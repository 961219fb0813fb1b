#pragma once
// The cameras from which tracers are compared: in rooms spread over a building.

#include <cstddef>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::tools {

/// `count` cameras in rooms spread over the scene, each turned by the golden angle from the one before, square pictures
/// of `side` pixels. Eyes stand 1.6 m above the floor, or half the height of a lower cell. In any cell where there is
/// no room; none where there is no cell.
[[nodiscard]] std::vector<render::Camera> floor_views(const accel::SceneView& scene, std::size_t count, int side);

/// A camera in the numbers that rays are made of, and the cell of a scene from which it sees.
struct PreparedView {
    render::CameraFrame frame;
    accel::CellId start;
};
/// Throws InputError (R2) where a camera does not stand in a cell of this scene.
[[nodiscard]] std::vector<PreparedView> prepared(const accel::SceneView& scene,
                                                 const std::vector<render::Camera>& cameras);

}  // namespace enfilade::tools
