#pragma once
// A block of placed rays, walked to the first face.

#include <array>
#include <span>
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
    accel::ObjectId object;    ///< none: no object was met
    std::uint32_t triangle;    ///< of the object's mesh; render::no_triangle
    RayStatus status;
};

/// Walks one block after the other; its memory is used again for the next. For one thread at a time.
class RayWalker {
public:
    /// Double is walked by the scalar tracer. objects: nullptr: rooms are walked without what stands in them
    RayWalker(const accel::SceneView& scene, render::Tracer tracer, render::Precision precision,
              const render::ObjectTracer* objects = nullptr)
        : scene_(&scene), tracer_(tracer), precision_(precision), objects_(objects) {}

    /// [rays.size()], valid until the next call.
    std::span<const WalkedRay> walk(std::span<const PlacedRay> rays);

private:
    void walk_in_float(std::span<const PlacedRay> rays);
    void walk_in_double(std::span<const PlacedRay> rays);

    const accel::SceneView* scene_;
    render::Tracer tracer_;
    render::Precision precision_;
    const render::ObjectTracer* objects_;
    std::vector<WalkedRay> walked_;
    std::vector<std::uint32_t> walking_;         ///< the rays that start to walk
    std::array<std::vector<float>, 7> numbers_;  ///< theirs: origin, direction, maximal distance
    std::vector<float> distance_;
    std::vector<accel::CellId> cell_, last_cell_;
    std::vector<accel::SourceFaceId> face_;
    std::vector<accel::ObjectId> object_;
    std::vector<std::uint32_t> triangle_;
    std::vector<render::WalkStatus> status_;
    std::vector<render::RayQuery> queries_;
    std::vector<render::RayHit> hits_;
};

}  // namespace enfilade::tools
