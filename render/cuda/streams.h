#pragma once
// Many rays at once on a device, as columns (render/ray_stream.h): what simulations ask for, and batches of secondary
// rays.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/cuda/device.h"
#include "render/cuda/device_objects.h"
#include "render/ray_stream.h"

namespace enfilade::render::cuda {

/// RayColumns in the device's memory.
struct DeviceRays {
    const float* origin[3];
    const float* direction[3];
    const accel::CellId* cell;  ///< that holds the origin
    const float* max_distance;  ///< metres; nullptr: none
    std::uint64_t count;
};

/// HitColumns in the device's memory; columns that are not wanted are nullptr.
struct DeviceHits {
    float* distance = nullptr;
    accel::SourceFaceId* source_face = nullptr;
    accel::CellId* cell = nullptr;
    WalkStatus* status = nullptr;
    accel::ObjectId* object = nullptr;
    std::uint32_t* triangle = nullptr;
};

/// SegmentColumns in the device's memory.
struct DeviceSegments {
    const float* from[3];
    const float* to[3];
    const accel::CellId* from_cell;
    const accel::CellId* to_cell;  ///< nullptr: not known
    std::uint64_t count;
};

struct DeviceStreamOptions {
    std::optional<InsideKind> inside;  ///< the trees of what stands in rooms; none: rooms are walked bare
    accel::OctreeOptions octrees;
    const accel::Executor* executor = nullptr;  ///< who builds the trees; nullptr: the calling thread
};

/// A scene on a device, and streams of rays through it. The answers are the scalar tracer's. The device must outlive
/// it.
class DeviceStream {
public:
    /// Uploads the scene. \throws CudaError
    DeviceStream(Device& device, const accel::SceneView& scene, const DeviceStreamOptions& options = {});
    DeviceStream(const DeviceStream&) = delete;
    DeviceStream& operator=(const DeviceStream&) = delete;
    ~DeviceStream();

    /// Asks for the first face or triangle that each ray meets, as render::nearest tells it. \pre all columns are in
    /// the device's memory; cells are the scene's
    void nearest(const DeviceRays& rays, const DeviceHits& hits);
    /// Asks for 1 where nothing but glass lies between the ends of a segment, else 0, as render::visible tells it.
    /// visible: [count]
    void visible(const DeviceSegments& segments, std::uint8_t* visible);
    /// Of the scene and its trees in the device's memory.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace enfilade::render::cuda
