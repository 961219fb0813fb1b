#include "render/cuda/pictures.h"

#include "render/cuda/buffer.h"
#include "render/cuda/device_scene.h"
#include "render/cuda/launch.h"
#include "render/lambert.h"

namespace enfilade::render::cuda {
namespace {

/// A thread's pixel.
struct LambertKernel {
    accel::SceneView scene;
    CameraFrame camera;
    Look look;
    std::uint32_t start_cell;
    float mirror_floor;
    int width;
    std::uint32_t* rgba;

    ENFILADE_HD void operator()(std::uint64_t i) const {
        const LambertPicture picture = {&scene, &camera, &look, start_cell, mirror_floor};
        const int x = static_cast<int>(i % static_cast<unsigned>(width));
        const int y = static_cast<int>(i / static_cast<unsigned>(width));
        NoEvents none;
        rgba[i] = encoded(lambert_pixel<float>(picture, BareRooms{}, x, y, none));
    }
};

}  // namespace

struct Pictures::Parts {
    Device& device;
    PictureOptions options;
    DeviceArrays arrays;
    accel::SceneView scene;
    int width = 0, height = 0;
    Buffer<std::uint32_t> image;

    Parts(Device& device_, const accel::SceneView& scene_, const PictureOptions& options_)
        : device(device_), options(options_), arrays(device_), scene(copy_scene(scene_, arrays)) {}
};

Pictures::Pictures(Device& device, const accel::SceneView& scene, const PictureOptions& options)
    : parts_(std::make_unique<Parts>(device, scene, options)) {}

Pictures::~Pictures() = default;

void Pictures::draw(const CameraFrame& frame, accel::CellId start, int width, int height) {
    Parts& p = *parts_;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (p.image.size() < pixels) p.image = Buffer<std::uint32_t>(p.device, pixels);
    p.width = width;
    p.height = height;
    const LambertKernel kernel = {
        p.scene, frame,         lambert_look({}), static_cast<std::uint32_t>(start), p.options.mirror_floor,
        width,   p.image.data()};
    for_each(p.device, pixels, kernel);
}

const std::uint32_t* Pictures::image() const { return parts_->image.data(); }

void Pictures::read(Framebuffer& framebuffer) const {
    const Parts& p = *parts_;
    if (framebuffer.width != p.width || framebuffer.height != p.height) framebuffer = Framebuffer(p.width, p.height);
    p.device.wait();
    if (!framebuffer.rgba.empty())
        p.device.download(framebuffer.rgba.data(), p.image.data(), framebuffer.rgba.size() * sizeof(std::uint32_t));
}

std::size_t Pictures::bytes() const { return parts_->arrays.bytes() + parts_->image.bytes(); }

}  // namespace enfilade::render::cuda
