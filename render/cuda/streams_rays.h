#pragma once
// Rays that are made on a device, for benchmarks and tests: the same numbers on every device and on the host. Rooms are
// seen bare.

#include <cstdint>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/buffer.h"
#include "render/cuda/streams.h"

namespace enfilade::render::cuda {

/// Rays that own their columns.
class RayBuffers {
public:
    RayBuffers(Device& device, std::uint64_t count);

    [[nodiscard]] DeviceRays view() const;
    [[nodiscard]] std::uint64_t size() const { return cell_.size(); }
    // For kernels that write them.
    [[nodiscard]] float* origin(int axis) const { return origin_[axis].data(); }
    [[nodiscard]] float* direction(int axis) const { return direction_[axis].data(); }
    [[nodiscard]] accel::CellId* cell() const { return cell_.data(); }

private:
    Buffer<float> origin_[3], direction_[3];
    Buffer<accel::CellId> cell_;
};

/// Segments that own their columns.
class SegmentBuffers {
public:
    SegmentBuffers(Device& device, std::uint64_t count);

    [[nodiscard]] DeviceSegments view() const;
    [[nodiscard]] std::uint64_t size() const { return from_cell_.size(); }
    [[nodiscard]] float* from(int axis) const { return from_[axis].data(); }
    [[nodiscard]] float* to(int axis) const { return to_[axis].data(); }
    [[nodiscard]] accel::CellId* from_cell() const { return from_cell_.data(); }
    [[nodiscard]] accel::CellId* to_cell() const { return to_cell_.data(); }

private:
    Buffer<float> from_[3], to_[3];
    Buffer<accel::CellId> from_cell_, to_cell_;
};

/// A picture whose pixels' rays are wanted. Pixels come in tiles of 8 x 4, a warp's each, row by row; where the picture
/// is no multiple of that, row by row of pixels.
struct RayPicture {
    CameraFrame frame;
    accel::CellId start;  ///< holds the camera's eye
    int width, height;
};

/// One through the middle of each pixel.
[[nodiscard]] RayBuffers primary_rays(Device& device, const RayPicture& picture);

/// From where the primary rays end, sky included, `rays_a_pixel` diffuse ones each: directions hashed from pixel and
/// number, spread as the cosine to the normal (render/sampling.h). First one of each pixel, then the second of each.
/// scene: on the device
[[nodiscard]] RayBuffers bounce_rays(Device& device, const accel::SceneView& scene, const RayPicture& picture,
                                     std::uint32_t rays_a_pixel);

/// From where the primary rays end, `segments_a_pixel` each to lamps that are drawn by a hash, in the order of
/// bounce_rays. \pre the scene has lamps
[[nodiscard]] SegmentBuffers lamp_segments(Device& device, const accel::SceneView& scene, const RayPicture& picture,
                                           std::uint32_t segments_a_pixel);

/// The same rays as strangers to their neighbours: ray i is ray shuffled_place(i, size).
[[nodiscard]] RayBuffers shuffled(Device& device, const RayBuffers& rays);

/// A permutation of the numbers below `count`, without a table: rounds of mixing in a power of two, walked on from
/// numbers that are too large. count: 1 to 2^31
[[nodiscard]] ENFILADE_HD std::uint32_t shuffled_place(std::uint32_t i, std::uint32_t count) {
    std::uint32_t bits = 1;
    while ((count - 1) >> bits != 0) ++bits;
    const std::uint32_t mask = (1u << bits) - 1, half = (bits + 1) / 2;
    do {
        for (int round = 0; round < 3; ++round) {
            i = (i * 0x9e3779b1u + 0x7f4a7c15u) & mask;
            i ^= i >> half;
            i = i * 0x85ebca6bu & mask;
            i ^= i >> half;
        }
    } while (i >= count);
    return i;
}

}  // namespace enfilade::render::cuda
