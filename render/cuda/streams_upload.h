#pragma once
// Streams whose columns lie in the host's memory: they travel part by part, while the device works on the part before.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "render/cuda/streams.h"
#include "render/ray_stream.h"

namespace enfilade::render::cuda {

/// Copies between the host and a card beside the card's work, in a queue of their own; between the host's own memories
/// at once. Memory of a host program that is page-locked (cudaHostRegister) travels faster.
class CopyQueue {
public:
    explicit CopyQueue(Device& device);
    CopyQueue(const CopyQueue&) = delete;
    CopyQueue& operator=(const CopyQueue&) = delete;
    ~CopyQueue();

    /// Returns once it is there.
    void upload(void* to, const void* from, std::size_t bytes);
    /// Marks the end of the work asked for so far. mark: 0 or 1, whose last mark is forgotten
    void mark_work(int mark);
    /// Downloads after the marked work; returns once it is here.
    void download(void* to, const void* from, std::size_t bytes, int mark);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// Answers streams of any length with the memory of two parts.
class UploadedStream {
public:
    /// Both must outlive it. part: rays at a time. \throws InputError for 0
    UploadedStream(Device& device, DeviceStream& stream, std::uint32_t part = 1u << 22);
    UploadedStream(const UploadedStream&) = delete;
    UploadedStream& operator=(const UploadedStream&) = delete;
    ~UploadedStream();

    /// As render::nearest and render::visible; returns when all is answered.
    void nearest(const RayColumns& rays, const HitColumns& hits);
    void visible(const SegmentColumns& segments, std::span<std::uint8_t> visible);

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace enfilade::render::cuda
