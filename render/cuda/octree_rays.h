#pragma once
// Rays and pictures of one mesh by its octree on a device: what tables of single objects are measured with.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/camera.h"
#include "render/cuda/buffer.h"
#include "render/cuda/octree_arrays.h"
#include "render/cuda/octree_job.h"
#include "render/cuda/octree_schedule.h"
#include "render/framebuffer.h"

namespace enfilade::render::cuda {

/// A batch of rays in a device's memory with their answers: 40 bytes a ray, and 16 for its normal. At most 2^31.
class OctreeRays {
public:
    /// capacity: rays
    OctreeRays(Device& device, std::size_t capacity, bool has_normals);

    /// Those of a picture's pixels, tile by tile (TiledPixels::count() of them). \pre they fit
    void primary(const CameraFrame& camera, int width, int height);
    /// What matt surfaces send on from where the rays of `before` met the mesh, in their order; the others' ask for
    /// nothing. seed: draws the directions, with each ray's number. \pre they fit; before.nearest was asked, with
    /// normals
    void diffuse(const OctreeRays& before, const DeviceOctree& tree, std::uint32_t seed);
    /// \pre they fit
    void write(std::span<const OctreeRay> rays);

    /// The paper's octrees are walked a leaf each turn, whatever the schedule.
    void nearest(const DeviceOctree& tree, const OctreeSchedule& schedule);
    /// Whether each ray meets anything: answers with `triangle` 0 where it does.
    void blocked(const DeviceOctree& tree);

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] std::vector<OctreeRay> rays() const;
    [[nodiscard]] std::vector<OctreeAnswer> answers() const;
    [[nodiscard]] std::vector<Quad> normals() const;
    /// Rays that met something, by the answers.
    [[nodiscard]] std::size_t hit_count() const;

private:
    [[nodiscard]] OctreeJob job() const;

    Device& device_;
    std::size_t count_ = 0;
    Buffer<OctreeRay> rays_;
    Buffer<OctreeAnswer> answers_;
    Buffer<Quad> normals_;
    Buffer<std::uint32_t> next_;
};

/// Pictures of one mesh, matt white under a lamp at the eye.
class OctreePictures {
public:
    OctreePictures(Device& device, const DeviceOctree& tree, std::uint32_t background = 0xff000000u);
    /// Ends when the device has been asked, not when it is done.
    void draw(const CameraFrame& frame, int width, int height, const OctreeSchedule& schedule = {});
    /// Waits for it.
    void read(Framebuffer& framebuffer) const;

private:
    Device& device_;
    const DeviceOctree& tree_;
    std::uint32_t background_;
    int width_ = 0, height_ = 0;
    Buffer<std::uint32_t> image_, next_;
};

}  // namespace enfilade::render::cuda
