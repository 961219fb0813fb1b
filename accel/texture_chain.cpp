#include "accel/texture_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "accel/srgb.h"

namespace enfilade::accel {
namespace {

/// Linear light times alpha, and alpha: what may be averaged.
using Light4 = std::array<float, 4>;

struct Picture {
    std::uint32_t width, height;
    std::vector<Light4> pixels;
};

Light4 light_of(const std::array<std::uint8_t, 4>& pixel) {
    const float alpha = static_cast<float>(pixel[3]) / 255.0f;
    return {alpha * linear_of_byte(pixel[0]), alpha * linear_of_byte(pixel[1]), alpha * linear_of_byte(pixel[2]),
            alpha};
}

/// The byte whose light is nearest to it.
std::uint8_t byte_of(float light) {
    const auto above = std::ranges::lower_bound(srgb_table, light);
    if (above == srgb_table.begin()) return 0;
    if (above == srgb_table.end()) return 255;
    const auto byte = static_cast<std::uint8_t>(above - srgb_table.begin());
    return light - *(above - 1) < *above - light ? static_cast<std::uint8_t>(byte - 1) : byte;
}

std::array<std::uint8_t, 4> pixel_of(const Light4& light) {
    if (!(light[3] > 0)) return {0, 0, 0, 0};
    const auto alpha = static_cast<std::uint8_t>(std::lround(255 * std::min(light[3], 1.0f)));
    return {byte_of(light[0] / light[3]), byte_of(light[1] / light[3]), byte_of(light[2] / light[3]), alpha};
}

/// What element k of `to` takes of `from` elements: the first, and each one's share, in sum 1.
struct Taps {
    std::uint32_t first;
    std::vector<float> shares;
};

std::vector<Taps> taps(std::uint32_t from, std::uint32_t to) {
    std::vector<Taps> all(to);
    for (std::uint64_t k = 0; k < to; ++k) {
        // In units of 1 / to of an element all is whole: [k from, (k + 1) from) meets element i in [i to, (i + 1) to).
        const std::uint64_t low = k * from, high = low + from;
        all[k].first = static_cast<std::uint32_t>(low / to);
        for (std::uint64_t i = low / to; i * to < high; ++i) {
            const std::uint64_t common = std::min(high, (i + 1) * to) - std::max(low, i * to);
            all[k].shares.push_back(static_cast<float>(double(common) / double(from)));
        }
    }
    return all;
}

/// Each pixel the mean over its rectangle of the larger picture.
Picture scaled(const Picture& from, std::uint32_t width, std::uint32_t height) {
    const std::vector<Taps> across = taps(from.width, width), down = taps(from.height, height);
    Picture result = {width, height, std::vector<Light4>(std::size_t{width} * height)};
    std::vector<Light4> row(from.width);
    for (std::uint32_t y = 0; y < height; ++y) {
        std::ranges::fill(row, Light4{});
        for (std::size_t j = 0; j < down[y].shares.size(); ++j) {
            const Light4* source = from.pixels.data() + (down[y].first + j) * from.width;
            for (std::uint32_t x = 0; x < from.width; ++x)
                for (std::size_t c = 0; c < 4; ++c) row[x][c] += down[y].shares[j] * source[x][c];
        }
        for (std::uint32_t x = 0; x < width; ++x) {
            Light4 sum = {};
            for (std::size_t j = 0; j < across[x].shares.size(); ++j)
                for (std::size_t c = 0; c < 4; ++c) sum[c] += across[x].shares[j] * row[across[x].first + j][c];
            result.pixels[std::size_t{y} * width + x] = sum;
        }
    }
    return result;
}

}  // namespace

InputTexture texture_chain(std::string name, std::uint32_t width, std::uint32_t height,
                           std::span<const std::array<std::uint8_t, 4>> pixels, std::uint32_t most_a_side) {
    Picture picture = {width, height, {}};
    picture.pixels.reserve(pixels.size());
    for (const auto& pixel : pixels) picture.pixels.push_back(light_of(pixel));
    const std::uint32_t longer = std::max(width, height);
    if (longer > most_a_side) {
        const auto fitted = [&](std::uint32_t n) {
            return std::max(1u, static_cast<std::uint32_t>(std::uint64_t{n} * most_a_side / longer));
        };
        picture = scaled(picture, fitted(width), fitted(height));
    }
    InputTexture texture = {
        std::move(name), picture.width, picture.height, level_count(picture.width, picture.height), {}};
    texture.texels.reserve(texel_count(picture.width, picture.height));
    for (std::uint32_t level = 0; level < texture.level_count; ++level) {
        const LevelSize size = level_size(texture.width, texture.height, level);
        if (level > 0) picture = scaled(picture, size.width, size.height);
        for (const Light4& light : picture.pixels) texture.texels.push_back(pixel_of(light));
    }
    return texture;
}

std::array<float, 4> mean_of(const InputTexture& texture) {
    const Light4 light = light_of(texture.texels.back());
    if (!(light[3] > 0)) return {0, 0, 0, 0};
    return {light[0] / light[3], light[1] / light[3], light[2] / light[3], light[3]};
}

}  // namespace enfilade::accel
