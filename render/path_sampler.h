#pragma once
// Numbers that paths are drawn by: Sobol's first two dimensions, Owen-scrambled by hashes, anew for every pixel and
// every pair of numbers of a path (Burley 2020, "Practical Hash-based Owen Scrambling"; the hash is Vegdahl's variant
// of Laine and Karras 2011). A sample's numbers depend on its pixel and its index alone, not on who draws them or when.

#include <cstdint>

#include "render/isa.h"
#include "render/vec.h"

namespace enfilade::render {

/// Samples of a pixel are dealt in turn to so many sequences that know nothing of each other: what their means differ
/// by is the noise (path_trace.h).
inline constexpr std::uint32_t path_sequences = 4;

inline namespace ENFILADE_ISA {

struct Pair {
    float u, v;  ///< in [0, 1)
};

/// A hash whose every bit depends on every bit (Wellons' lowbias32).
ENFILADE_HD std::uint32_t mixed(std::uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

ENFILADE_HD std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
}

/// A permutation of numbers in which each bit decides on higher ones alone.
ENFILADE_HD std::uint32_t permuted(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    return x ^ x * 0x53a22864u;
}

/// The product with Pascal's triangle modulo 2: Sobol's second dimension, its digits from the lowest bit.
ENFILADE_HD std::uint32_t times_pascal(std::uint32_t x) {
    x ^= x >> 1 & 0x55555555u;
    x ^= x >> 2 & 0x33333333u;
    x ^= x >> 4 & 0x0f0f0f0fu;
    x ^= x >> 8 & 0x00ff00ffu;
    return x ^ (x >> 16 & 0x0000ffffu);
}

/// To [0, 1), never to 1.
ENFILADE_HD float unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// The numbers of one sample of one pixel (or place).
class PathSampler {
public:
    ENFILADE_HD PathSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t sample)
        : key_(mixed(mixed(mixed(seed ^ sample % path_sequences * 0x9e3779b9u) + x) + y)),
          index_(reversed(sample / path_sequences)) {}

    /// Two numbers; those of another `use` know nothing of them.
    [[nodiscard]] ENFILADE_HD Pair pair(std::uint32_t use) const {
        const std::uint32_t a = mixed(key_ + use * 0x9e3779b9u), b = mixed(a ^ 0x5bd1e995u), c = mixed(b ^ 0xc2b2ae35u);
        const std::uint32_t index = reversed(permuted(index_, a));
        return {unit_float(reversed(permuted(index, b))), unit_float(reversed(permuted(times_pascal(index), c)))};
    }

private:
    std::uint32_t key_, index_;
};

/// What a pair of numbers is drawn for.
enum class PathUse : std::uint32_t { Pixel, Direction, Choice, Lamp, Sun };
ENFILADE_HD std::uint32_t path_use(std::uint32_t bounce, PathUse use) {
    return bounce * 8 + static_cast<std::uint32_t>(use);
}
/// Balls have a pair each. bounce < 1024
ENFILADE_HD std::uint32_t path_use_of_lamp(std::uint32_t bounce, std::uint32_t lamp) {
    return (lamp + 16) * 1024 + bounce;
}

/// sin and cos of an eighth of a turn at most, to 3e-8.
ENFILADE_HD float small_sine(float x) {
    const float s = x * x;
    return x * (1 + s * (-1.0f / 6 + s * (1.0f / 120 + s * (-1.0f / 5040 + s * (1.0f / 362880)))));
}
ENFILADE_HD float small_cosine(float x) {
    const float s = x * x;
    return 1 + s * (-0.5f + s * (1.0f / 24 + s * (-1.0f / 720 + s * (1.0f / 40320))));
}

/// The unit disc, evenly: Shirley and Chiu's map, which keeps neighbours together.
ENFILADE_HD Pair on_disc(Pair p) {
    constexpr float eighth_turn = 0.785398163f;
    const float a = 2 * p.u - 1, b = 2 * p.v - 1;
    if (a == 0 && b == 0) return {0, 0};
    if (magnitude(a) > magnitude(b)) {
        const float angle = eighth_turn * (b / a);
        return {a * small_cosine(angle), a * small_sine(angle)};
    }
    const float angle = eighth_turn * (a / b);
    return {b * small_sine(angle), b * small_cosine(angle)};
}

/// Two directions that make a right-handed frame with a third (Duff et al. 2017). n of length 1
ENFILADE_HD void frame_of(Vec3f n, Vec3f& a, Vec3f& b) {
    const float sign = n.z < 0 ? -1.0f : 1.0f;
    const float c = -1 / (sign + n.z), d = n.x * n.y * c;
    a = {1 + sign * n.x * n.x * c, sign * d, -sign * n.x};
    b = {d, sign + n.y * n.y * c, -n.y};
}

/// A direction of length 1 around the normal, its density the cosine over pi.
ENFILADE_HD Vec3f cosine_direction(Vec3f normal, Pair p) {
    const Pair d = on_disc(p);
    const float rest = 1 - (d.u * d.u + d.v * d.v);
    Vec3f a, b;
    frame_of(normal, a, b);
    return d.u * a + d.v * b + root(rest > 0 ? rest : 0.0f) * normal;
}

/// A direction of length 1 around the axis, evenly among those at an angle to it of cosine 1 - height and more.
ENFILADE_HD Vec3f cone_direction(Vec3f axis, float height, Pair p) {
    const Pair d = on_disc(p);
    const float share = d.u * d.u + d.v * d.v;  // even in [0, 1)
    const float down = share * height;          // 1 - cosine
    const float spread = root(height * (2 - down));
    Vec3f a, b;
    frame_of(axis, a, b);
    return (spread * d.u) * a + (spread * d.v) * b + (1 - down) * axis;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
