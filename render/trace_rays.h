#pragma once
// Single rays, as tests, benchmarks and simulations ask for them.

#include <cstdint>
#include <limits>
#include <span>

#include "accel/scene.h"
#include "render/object_tracer.h"
#include "render/vec.h"
#include "render/walk_events.h"

namespace enfilade::render {

/// A ray from `origin`, which lies in `cell`; metres, scene frame. The direction may have any finite length but zero.
struct RayQuery {
    Vec3d origin;
    Vec3d direction;
    accel::CellId cell;
    double max_distance = std::numeric_limits<double>::infinity();  ///< metres
};

/// Where a ray ended.
struct RayHit {
    WalkStatus status;
    accel::SourceFaceId source_face;  ///< of a Hit
    accel::CellId cell;               ///< the last one
    Exit exit;
    std::uint32_t section;   ///< by which it left the cell's prism, 2^32 - 1 for vertical rays
    std::uint32_t face;      ///< side face, if exit is Side
    double distance;         ///< metres
    Vec3f throughput;        ///< product of the tints of the glass crossed
    accel::ObjectId object;  ///< none<ObjectId> where no object was hit
    std::uint32_t triangle;  ///< of the object's mesh; no_triangle where no object was hit
};

enum class Precision { Float, Double };

/// Traces rays one at a time on the calling thread. hits: [rays.size()]. A ray with a NaN, an infinite number or no
/// direction is answered with status Refused. `stats`, where given, is added to. objects: what stands in the rooms;
/// nullptr: nothing does.
void trace_rays(const accel::SceneView& scene, std::span<const RayQuery> rays, std::span<RayHit> hits,
                Precision precision = Precision::Float, RayStats* stats = nullptr,
                const ObjectTracer* objects = nullptr);

/// The same for one ray.
[[nodiscard]] RayHit trace_ray(const accel::SceneView& scene, const RayQuery& ray,
                               Precision precision = Precision::Float, const ObjectTracer* objects = nullptr);

}  // namespace enfilade::render
