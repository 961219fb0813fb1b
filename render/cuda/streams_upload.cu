#include "render/cuda/streams_upload.h"

#include <algorithm>

#include "base/error.h"
#include "render/cuda/buffer.h"

#if defined(__CUDACC__)
#include "render/cuda/check_call.h"
#endif

namespace enfilade::render::cuda {

struct CopyQueue::Parts {
    Device& device;
#if defined(__CUDACC__)
    cudaStream_t copies = nullptr;
    cudaEvent_t marks[2] = {nullptr, nullptr};
#endif
};

CopyQueue::CopyQueue(Device& device) : parts_(new Parts{device}) {
#if defined(__CUDACC__)
    if (!device.is_card()) return;
    check_call(cudaStreamCreateWithFlags(&parts_->copies, cudaStreamNonBlocking), "making a queue");
    for (cudaEvent_t& mark : parts_->marks)
        check_call(cudaEventCreateWithFlags(&mark, cudaEventDisableTiming), "making a mark");
#endif
}

CopyQueue::~CopyQueue() {
#if defined(__CUDACC__)
    for (cudaEvent_t mark : parts_->marks)
        if (mark != nullptr) cudaEventDestroy(mark);
    if (parts_->copies != nullptr) cudaStreamDestroy(parts_->copies);
#endif
}

void CopyQueue::upload(void* to, const void* from, std::size_t bytes) {
#if defined(__CUDACC__)
    if (parts_->device.is_card()) {
        check_call(cudaMemcpyAsync(to, from, bytes, cudaMemcpyHostToDevice, parts_->copies), "copying to it");
        check_call(cudaStreamSynchronize(parts_->copies), "copying to it");
        return;
    }
#endif
    parts_->device.upload(to, from, bytes);
}

void CopyQueue::mark_work([[maybe_unused]] int mark) {
#if defined(__CUDACC__)
    if (parts_->device.is_card())
        check_call(cudaEventRecord(parts_->marks[mark], static_cast<cudaStream_t>(parts_->device.stream())),
                   "marking its work");
#endif
}

void CopyQueue::download(void* to, const void* from, std::size_t bytes, [[maybe_unused]] int mark) {
#if defined(__CUDACC__)
    if (parts_->device.is_card()) {
        check_call(cudaStreamWaitEvent(parts_->copies, parts_->marks[mark], 0), "waiting for its work");
        check_call(cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToHost, parts_->copies), "copying from it");
        check_call(cudaStreamSynchronize(parts_->copies), "copying from it");
        return;
    }
#endif
    parts_->device.download(to, from, bytes);
}

namespace {

/// A column of the host and its part on the device.
template <class T>
class Column {
public:
    void reserve(Device& device, std::size_t count) {
        if (part_.size() < count) part_ = Buffer<T>(device, count);
    }
    [[nodiscard]] T* there() const { return part_.data(); }
    void upload(CopyQueue& queue, std::span<const T> column, std::size_t first, std::size_t count) const {
        if (!column.empty()) queue.upload(part_.data(), column.data() + first, count * sizeof(T));
    }
    void download(CopyQueue& queue, std::span<T> column, std::size_t first, std::size_t count, int mark) const {
        if (!column.empty()) queue.download(column.data() + first, part_.data(), count * sizeof(T), mark);
    }
    /// For a kernel: nullptr where the host has no such column.
    template <class Host>
    [[nodiscard]] T* for_column(const Host& column) const {
        return column.empty() ? nullptr : part_.data();
    }

private:
    Buffer<T> part_;
};

/// One of the two parts under way.
struct Part {
    Column<float> vector[2][3], max_distance, distance;
    Column<accel::CellId> cells[2];
    Column<accel::SourceFaceId> source_face;
    Column<WalkStatus> status;
    Column<accel::ObjectId> object;
    Column<std::uint32_t> triangle;
    Column<std::uint8_t> visible;
};

/// ask(k): uploads part k and asks for it; fetch(k): its answers, while the next part is worked on.
template <class Ask, class Fetch>
void in_turns(std::size_t parts, const Ask& ask, const Fetch& fetch) {
    for (std::size_t k = 0; k < parts; ++k) {
        ask(k);
        if (k > 0) fetch(k - 1);
    }
    if (parts > 0) fetch(parts - 1);
}

}  // namespace

struct UploadedStream::Parts {
    Device& device;
    DeviceStream& stream;
    std::size_t size;
    CopyQueue queue;
    Part parts[2];

    Parts(Device& device_, DeviceStream& stream_, std::uint32_t size_)
        : device(device_), stream(stream_), size(size_), queue(device_) {}

