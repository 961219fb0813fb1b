#include "render/cuda/streams.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/streams_run.h"

namespace enfilade::render::cuda {
namespace {

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

OrderedColumns columns_of(const detail::StreamJob& job) {
    return {{job.origin[0], job.origin[1], job.origin[2]},
            {job.direction[0], job.direction[1], job.direction[2]},
            false,
            job.start};
}

OrderedColumns columns_of(const detail::SegmentJob& job) {
    return {{job.from[0], job.from[1], job.from[2]}, {job.to[0], job.to[1], job.to[2]}, true, job.from_cell};
}

void check(const DeviceStreamOptions& options) {
    if (options.refill < 1 || options.refill > warp_size)
        throw InputError("R1", "",
                         "A warp fetches rays for 1 to 32 idle lanes, not for " + std::to_string(options.refill) + ".");
    if (options.rays_at_once == 0 || options.rays_at_once > 1u << 30)
        throw InputError("R1", "",
                         "A device answers 1 to 2^30 rays at once, not " + std::to_string(options.rays_at_once) + ".");
}

}  // namespace

struct DeviceStream::Parts {
    Device& device;
    DeviceStreamOptions options;
    DeviceArrays arrays;
    SceneCopies scenes;
    std::optional<DeviceObjects> objects;
    OrderFrame frame;
    KeySorter sorter;
    StreamRoom room;

    Parts(Device& device_, const accel::SceneView& host, const DeviceStreamOptions& options_)
        : device(device_), options(options_), arrays(device_), frame(order_frame(host)), sorter(device_) {
        check(options);
        scenes.columns = copy_scene(host, arrays);
        scenes.layout = options.layout;
        const bool is_furnished = options.inside && host.has_objects();
        if (is_furnished) {
            const accel::SerialExecutor serial;
            objects.emplace(arrays, host, scenes.columns, *options.inside, options.octrees,
                            options.executor != nullptr ? *options.executor : serial);
            if (options.layout == SectionLayout::Points) scenes.layout = SectionLayout::Pairs;
        }
        if (options.schedule == StreamSchedule::Whole) scenes.layout = SectionLayout::Columns;
        if (scenes.layout == SectionLayout::Points)
            scenes.points = copy_packed<false>(scenes.columns, PackedArrays(host), arrays);
        if (scenes.layout == SectionLayout::Pairs)
            scenes.pairs = copy_packed<true>(scenes.columns, PackedArrays(host), arrays);
        room.counts = Buffer<std::uint32_t>(device, StreamRoom::counters);
    }

    /// Room for a part of so many rays.
    void reserve(std::uint32_t count) {
        grow(room.rare, count);
        if (!objects || options.schedule != StreamSchedule::Compacted) return;
        for (int k = 0; k < 2; ++k) {
            grow(room.questions[k], count);
            grow(room.walks[k], count);
        }
        grow(room.answers, count);
    }

    template <class T>
    void grow(Buffer<T>& buffer, std::uint32_t count) {
        if (buffer.size() >= count) return;
        buffer = {};
        buffer = Buffer<T>(device, count);
    }

    /// One part of a stream.
    template <class Question>
    void ask(const Question& question, std::uint32_t count) {
        const DeviceObjects* inside = objects ? &*objects : nullptr;
        const std::uint32_t* order = order_rays(device, sorter, frame, options.order, columns_of(question.job), count);
        const auto run = [&] { return StreamRun{device, scenes, inside, options, room, sorter, {order, count}}; };
        if (options.schedule == StreamSchedule::Whole) return ask_whole(run(), question);
        reserve(count);
        room.counts.clear();
        if (inside == nullptr) ask_bare(run(), question);
        else if (options.schedule == StreamSchedule::Compacted) ask_compacted(run(), question);
        else ask_furnished(run(), question);
        ask_rare(run(), question);
    }
};

DeviceStream::DeviceStream(Device& device, const accel::SceneView& scene, const DeviceStreamOptions& options)
    : parts_(std::make_unique<Parts>(device, scene, options)) {}

DeviceStream::~DeviceStream() = default;

void DeviceStream::nearest(const DeviceRays& rays, const DeviceHits& hits) {
    const std::uint64_t most = parts_->options.rays_at_once;
    for (std::uint64_t first = 0; first < rays.count; first += most) {
        const std::uint64_t count = std::min(most, rays.count - first);
        parts_->ask(NearestQuestion{job_of(rays, hits, first, count)}, static_cast<std::uint32_t>(count));
    }
}

void DeviceStream::visible(const DeviceSegments& segments, std::uint8_t* visible) {
    const std::uint64_t most = parts_->options.rays_at_once;
    for (std::uint64_t first = 0; first < segments.count; first += most) {
        const std::uint64_t count = std::min(most, segments.count - first);
        parts_->ask(VisibleQuestion{job_of(segments, visible, first, count)}, static_cast<std::uint32_t>(count));
    }
}

const accel::SceneView& DeviceStream::scene() const { return parts_->scenes.columns; }

std::size_t DeviceStream::bytes() const {
    return parts_->arrays.bytes() + parts_->room.bytes() + parts_->sorter.bytes();
}

}  // namespace enfilade::render::cuda
