#pragma once
// Rays by the million, as checks and contests of streams need them: on the host, and on a device.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/cuda/buffer.h"
#include "render/cuda/streams.h"
#include "render/object_tracer.h"
#include "render/trace_rays.h"
#include "tools/gpu/tried_scene.h"

namespace enfilade::tools::gpu {

/// Rays by columns, metres, scene frame.
struct RayBatch {
    std::string name;
    std::array<std::vector<float>, 3> origin, direction;  ///< [x, y, z][ray]
    std::vector<accel::CellId> cell;                      ///< that holds the origin

    explicit RayBatch(std::string name_ = {}, std::size_t count = 0);
    [[nodiscard]] std::size_t size() const { return cell.size(); }
    [[nodiscard]] render::RayQuery query(std::size_t i) const;
    void set(std::size_t i, render::Vec3f from, render::Vec3f along, accel::CellId in);
};

/// Segments by columns: places, and lamps that they may see.
struct SegmentBatch {
    std::string name;
    std::array<std::vector<float>, 3> from, to;
    std::vector<accel::CellId> from_cell, to_cell;
    [[nodiscard]] std::size_t size() const { return from_cell.size(); }
};

/// Rays through pixels of the scene's views, view after view, in tiles of 8 x 4 pixels as warps take them: `count` of
/// them, or a few less; pictures are as large as that asks for. \pre scene.views is not empty
[[nodiscard]] RayBatch primary_rays(const TriedScene& scene, std::size_t count, const accel::Executor& executor);

/// From where primary rays met a face or an object, one ray each in a direction spread as the cosine to the normal; in
/// their order. Rays that met the sky give none. objects: of the scene, or nullptr: bare rooms
[[nodiscard]] RayBatch diffuse_rays(const TriedScene& scene, const RayBatch& primary,
                                    const render::ObjectTracer* objects, const accel::Executor& executor);

/// The same rays in random order. \pre at most 2^32
[[nodiscard]] RayBatch shuffled(const RayBatch& rays, std::uint64_t seed, const accel::Executor& executor);

/// From where primary rays met something, to the lamps that the place's cell may see, 32 places to one lamp and then to
/// the next; at most `count`. trees: of the scene
[[nodiscard]] SegmentBatch shadow_segments(const TriedScene& scene, const RayBatch& primary,
                                           const accel::LightTreesView& trees, const render::ObjectTracer* objects,
                                           std::size_t count, const accel::Executor& executor);

/// What the scalar tracer answers, in float.
[[nodiscard]] std::vector<render::RayHit> expected_hits(const accel::SceneView& scene, const RayBatch& rays,
                                                        const render::ObjectTracer* objects,
                                                        const accel::Executor& executor);

/// A batch in a device's memory, with room for its answers.
struct RaysOnDevice {
    RaysOnDevice(render::cuda::Device& device, const RayBatch& rays);
    std::array<render::cuda::Buffer<float>, 3> origin, direction;
    render::cuda::Buffer<accel::CellId> cell;
    render::cuda::Buffer<float> distance;
    render::cuda::Buffer<accel::SourceFaceId> face;
    render::cuda::Buffer<accel::ObjectId> object;
    render::cuda::Buffer<std::uint32_t> triangle;

    [[nodiscard]] render::cuda::DeviceRays rays() const;
    /// Distance and face, and of furnished rooms object and triangle.
    [[nodiscard]] render::cuda::DeviceHits hits(bool with_objects) const;
};

struct SegmentsOnDevice {
    SegmentsOnDevice(render::cuda::Device& device, const SegmentBatch& segments);
    std::array<render::cuda::Buffer<float>, 3> from, to;
    render::cuda::Buffer<accel::CellId> from_cell, to_cell;
    render::cuda::Buffer<std::uint8_t> visible;

    [[nodiscard]] render::cuda::DeviceSegments segments() const;
};

}  // namespace enfilade::tools::gpu
