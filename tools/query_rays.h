#pragma once
// Files of rays answered block by block: read, moved into the scene's frame, located, traced, written.

#include <array>
#include <cstdint>
#include <functional>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/ray_stream.h"
#include "render/trace_rays.h"
#include "tools/npy.h"
#include "tools/ray_answers.h"

namespace enfilade::tools {

struct QueryOptions {
    render::Tracer tracer = render::Tracer::Packet;
    render::Precision precision = render::Precision::Float;  ///< Double: by the scalar tracer; passages always
    const render::ObjectTracer* objects = nullptr;           ///< nullptr: rooms without what stands in them
    const render::Solids* solids = nullptr;                  ///< of passages: what solids are called
    const accel::Executor* executor = nullptr;               ///< nullptr: the calling thread
    std::function<void(double)> progress;                    ///< told the share that is done, by any thread
};

/// Seconds that cores were busy with each part, summed over threads.
struct QueryTimes {
    double read = 0, locate = 0, trace = 0, write = 0;
};

struct QueryReport {
    std::uint64_t rays = 0;
    std::array<std::uint64_t, ray_status_count> of_status = {};  ///< by RayStatus; passages: how the rays end
    std::uint64_t in_walls = 0;  ///< rays that start in a solid; passages go on from there
    std::uint64_t passages = 0;  ///< of passages: how many in all
    std::uint64_t solids = 0;    ///< how many of them are solids
    QueryTimes busy;
};

/// One HitRecord a ray.
[[nodiscard]] QueryReport query_nearest(const accel::SceneView& scene, const RayFile& rays, NpyWriter& hits,
                                        const QueryOptions& options);
/// One SightStatus a ray.
[[nodiscard]] QueryReport query_any(const accel::SceneView& scene, const RayFile& rays, NpyWriter& sights,
                                    const QueryOptions& options);
/// render::Passage records, through cells and solids (objects are passed unseen), and rays + 1 offsets (int64) into
/// them.
[[nodiscard]] QueryReport query_all(const accel::SceneView& scene, const RayFile& rays, NpyWriter& passages,
                                    NpyWriter& offsets, const QueryOptions& options);

}  // namespace enfilade::tools
