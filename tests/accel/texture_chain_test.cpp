// The levels of textures: sizes, means, and the curve of sRGB.
#include "accel/texture_chain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "accel/srgb.h"

namespace enfilade::accel {
namespace {

using Pixels = std::vector<std::array<std::uint8_t, 4>>;

Pixels noise(std::uint32_t width, std::uint32_t height, std::uint64_t seed, bool is_opaque) {
    std::uint64_t state = seed;
    const auto byte = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint8_t>(state >> 56);
    };
    Pixels pixels(std::size_t{width} * height);
    for (auto& p : pixels) p = {byte(), byte(), byte(), is_opaque ? std::uint8_t{255} : byte()};
    return pixels;
}

TEST(Srgb, IsTheCurveOfTheStandard) {
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        EXPECT_NEAR(linear_of_byte(static_cast<std::uint8_t>(i)), linear, 1e-7) << i;
    }
}

TEST(TextureChain, HasAllLevelsDownToOneTexel) {
    const InputTexture t = texture_chain("odd", 37, 5, noise(37, 5, 1, true), 1024);
    EXPECT_EQ(t.width, 37u);
    EXPECT_EQ(t.height, 5u);
    EXPECT_EQ(t.level_count, 6u);
    EXPECT_EQ(t.texels.size(), 37u * 5 + 18 * 2 + 9 + 4 + 2 + 1);
}

TEST(TextureChain, ScalesDownWhatIsTooLargeAndKeepsItsShape) {
    const InputTexture t = texture_chain("wide", 300, 100, noise(300, 100, 2, true), 64);
    EXPECT_EQ(t.width, 64u);
    EXPECT_EQ(t.height, 21u);
    EXPECT_EQ(texture_chain("thin", 1000, 1, noise(1000, 1, 2, true), 10).height, 1u);
}

/// Mean of light times alpha, and of alpha, of one level.
std::array<double, 4> level_mean(const InputTexture& t, std::uint32_t level) {
    std::uint64_t first = 0;
    for (std::uint32_t l = 0; l < level; ++l)
        first += std::uint64_t{level_size(t.width, t.height, l).width} * level_size(t.width, t.height, l).height;
    const LevelSize size = level_size(t.width, t.height, level);
    std::array<double, 4> sum = {};
    for (std::uint64_t i = first; i < first + std::uint64_t{size.width} * size.height; ++i) {
        const double alpha = t.texels[i][3] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += alpha * linear_of_byte(t.texels[i][c]);
        sum[3] += alpha;
    }
    for (double& s : sum) s /= double(size.width) * size.height;
    return sum;
}

TEST(TextureChain, EveryLevelHasTheMeanOfThePicture) {
    for (const bool is_opaque : {true, false})
        for (const auto& [w, h] : {std::pair{64u, 64u}, {61u, 35u}, {7u, 129u}}) {
            const InputTexture t = texture_chain("noise", w, h, noise(w, h, w, is_opaque), 4096);
            const std::array<double, 4> mean = level_mean(t, 0);
            for (std::uint32_t l = 1; l < t.level_count; ++l)
                for (std::size_t c = 0; c < 4; ++c)
                    EXPECT_NEAR(level_mean(t, l)[c], mean[c], 0.006) << w << " x " << h << ", level " << l;
        }
}

// Black and white in turn give light of a half, which is sRGB 188, not 128.
TEST(TextureChain, AveragesLightAndNotBytes) {
    Pixels board(64);
    for (std::size_t i = 0; i < 64; ++i)
        board[i] = (i + i / 8) % 2 == 0 ? std::array<std::uint8_t, 4>{0, 0, 0, 255}
                                        : std::array<std::uint8_t, 4>{255, 255, 255, 255};
    const InputTexture t = texture_chain("board", 8, 8, board, 1024);
    EXPECT_EQ(t.texels.back(), (std::array<std::uint8_t, 4>{188, 188, 188, 255}));
}

TEST(TextureChain, WhatIsWhollySeenThroughDoesNotColourItsNeighbours) {
    const Pixels two = {{200, 10, 10, 255}, {10, 200, 10, 0}};
    const InputTexture t = texture_chain("leaf", 2, 1, two, 1024);
    EXPECT_EQ(t.texels.back(), (std::array<std::uint8_t, 4>{200, 10, 10, 128}));
}

TEST(TextureChain, EveryByteComesBackFromItsLight) {
    for (int i = 0; i < 256; ++i) {
        const auto b = static_cast<std::uint8_t>(i);
        const InputTexture t = texture_chain("flat", 2, 2, Pixels(4, {b, b, b, 255}), 1024);
        EXPECT_EQ(t.texels.back()[0], b);
    }
}

}  // namespace
}  // namespace enfilade::accel
