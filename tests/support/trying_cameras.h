#pragma once
// Cameras where tracers go wrong: on portals, vertical lines and floors, along walls, with the widest and the narrowest
// fields of view, in images of odd sizes.

#include <cstdint>
#include <string>
#include <vector>

#include "accel/scene.h"
#include "render/camera.h"

namespace enfilade::test {

struct TryingCamera {
    std::string name;
    render::Camera camera;
    bool on_border;  ///< stands where cells meet: every ray of it may pass an edge within rounding
};

/// `rounds` of each kind whose eye some cell holds; the same seed gives the same ones. Images have some 6,000 pixels.
[[nodiscard]] std::vector<TryingCamera> trying_cameras(const accel::SceneView& scene, std::uint64_t seed,
                                                       int rounds = 1);

/// Frames whose rays go exactly through the corners of the walls around cell c, 2^level pixels from corner to corner:
/// the outermost pixels run along edges. Eyes on the grid inside the cell.
struct AlignedFrame {
    render::CameraFrame frame;
    accel::CellId start;
    int width, height;
};
[[nodiscard]] std::vector<AlignedFrame> aligned_frames(const accel::SceneView& scene, std::uint32_t c, int level);

}  // namespace enfilade::test
