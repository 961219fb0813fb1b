#pragma once
// Keys of rays for sorting them, on host and device.

#include <cstdint>

#include "render/cuda/ray_order.h"
#include "render/vec.h"

namespace enfilade::render::cuda {

/// Two zeros before each of the lower 10 bits.
ENFILADE_HD std::uint32_t spread_by_two(std::uint32_t a) {
    a = (a | a << 16) & 0x030000ffu;
    a = (a | a << 8) & 0x0300f00fu;
    a = (a | a << 4) & 0x030c30c3u;
    return (a | a << 2) & 0x09249249u;
}

/// One zero before each of the lower 8 bits.
ENFILADE_HD std::uint32_t spread_by_one(std::uint32_t a) {
    a = (a | a << 4) & 0x0f0fu;
    a = (a | a << 2) & 0x3333u;
    return (a | a << 1) & 0x5555u;
}

/// The step of [0, 1] that a number lies in, of `steps`; what is no number lies in the first.
ENFILADE_HD std::uint32_t step_of(float a, std::uint32_t steps) {
    const float at = a * static_cast<float>(steps);
    if (!(at > 0)) return 0;
    return at < static_cast<float>(steps) ? static_cast<std::uint32_t>(at) : steps - 1;
}

/// A direction as two numbers in [0, 1]: the octahedron's faces unfolded.
struct OctahedralPlace {
    float u, v;
};
ENFILADE_HD OctahedralPlace octahedral(Vec3f d) {
    const float sum = magnitude(d.x) + magnitude(d.y) + magnitude(d.z);
    const float x = d.x / sum, y = d.y / sum;
    const bool is_down = d.z < 0;
    const float u = is_down ? (1 - magnitude(y)) * (x < 0 ? -1.0f : 1.0f) : x;
    const float v = is_down ? (1 - magnitude(x)) * (y < 0 ? -1.0f : 1.0f) : y;
    return {0.5f * u + 0.5f, 0.5f * v + 0.5f};
}

/// The angle on the plan, from 0 to 1, monotonic all around.
ENFILADE_HD float plan_turn(float x, float y) {
    const float along = x / (magnitude(x) + magnitude(y));  // 1 at east, 0 at north and south, -1 at west
    return y < 0 ? 0.75f + 0.25f * along : 0.25f - 0.25f * along;
}

/// 21 bits of the origin, 10 of the direction below them.
ENFILADE_HD std::uint32_t morton_key(const OrderFrame& frame, Vec3f o, Vec3f d) {
    const std::uint32_t x = step_of((o.x - frame.low[0]) * frame.scale[0], 128),
                        y = step_of((o.y - frame.low[1]) * frame.scale[1], 128),
                        z = step_of((o.z - frame.low[2]) * frame.scale[2], 128);
    const OctahedralPlace to = octahedral(d);
    const std::uint32_t u = step_of(to.u, 32), v = step_of(to.v, 32);
    return (spread_by_two(x) | spread_by_two(y) << 1 | spread_by_two(z) << 2) << 10 | spread_by_one(u) |
           spread_by_one(v) << 1;
}

/// Bits that a number below `count` needs.
ENFILADE_HD std::uint32_t bits_for(std::uint32_t count) {
    std::uint32_t bits = 0;
    while (bits < 32 && (count - 1) >> bits != 0) ++bits;
    return bits;
}

/// The cell, and below it as many bits of the direction on the plan as there is room for, 8 at most.
ENFILADE_HD std::uint32_t cell_key(const OrderFrame& frame, std::uint32_t cell, Vec3f d) {
    const std::uint32_t cell_bits = bits_for(frame.cells);
    const std::uint32_t turn_bits = cell_bits > 24 ? 32 - cell_bits : 8;
    return cell << turn_bits | step_of(plan_turn(d.x, d.y), 1u << turn_bits);
}

/// Bits of such keys.
ENFILADE_HD int key_bits(const OrderFrame& frame, RayOrder order) {
    if (order == RayOrder::Morton) return 31;
    const std::uint32_t cell_bits = bits_for(frame.cells);
    return static_cast<int>(cell_bits > 24 ? 32 : cell_bits + 8);
}

}  // namespace enfilade::render::cuda
