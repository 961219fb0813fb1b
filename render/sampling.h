#pragma once
// Directions for short rays, the same on every machine and in every run.

#include <cstdint>

#include "render/isa.h"
#include "render/vec.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// The R2 sequence (Roberts 2018) begun at a place hashed from the pixel.
class Sampler {
public:
    ENFILADE_HD Sampler(std::uint32_t x, std::uint32_t y) {
        std::uint32_t h = x * 0x8da6b343u ^ y * 0xd8163841u;
        h = (h ^ h >> 16) * 0x7feb352du;
        h = (h ^ h >> 15) * 0x846ca68bu;
        u_ = h ^ h >> 16;
        v_ = (h ^ h >> 13) * 0x9e3779b1u;
    }

    /// A unit direction around `normal` (level or upright), its density the cosine over pi.
    ENFILADE_HD Vec3f next_cosine_direction(Vec3f normal) {
        u_ += 3242174889u;  // 2^32 / 1.3247...
        v_ += 2447445414u;  // 2^32 / 1.3247...^2
        const float u = static_cast<float>(u_ >> 8) * 0x1p-24f;
        const float r = root(u), h = root(1 - u);
        const float c = turn_cosine(static_cast<float>(v_ >> 8) * 0x1p-24f);
        const float s = turn_cosine(static_cast<float>((v_ - 0x40000000u) >> 8) * 0x1p-24f);
        const bool upright = normal.z != 0;
        const Vec3f a = upright ? Vec3f{1, 0, 0} : Vec3f{-normal.y, normal.x, 0};
        const Vec3f b = upright ? Vec3f{0, 1, 0} : Vec3f{0, 0, 1};
        return (r * c) * a + (r * s) * b + h * normal;
    }

private:
    /// cos(2 pi t) for t in [0, 1), to 1e-3: a parabola and its correction.
    static ENFILADE_HD float turn_cosine(float t) {
        const float x = magnitude(t - 0.5f) * 4 - 1;  // 1 at t = 0, -1 at 1/2
        const float parabola = x * (2 - magnitude(x));
        return 0.775f * parabola + 0.225f * parabola * magnitude(parabola);
    }

    std::uint32_t u_, v_;
};

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
