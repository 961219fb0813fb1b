#pragma once
// Textures as scenes hold them: pictures scaled down to a size, with all their smaller levels.

#include <array>
#include <cstdint>
#include <span>
#include <string>

#include "accel/scene_input.h"

namespace enfilade::accel {

/// The levels of a picture of `width` x `height` pixels (row by row from the top; sRGB, alpha linear). A picture with
/// more than `most_a_side` texels a side is scaled down first, its shape kept. Every texel of a level is the mean of
/// the picture's light over its rectangle, each pixel by its alpha, rounded once: rounding does not add up from level
/// to level. \pre width, height, most_a_side > 0; pixels.size() == width * height
[[nodiscard]] InputTexture texture_chain(std::string name, std::uint32_t width, std::uint32_t height,
                                         std::span<const std::array<std::uint8_t, 4>> pixels,
                                         std::uint32_t most_a_side);

/// The texels of one level, and of all from it on.
struct LevelSize {
    std::uint32_t width, height;
};
[[nodiscard]] constexpr LevelSize level_size(std::uint32_t width, std::uint32_t height, std::uint32_t level) {
    const auto halved = [&](std::uint32_t n) { return level < 32 && n >> level > 0 ? n >> level : 1u; };
    return {halved(width), halved(height)};
}

/// Levels from width x height down to one texel.
[[nodiscard]] constexpr std::uint32_t level_count(std::uint32_t width, std::uint32_t height) {
    std::uint32_t count = 1;
    for (std::uint32_t n = width > height ? width : height; n > 1; n >>= 1) ++count;
    return count;
}

[[nodiscard]] constexpr std::uint64_t texel_count(std::uint32_t width, std::uint32_t height) {
    std::uint64_t count = 0;
    for (std::uint32_t l = 0; l < level_count(width, height); ++l) {
        const LevelSize size = level_size(width, height, l);
        count += std::uint64_t{size.width} * size.height;
    }
    return count;
}

/// The mean light of a texture, linear RGB, by alpha; and the mean of its alpha.
[[nodiscard]] std::array<float, 4> mean_of(const InputTexture& texture);

}  // namespace enfilade::accel
