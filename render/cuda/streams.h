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
#include "render/cuda/octree_options.h"
#include "render/cuda/packed_sections.h"
#include "render/cuda/ray_order.h"
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

/// How threads share the work. Answers are the same.
enum class StreamSchedule {
    Whole,       ///< a thread a ray, recoveries and all
    Deferred,    ///< a thread a ray; rare cases are put on a list, and walked whole by a kernel of their own
    Persistent,  ///< as Deferred, by warps that stay and fetch rays as their lanes fall idle (Aila and Laine 2009)
    Compacted    ///< furnished rooms: cells and objects by kernels of their own, in rounds; bare ones: Deferred
};

struct DeviceStreamOptions {
    std::optional<InsideKind> inside = {};  ///< the trees of what stands in rooms; none: rooms are walked bare
    accel::OctreeOptions octrees = device_octree_options();
    const accel::Executor* executor = nullptr;  ///< who builds the trees; nullptr: the calling thread
    RayOrder order = RayOrder::AsGiven;
    StreamSchedule schedule = StreamSchedule::Deferred;
    /// How sections lie in the device's memory, for all schedules but Whole. In furnished rooms Points is Pairs.
    SectionLayout layout = SectionLayout::Pairs;
    int refill = 12;              ///< Persistent: so many idle lanes fetch rays; 1 to 32
    bool sorts_questions = true;  ///< Compacted: those to one mesh together
    /// Longer streams are answered part by part, so that the memory of schedules is bounded: Deferred and Persistent
    /// need 4 bytes a ray, orders 16 and what the card's sort takes, Compacted 88.
    std::uint32_t rays_at_once = 1u << 24;
};

/// A scene on a device, and streams of rays through it. The answers are the scalar tracer's. The device must outlive
/// it.
class DeviceStream {
public:
    /// Uploads the scene. \throws CudaError, InputError for options out of range
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
    /// The scene's copy on the device, for kernels.
    [[nodiscard]] const accel::SceneView& scene() const;
    /// In the device's memory: the scene, its trees, and what the streams so far have needed.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace enfilade::render::cuda
