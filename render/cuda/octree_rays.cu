#include "render/cuda/octree_rays.h"

#include <algorithm>
#include <stdexcept>

#include "render/cuda/octree_kernels.h"

namespace enfilade::render::cuda {
namespace {

struct MakePrimary {
    CameraFrame camera;
    TiledPixels pixels;
    OctreeRay* rays;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        const TiledPixels::Pixel at = pixels.pixel(i);
        rays[i] = pixels.has(at) ? primary_ray(camera, at) : no_ray();
    }
};

struct MakeDiffuse {
    const OctreeRay* from;
    const OctreeAnswer* answers;
    const Quad* normals;
    float size;
    std::uint32_t seed;
    OctreeRay* rays;
    ENFILADE_HD void operator()(std::uint64_t i) const {
        const OctreeAnswer answer = answers[i];
        if (answer.triangle == no_triangle) {
            rays[i] = no_ray();
            return;
        }
        const Quad normal = normals[i];
        rays[i] = diffuse_ray(from[i], answer.t, {normal.x, normal.y, normal.z}, size,
                              mixed(seed ^ mixed(static_cast<std::uint32_t>(i))));
    }
};

template <class T>
std::vector<T> first_of(Device& device, const Buffer<T>& from, std::size_t count) {
    std::vector<T> values(count);
    if (count != 0) device.download(values.data(), from.data(), count * sizeof(T));
    return values;
}

void check_fits(std::uint64_t count, std::size_t capacity) {
    if (count > capacity) throw std::length_error("more rays than the batch was made for");
}

}  // namespace

OctreeRays::OctreeRays(Device& device, std::size_t capacity, bool has_normals)
    : device_(device),
      rays_(device, capacity),
      answers_(device, capacity),
      normals_(device, has_normals ? capacity : 0),
      next_(device, 1) {
    if (capacity >> 31 != 0) throw std::length_error("a batch holds at most 2^31 rays");
}

void OctreeRays::primary(const CameraFrame& camera, int width, int height) {
    const TiledPixels pixels = {width, height};
    check_fits(pixels.count(), rays_.size());
    count_ = static_cast<std::size_t>(pixels.count());
    for_each(device_, count_, MakePrimary{camera, pixels, rays_.data()});
}

void OctreeRays::diffuse(const OctreeRays& before, const DeviceOctree& tree, std::uint32_t seed) {
    check_fits(before.count_, rays_.size());
    if (before.normals_.size() == 0 && before.count_ != 0)
        throw std::invalid_argument("without normals nothing is sent on");
    count_ = before.count_;
    for_each(device_, count_,
             MakeDiffuse{before.rays_.data(), before.answers_.data(), before.normals_.data(), tree.size(), seed,
                         rays_.data()});
}

void OctreeRays::write(std::span<const OctreeRay> rays) {
    check_fits(rays.size(), rays_.size());
    count_ = rays.size();
    if (count_ != 0) device_.upload(rays_.data(), rays.data(), rays.size_bytes());
}

OctreeJob OctreeRays::job() const {
    OctreeJob job = {};
    job.rays = rays_.data();
    job.answers = answers_.data();
    job.normals = normals_.data();
    return job;
}

void OctreeRays::nearest(const DeviceOctree& tree, const OctreeSchedule& schedule) {
    if (count_ != 0) start_octree(device_, tree, job(), static_cast<std::uint32_t>(count_), schedule, next_);
}

void OctreeRays::blocked(const DeviceOctree& tree) {
    OctreeJob asked = job();
    asked.normals = nullptr;
    if (count_ != 0) start_octree_any(device_, tree, asked, static_cast<std::uint32_t>(count_));
}

std::vector<OctreeRay> OctreeRays::rays() const { return first_of(device_, rays_, count_); }
std::vector<OctreeAnswer> OctreeRays::answers() const { return first_of(device_, answers_, count_); }
std::vector<Quad> OctreeRays::normals() const { return first_of(device_, normals_, normals_.size() == 0 ? 0 : count_); }

std::size_t OctreeRays::hit_count() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(answers(), [](const OctreeAnswer& each) { return each.triangle != no_triangle; }));
}

OctreePictures::OctreePictures(Device& device, const DeviceOctree& tree, std::uint32_t background)
    : device_(device), tree_(tree), background_(background), next_(device, 1) {}

void OctreePictures::draw(const CameraFrame& frame, int width, int height, const OctreeSchedule& schedule) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (image_.size() < pixels) image_ = Buffer<std::uint32_t>(device_, pixels);
    width_ = width;
    height_ = height;
    OctreeJob job = {};
    job.camera = frame;
    job.pixels = {width, height};
    job.rgba = image_.data();
    job.background = background_;
    if (pixels != 0) start_octree(device_, tree_, job, static_cast<std::uint32_t>(job.pixels.count()), schedule, next_);
}

void OctreePictures::read(Framebuffer& framebuffer) const {
    if (framebuffer.width != width_ || framebuffer.height != height_) framebuffer = Framebuffer(width_, height_);
    if (!framebuffer.rgba.empty())
        device_.download(framebuffer.rgba.data(), image_.data(), framebuffer.rgba.size() * sizeof(std::uint32_t));
}

}  // namespace enfilade::render::cuda
