#pragma once
// Pictures by a device: the walk of render/walk.h, a thread a pixel.

#include <cstddef>
#include <memory>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/device.h"
#include "render/framebuffer.h"
#include "render/look.h"

namespace enfilade::render::cuda {

struct PictureOptions {
    float mirror_floor = 0;
};

/// A scene on a device and what its pictures need there. Both must outlive it.
class Pictures {
public:
    /// Uploads the scene. \throws CudaError
    Pictures(Device& device, const accel::SceneView& scene, const PictureOptions& options = {});
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;
    ~Pictures();

    /// Asks for one frame, `Shading::Lambert`, into the device's image, whose size it changes where it must. \pre
    /// `start` holds the camera's eye
    void draw(const CameraFrame& frame, accel::CellId start, int width, int height);
    /// The device's image: rows from the top, as Framebuffer has them.
    [[nodiscard]] const std::uint32_t* image() const;
    /// A copy of it; waits for what was asked for.
    void read(Framebuffer& framebuffer) const;
    /// Of the scene and its image in the device's memory.
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace enfilade::render::cuda
