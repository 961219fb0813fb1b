#pragma once
// Pictures by packets of a warp: whole tiles of the image by the rays through their corners (README.md, "Packets").

#include <cstdint>

#include "render/camera.h"
#include "render/cuda/device.h"
#include "render/cuda/device_objects.h"
#include "render/cuda/packets_counts.h"
#include "render/lamps.h"
#include "render/look.h"

namespace enfilade::render::cuda {

/// Sides of tiles in pixels, powers of two: a warp begins with 4 x 2 of the largest ones, and what does not agree below
/// the smallest ones is walked pixel by pixel.
struct PacketTiles {
    int largest = 16;  ///< 4 to 64
    int smallest = 4;  ///< 4 to `largest`
};

/// What counting speaks for: the largest tiles that still give each multiprocessor eight warps, for few pixels are
/// written while warps wait for each other's cells; the smallest where objects do not split most tiles anyway.
[[nodiscard]] PacketTiles tiles_for(int multiprocessors, int width, int height, bool is_furnished);

/// One frame, `Shading::Lambert`. Pointers are the device's.
struct PacketJob {
    const accel::SceneView* scene;  ///< on the host, its arrays on the device (copy_scene)
    CameraFrame camera;
    Look look;  ///< lambert_look
    accel::CellId start;
    float mirror_floor;  ///< share of light that floors reflect
    int width, height;
    std::uint32_t* rgba;  ///< [width * height], aligned to 16 bytes
    PacketTiles tiles;
    const DeviceObjects* objects = nullptr;  ///< nullptr: rooms are seen without what stands in them
    /// Of LampSearch::Tree (copy_trees), for bare rooms: `objects` is not read then. nullptr: a lamp at the eye
    const Lamps* lamps = nullptr;
};

/// Asks for the picture: every pixel is written once, whatever the size. \pre the tiles are sound
void draw_packets(Device& device, const PacketJob& job);

/// The same on this machine's memory, on the calling thread, and what it took.
[[nodiscard]] PacketCounts count_packets(const PacketJob& job);

}  // namespace enfilade::render::cuda
