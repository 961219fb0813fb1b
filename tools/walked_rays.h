#pragma once
// A block of placed rays, walked to the first face.

#include <vector>

#include "render/ray_stream.h"
#include "render/trace_rays.h"
#include "tools/placed_rays.h"
#include "tools/ray_answers.h"

namespace enfilade::tools {

/// Where a ray ends.
struct WalkedRay {
    double distance;           ///< metres from its origin; NaN where it does not start
    accel::SourceFaceId face;  ///< none: no face was met
    accel::CellId cell;        ///< the last one
    RayStatus status;
};

/// On the calling thread. Double is walked by the scalar tracer. Empties `walked` first: [rays.size()]
void walk_rays(const accel::SceneView& scene, std::span<const PlacedRay> rays, render::Tracer tracer,
               render::Precision precision, std::vector<WalkedRay>& walked);

}  // namespace enfilade::tools
