#pragma once
// The ways by which a device answers streams of rays: everybody who takes part in checks and in contests of batches
// stands in one table (stream_ways.cpp), a line each.

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "accel/parallel_for.h"
#include "accel/scene.h"
#include "render/cuda/device.h"
#include "render/cuda/streams.h"
#include "render/object_tracer.h"

namespace enfilade::tools::gpu {

/// A scene on a device, ready for streams of rays. Answers are those of render::cuda::DeviceStream.
class StreamMaker {
public:
    virtual ~StreamMaker() = default;
    virtual void nearest(const render::cuda::DeviceRays& rays, const render::cuda::DeviceHits& hits) = 0;
    virtual void visible(const render::cuda::DeviceSegments& segments, std::uint8_t* visible) = 0;
    /// In the device's memory, without rays and answers.
    [[nodiscard]] virtual std::size_t bytes() const = 0;
};

struct StreamWay {
    std::string name;
    bool is_ours;                    ///< else a baseline
    bool is_exact;                   ///< the scalar tracer's formulas in their order: on the host the same bits
    render::ObjectAccelKind inside;  ///< with which structures inside of objects the scalar tracer is to be compared
    /// nullptr: this way has no such rooms.
    std::function<std::unique_ptr<StreamMaker>(render::cuda::Device& device, const accel::SceneView& scene,
                                               bool with_objects, const accel::Executor& executor)>
        open;
};

[[nodiscard]] const std::vector<StreamWay>& stream_ways();

}  // namespace enfilade::tools::gpu
