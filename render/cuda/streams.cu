#include "render/cuda/streams.h"

#include <algorithm>

#include "render/cuda/device_scene.h"
#include "render/cuda/launch.h"
#include "render/stream_ray.h"

namespace enfilade::render::cuda {
namespace {

/// So many rays at a time: what a kernel can be asked for, and numbers of 32 bits.
constexpr std::uint64_t most_rays = 1u << 30;

/// A thread's ray.
template <class Rooms>
struct RayKernel {
    accel::SceneView scene;
    Rooms rooms;
    detail::StreamJob job;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        NoEvents none;
        answer_ray(scene, rooms, job, i, none);
    }
};

/// A thread's segment.
template <class Rooms>
struct SegmentKernel {
    accel::SceneView scene;
    Rooms rooms;
    detail::SegmentJob job;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        NoEvents none;
        answer_segment(scene, rooms, job, i, none);
    }
};

template <class T>
T* from(T* column, std::uint64_t first) {
    return column == nullptr ? nullptr : column + first;
}

/// The part of a stream that begins with ray `first`.
detail::StreamJob job_of(const DeviceRays& rays, const DeviceHits& hits, std::uint64_t first, std::uint64_t count) {
    detail::StreamJob job = {};
    for (int k = 0; k < 3; ++k) {
        job.origin[k] = from(rays.origin[k], first);
        job.direction[k] = from(rays.direction[k], first);
    }
    job.start = from(rays.cell, first);
    job.max_distance = from(rays.max_distance, first);
    job.distance = from(hits.distance, first);
    job.source_face = from(hits.source_face, first);
    job.cell = from(hits.cell, first);
    job.status = from(hits.status, first);
    job.object = from(hits.object, first);
    job.triangle = from(hits.triangle, first);
    job.end = count;
    return job;
}

detail::SegmentJob job_of(const DeviceSegments& segments, std::uint8_t* visible, std::uint64_t first,
                          std::uint64_t count) {
    detail::SegmentJob job = {};
    for (int k = 0; k < 3; ++k) {
        job.from[k] = from(segments.from[k], first);
        job.to[k] = from(segments.to[k], first);
    }
    job.from_cell = from(segments.from_cell, first);
    job.to_cell = from(segments.to_cell, first);
    job.visible = from(visible, first);
    job.end = count;
    return job;
}

}  // namespace

struct DeviceStream::Parts {
    Device& device;
    DeviceArrays arrays;
    accel::SceneView scene;
    std::optional<DeviceObjects> objects;

    Parts(Device& device_, const accel::SceneView& host, const DeviceStreamOptions& options)
        : device(device_), arrays(device_), scene(copy_scene(host, arrays)) {
        const accel::SerialExecutor serial;
        const accel::Executor& builders = options.executor != nullptr ? *options.executor : serial;
        if (options.inside && host.has_objects())
            objects.emplace(arrays, host, scene, *options.inside, options.octrees, builders);
    }

    /// Calls body(rooms) for what rays are to meet.
    template <class Body>
    void among_rooms(const Body& body) const {
        if (!objects) body(BareRooms{});
        else if (objects->kind() == InsideKind::Octree) body(RoomsWith<OctreeTrees>{objects->octrees()});
        else body(RoomsWith<MeshTrees>{objects->bvhs()});
    }
};

DeviceStream::DeviceStream(Device& device, const accel::SceneView& scene, const DeviceStreamOptions& options)
    : parts_(std::make_unique<Parts>(device, scene, options)) {}

DeviceStream::~DeviceStream() = default;

void DeviceStream::nearest(const DeviceRays& rays, const DeviceHits& hits) {
    const Parts& p = *parts_;
    for (std::uint64_t first = 0; first < rays.count; first += most_rays) {
        const detail::StreamJob job = job_of(rays, hits, first, std::min(most_rays, rays.count - first));
        p.among_rooms([&]<class Rooms>(const Rooms& rooms) {
            for_each(p.device, job.end, RayKernel<Rooms>{p.scene, rooms, job});
        });
    }
}

void DeviceStream::visible(const DeviceSegments& segments, std::uint8_t* visible) {
    const Parts& p = *parts_;
    for (std::uint64_t first = 0; first < segments.count; first += most_rays) {
        const detail::SegmentJob job = job_of(segments, visible, first, std::min(most_rays, segments.count - first));
        p.among_rooms([&]<class Rooms>(const Rooms& rooms) {
            for_each(p.device, job.end, SegmentKernel<Rooms>{p.scene, rooms, job});
        });
    }
}

std::size_t DeviceStream::bytes() const { return parts_->arrays.bytes(); }

}  // namespace enfilade::render::cuda
