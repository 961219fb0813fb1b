#pragma once
// Pictures by a device: the scalar tracer's pixels, a thread a pixel.

#include <cstddef>
#include <memory>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/device.h"
#include "render/cuda/picture_options.h"
#include "render/framebuffer.h"
#include "render/image.h"
#include "render/trace.h"

namespace enfilade::render::cuda {

/// A scene on a device and what its pictures need there: uploaded once, for any number of them. The device and the
/// scene's memory must outlive it.
class Pictures {
public:
    /// Uploads the scene, and the trees of objects and lamps that the options ask for. \throws CudaError
    Pictures(Device& device, const accel::SceneView& scene, const PictureOptions& options = {});
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;
    ~Pictures();

    /// Asks for one frame as the options say, as trace_lambert draws it, into the device's image, whose size it changes
    /// where it must. \pre `start` holds the camera's eye
    void draw(const CameraFrame& frame, accel::CellId start, int width, int height);
    /// The device's image: rows from the top, as Framebuffer has them.
    [[nodiscard]] const std::uint32_t* image() const;
    /// A copy of it; waits for what was asked for.
    void read(Framebuffer& framebuffer) const;

    /// The picture that render::trace gives with the scalar tracer, of any options but those that only tracers of the
    /// CPU read: tracer, packets, executor, objects (the trees on the device stand for them). Light trees that are
    /// asked for are made on the device's own host, or taken from the options, once. Nothing is counted. \throws
    /// InputError as render::trace, and if the rays are to be counted (R4); CudaError
    [[nodiscard]] Image trace(const Camera& camera, const TraceOptions& options);

    void set_schedule(const PictureSchedule& schedule);
    /// Of the trees inside of objects in the device's memory.
    [[nodiscard]] std::size_t object_bytes() const;
    /// Of the scene, its trees and images in the device's memory.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// One picture of a scene: uploads it for that. Of several, keep Pictures. \throws as Pictures::trace
[[nodiscard]] Image trace_on(Device& device, const accel::SceneView& scene, const Camera& camera,
                             const TraceOptions& options, const PictureOptions& how = {});

}  // namespace enfilade::render::cuda