    void ask_nearest(const RayColumns& rays, const HitColumns& hits, Part& part, std::size_t first, std::size_t count) {
        const std::span<const float> from[2][3] = {{rays.origin_x, rays.origin_y, rays.origin_z},
                                                   {rays.direction_x, rays.direction_y, rays.direction_z}};
        for (int v = 0; v < 2; ++v)
            for (int k = 0; k < 3; ++k) upload(part.vector[v][k], from[v][k], first, count);
        upload(part.cells[0], rays.cell, first, count);
        upload(part.max_distance, rays.max_distance, first, count);
        reserve(part.distance, hits.distance, count);
        reserve(part.source_face, hits.source_face, count);
        reserve(part.cells[1], hits.cell, count);
        reserve(part.status, hits.status, count);
        reserve(part.object, hits.object, count);
        reserve(part.triangle, hits.triangle, count);
        const auto& v = part.vector;
        stream.nearest({{v[0][0].there(), v[0][1].there(), v[0][2].there()},
                        {v[1][0].there(), v[1][1].there(), v[1][2].there()},
                        part.cells[0].there(),
                        part.max_distance.for_column(rays.max_distance),
                        count},
                       {part.distance.for_column(hits.distance), part.source_face.for_column(hits.source_face),
                        part.cells[1].for_column(hits.cell), part.status.for_column(hits.status),
                        part.object.for_column(hits.object), part.triangle.for_column(hits.triangle)});
    }
    void fetch_nearest(const HitColumns& hits, const Part& part, std::size_t first, std::size_t count, int mark) {
        part.distance.download(queue, hits.distance, first, count, mark);
        part.source_face.download(queue, hits.source_face, first, count, mark);
        part.cells[1].download(queue, hits.cell, first, count, mark);
        part.status.download(queue, hits.status, first, count, mark);
        part.object.download(queue, hits.object, first, count, mark);
        part.triangle.download(queue, hits.triangle, first, count, mark);
    }
    void ask_visible(const SegmentColumns& segments, Part& part, std::size_t first, std::size_t count) {
        const std::span<const float> from[2][3] = {{segments.from_x, segments.from_y, segments.from_z},
                                                   {segments.to_x, segments.to_y, segments.to_z}};
        for (int v = 0; v < 2; ++v)
            for (int k = 0; k < 3; ++k) upload(part.vector[v][k], from[v][k], first, count);
        upload(part.cells[0], segments.from_cell, first, count);
        upload(part.cells[1], segments.to_cell, first, count);
        part.visible.reserve(device, count);
        const auto& v = part.vector;
        stream.visible({{v[0][0].there(), v[0][1].there(), v[0][2].there()},
                        {v[1][0].there(), v[1][1].there(), v[1][2].there()},
                        part.cells[0].there(),
                        part.cells[1].for_column(segments.to_cell),
                        count},
                       part.visible.there());
    }

    [[nodiscard]] std::size_t parts_of(std::size_t count) const { return (count + size - 1) / size; }
    [[nodiscard]] std::size_t size_of(std::size_t k, std::size_t count) const {
        return std::min(size, count - k * size);
    }

private:
    template <class T>
    void upload(Column<T>& column, std::span<const T> from, std::size_t first, std::size_t count) {
        if (from.empty()) return;
        column.reserve(device, count);
        column.upload(queue, from, first, count);
    }
    template <class T>
    void reserve(Column<T>& column, std::span<T> to, std::size_t count) {
        if (!to.empty()) column.reserve(device, count);
    }
};

UploadedStream::UploadedStream(Device& device, DeviceStream& stream, std::uint32_t part)
    : parts_(std::make_unique<Parts>(device, stream, part)) {
    if (part == 0) throw InputError("R1", "", "A stream travels in parts of one ray or more, not of 0.");
}

UploadedStream::~UploadedStream() = default;

void UploadedStream::nearest(const RayColumns& rays, const HitColumns& hits) {
    Parts& p = *parts_;
    const std::size_t count = rays.cell.size();
    in_turns(
        p.parts_of(count),
        [&](std::size_t k) {
            p.ask_nearest(rays, hits, p.parts[k % 2], k * p.size, p.size_of(k, count));
            p.queue.mark_work(static_cast<int>(k % 2));
        },
        [&](std::size_t k) {
            p.fetch_nearest(hits, p.parts[k % 2], k * p.size, p.size_of(k, count), static_cast<int>(k % 2));
        });
}

void UploadedStream::visible(const SegmentColumns& segments, std::span<std::uint8_t> visible) {
    Parts& p = *parts_;
    const std::size_t count = segments.from_cell.size();
    in_turns(
        p.parts_of(count),
        [&](std::size_t k) {
            p.ask_visible(segments, p.parts[k % 2], k * p.size, p.size_of(k, count));
            p.queue.mark_work(static_cast<int>(k % 2));
        },
        [&](std::size_t k) {
            p.parts[k % 2].visible.download(p.queue, visible, k * p.size, p.size_of(k, count), static_cast<int>(k % 2));
        });
}

}  // namespace enfilade::render::cuda
