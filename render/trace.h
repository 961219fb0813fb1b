#pragma once
// Pictures of a scene.

#include <optional>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/camera.h"
#include "render/framebuffer.h"
#include "render/image.h"
#include "render/lamps.h"
#include "render/look.h"
#include "render/object_tracer.h"
#include "render/trace_rays.h"
#include "render/tracer.h"
#include "render/walk_events.h"

namespace enfilade::render {

enum class Shading {
    Lambert,  ///< the lamps alone, or one at the eye: what benchmarks compare
    Look      ///< sun, sky, and corners that darken
};

/// Light from the scene's lamps (SceneView::lights), instead of one at the eye.
struct LampOptions {
    LampSearch search = LampSearch::Tree;
    float exposure = 1;                          ///< what a white surface in a light of pi lux becomes in the picture
    std::optional<accel::LightTreesView> trees;  ///< of Pvs and Tree; nothing: built for this picture
};

struct TraceOptions {
    Tracer tracer = Tracer::Packet;          ///< of uncut `Shading::Lambert` with one sample; others go ray by ray
    Precision precision = Precision::Float;  ///< of the walk; Double is walked by Tracer::Scalar alone
    PacketSizes packets;
    Shading shading = Shading::Look;
    int samples_per_pixel = 1;  ///< rounded up to a square number, evenly spread; 4 and more for pictures
    Look look;
    std::optional<LampOptions> lamps;           ///< nothing: a lamp at the eye. With Shading::Look besides sun and sky
    float mirror_floor = 0;                     ///< share of their light that floors reflect as mirrors do, 0 to 1
    std::optional<accel::CellId> start;         ///< the cell that holds the eye, where it is known; else looked for
    std::optional<double> cut_z;                ///< dollhouse: whatever lies above this height (metres) is not seen
    const accel::Executor* executor = nullptr;  ///< nullptr: all cores. The image does not depend on it.
    const ObjectTracer* objects = nullptr;      ///< nullptr: where the scene has objects, built for this picture
    RayStats* stats = nullptr;                  ///< where given, what happened to the rays is added
};

/// Traces the picture that the camera sees.
/// \throws InputError if the camera is none (R1), stands in a wall (R2), or below the cut (R3); if the options
/// contradict each other or packets have no size (R4)
[[nodiscard]] Image trace(const accel::SceneView& scene, const Camera& camera, const TraceOptions& options = {});

struct LambertOptions {
    Tracer tracer = Tracer::Packet;
    PacketSizes packets;
    float mirror_floor = 0;
    const ObjectTracer* objects = nullptr;  ///< nullptr: rooms are seen without what stands in them
    const Lamps* lamps = nullptr;           ///< nullptr: a lamp at the eye
    RayStats* stats = nullptr;
};

/// One frame after the other into a framebuffer that the caller keeps: `Shading::Lambert`, one sample, plain colours
/// without mirrors, glass of furniture and textures, no allocation but for stats. What benchmarks measure.
/// \pre framebuffer has the camera's size; the options are sound (R4)
void trace_lambert(const accel::SceneView& scene, const CameraFrame& frame, accel::CellId start,
                   const LambertOptions& options, const accel::Executor& executor, Framebuffer& framebuffer);

}  // namespace enfilade::render
