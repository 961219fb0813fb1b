#pragma once
// Pictures of a scene.

#include <optional>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/image.h"
#include "render/look.h"
#include "render/walk_events.h"

namespace enfilade::render {

enum class Shading {
    Lambert,  ///< one lamp at the eye: what benchmarks compare
    Look      ///< sun, sky, and corners that darken
};

struct TraceOptions {
    Shading shading = Shading::Look;
    int samples_per_pixel = 1;  ///< rounded up to a square number, evenly spread; 4 and more for pictures
    Look look;
    std::optional<double> cut_z;                ///< dollhouse: whatever lies above this height (metres) is not seen
    const accel::Executor* executor = nullptr;  ///< nullptr: all cores. The image does not depend on it.
    RayStats* stats = nullptr;                  ///< where given, what happened to the rays is added
};

/// Traces the picture that the camera sees, in float, one ray at a time.
/// \throws InputError if the camera is none (R1), stands in a wall (R2), or below the cut (R3)
[[nodiscard]] Image trace(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options = {});

/// The same into an image that the caller keeps, for benchmarks: `Shading::Lambert`, no allocation, one sample.
/// \pre image has the camera's size
void trace_lambert(const accel::SceneView& scene, const CameraFrame& frame, accel::CellId start,
                   const accel::Executor& executor, Image& image);

}  // namespace enfilade::render
