#pragma once
// Who schedules the walk.

namespace enfilade::render {

enum class Tracer {
    Scalar,  ///< one ray at a time
    Simd,    ///< as many rays as a register has lanes, together, with masks
    Packet   ///< tiles of the image, by their corner rays; Simd where a tile is small, and for rays without a camera
};

/// Tiles that packets begin with, and below which rays are walked one by one in lanes. Powers of two, pixels a side.
struct PacketSizes {
    int largest = 64;  ///< 16 to 256
    int smallest = 8;  ///< 4 to `largest`
};

}  // namespace enfilade::render
