#pragma once
// Texels as a picture sees them: the mean over what a pixel covers of the surface. Host and device.

#include "accel/scene.h"
#include "accel/srgb.h"
#include "render/isa.h"
#include "render/vec.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// What a pixel covers of a texture, in repeats of it: a parallelogram about (s, t) with two sides. s grows to the
/// right of the picture, t downward.
struct TextureSpot {
    float s, t;
    float side_s[2], side_t[2];
};

/// The mean colour of what is not seen through, linear RGB, and the share that is there.
struct TextureSample {
    Vec3f colour;
    float alpha;
};

/// The part of a number behind its whole part, in [0, 1); 0 where it is none.
ENFILADE_HD float fraction(float a) {
    const float rest = a - __builtin_floorf(a);
    return rest >= 0 && rest < 1 ? rest : 0.0f;
}

/// Light times alpha, and alpha, as they add up.
struct TexelSum {
    float r = 0, g = 0, b = 0, a = 0;
    ENFILADE_HD void add(const accel::Texel& texel, float weight) {
        const float alpha = weight * (static_cast<float>(texel.a) * (1.0f / 255));
        r += alpha * accel::linear_of_byte(texel.r);
        g += alpha * accel::linear_of_byte(texel.g);
        b += alpha * accel::linear_of_byte(texel.b);
        a += alpha;
    }
};

/// A level of a texture.
struct TextureLevel {
    std::uint32_t first_texel;
    std::uint32_t width, height;
};

ENFILADE_HD TextureLevel first_level(const accel::Texture& texture) {
    return {texture.first_texel, texture.width, texture.height};
}

ENFILADE_HD TextureLevel smaller_level(const TextureLevel& level) {
    return {level.first_texel + level.width * level.height, level.width > 1 ? level.width >> 1 : 1u,
            level.height > 1 ? level.height >> 1 : 1u};
}

/// Adds what lies between the centres of four texels. s, t in [0, 1)
ENFILADE_HD void add_bilinear(const accel::SceneView& scene, const TextureLevel& level, float s, float t, float weight,
                              TexelSum& sum) {
    const float x = s * static_cast<float>(level.width) + 0.5f, y = t * static_cast<float>(level.height) + 0.5f;
    const auto right = static_cast<std::uint32_t>(x), below = static_cast<std::uint32_t>(y);
    const float fx = x - static_cast<float>(right), fy = y - static_cast<float>(below);
    // Of column `right` and the one before it, counted round the border.
    const std::uint32_t x0 = right == 0 ? level.width - 1 : right - 1, x1 = right >= level.width ? 0 : right;
    const std::uint32_t y0 = below == 0 ? level.height - 1 : below - 1, y1 = below >= level.height ? 0 : below;
    const accel::Texel* texels = scene.texels.data() + level.first_texel;
    sum.add(texels[y0 * level.width + x0], weight * (1 - fx) * (1 - fy));
    sum.add(texels[y0 * level.width + x1], weight * fx * (1 - fy));
    sum.add(texels[y1 * level.width + x0], weight * (1 - fx) * fy);
    sum.add(texels[y1 * level.width + x1], weight * fx * fy);
}

/// Between the two levels whose texels are next to `width` texels of the first one in size.
ENFILADE_HD void add_trilinear(const accel::SceneView& scene, const accel::Texture& texture, float s, float t,
                               float width, float weight, TexelSum& sum) {
    TextureLevel level = first_level(texture);
    std::uint32_t k = 0;
    for (; width >= 2 && k + 1 < texture.level_count; ++k) {
        level = smaller_level(level);
        width *= 0.5f;
    }
    // Within an octave the straight line stands for the logarithm.
    const float next = width > 1 && k + 1 < texture.level_count ? (width < 2 ? width - 1 : 1.0f) : 0.0f;
    add_bilinear(scene, level, s, t, weight * (1 - next), sum);
    if (next > 0) add_bilinear(scene, smaller_level(level), s, t, weight * next, sum);
}

/// The mean over the spot: trilinear looks of the width of its shorter side, as many as fit into the longer one, eight
/// at most, beyond which it is blurred along both.
ENFILADE_HD TextureSample texture_mean(const accel::SceneView& scene, accel::TextureId id, const TextureSpot& spot) {
    constexpr int most_looks = 8;
    const accel::Texture& texture = scene.textures[static_cast<std::uint32_t>(id)];
    const auto w = static_cast<float>(texture.width), h = static_cast<float>(texture.height);
    float texels[2];
    for (int k = 0; k < 2; ++k) {
        const float x = spot.side_s[k] * w, y = spot.side_t[k] * h;
        texels[k] = root(x * x + y * y);
    }
    const int longer = texels[1] > texels[0] ? 1 : 0;
    const float shorter_width = larger(texels[1 - longer], 1.0f);
    int looks = 1;
    while (looks < most_looks && texels[longer] > static_cast<float>(looks) * shorter_width) ++looks;
    const float share = 1.0f / static_cast<float>(looks);
    const float width = larger(shorter_width, texels[longer] * share);
    TexelSum sum;
    for (int i = 0; i < looks; ++i) {
        const float at = (static_cast<float>(i) + 0.5f) * share - 0.5f;
        add_trilinear(scene, texture, fraction(spot.s + at * spot.side_s[longer]),
                      fraction(spot.t + at * spot.side_t[longer]), width, share, sum);
    }
    constexpr float whole = 1 - 0x1p-16f;  // but for the roundings of the weights
    if (!(sum.a > 0)) return {{0, 0, 0}, 0};
    const float inverse = 1 / sum.a;
    return {{inverse * sum.r, inverse * sum.g, inverse * sum.b}, sum.a < whole ? sum.a : 1.0f};
}

/// Row `k` of MaterialLook::texture_from_face.
ENFILADE_HD float texture_row(const accel::MaterialLook& look, int k, float u, float v, float one) {
    const float* row = reinterpret_cast<const float*>(&look.texture_from_face) + 3 * k;
    return row[0] * u + row[1] * v + row[2] * one;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
