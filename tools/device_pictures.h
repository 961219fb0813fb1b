#pragma once
// Pictures of a scene by the cuda tracer.

#include <memory>
#include <optional>
#include <string>

#include "render/cuda/pictures.h"
#include "tools/object_accel.h"
#include "tools/trace_flags.h"

namespace enfilade::tools {

class DevicePictures {
public:
    /// Opens the device, before any work. The executor must outlive this. Throws CudaError where there is none.
    DevicePictures(const TracerChoice::Device& choice, const accel::Executor& executor);

    /// Uploads the scene, whose memory must outlive this, with structures for its objects as the flags ask for.
    void show(const accel::SceneView& scene, const TracerChoice& tracer, const ObjectAccelChoice& objects);
    /// As render::trace. \pre show was called
    [[nodiscard]] render::Image trace(const render::Camera& camera, const render::TraceOptions& options);

    [[nodiscard]] const std::string& name() const { return device_->name(); }
    /// What the scene, its trees and images take in the device's memory.
    [[nodiscard]] std::size_t bytes() const { return pictures_ ? pictures_->bytes() : 0; }
    /// What is told of the structures of the scene's objects.
    [[nodiscard]] const ObjectsSummary& objects() const { return objects_; }

private:
    const accel::Executor& executor_;
    std::unique_ptr<render::cuda::Device> device_;
    std::optional<render::cuda::Pictures> pictures_;
    ObjectsSummary objects_;
};

/// Refuses structures of objects that no device walks. Throws InputError (F139).
void check_device_objects(const ObjectAccelChoice& objects);

}  // namespace enfilade::tools
