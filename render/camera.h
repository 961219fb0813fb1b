#pragma once
// The pinhole camera.

#include <cstdint>

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::render {

/// Looks from `eye` at `target`; metres in the scene's frame, z up.
struct Camera {
    Vec3d eye = {0, 0, 1.6};
    Vec3d target = {1, 0, 1.6};
    Vec3d up = {0, 0, 1};
    double fov_deg = 75;  ///< across the longer side of the image
    int width = 1024;
    int height = 1024;
};

/// The camera in the numbers that rays are made of: direction(x, y) = corner + x du + y dv, pixels from the upper left.
struct CameraFrame {
    Vec3f origin;
    Vec3f corner;
    Vec3f du;
    Vec3f dv;

    ENFILADE_HD Vec3f direction(float x, float y) const { return corner + x * du + y * dv; }
};

/// \throws InputError (R1) for a camera that is not finite, looks at its own eye or along `up`, or has no pixels or a
/// field of view outside (0, 180) degrees.
[[nodiscard]] CameraFrame make_frame(const Camera& camera);

/// The cell from which the camera sees. \throws InputError (R2) if its eye lies in a wall or outside the site, saying
/// where, in the metres of the plan, and what to do.
[[nodiscard]] accel::CellId start_cell(const accel::SceneView& scene, const CameraFrame& frame);

}  // namespace enfilade::render
