// Texels as pictures see them, against plain averages over what a pixel covers.
#include "render/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "accel/srgb.h"
#include "accel/texture_chain.h"

namespace enfilade::render {
namespace {

/// A scene that has one texture and nothing else.
class OneTexture {
public:
    OneTexture(std::uint32_t width, std::uint32_t height, const std::vector<std::array<std::uint8_t, 4>>& pixels)
        : chain_(accel::texture_chain("t", width, height, pixels, 4096)) {
        for (const auto& t : chain_.texels) texels_.push_back({t[0], t[1], t[2], t[3]});
        texture_ = {0, static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), chain_.level_count, {}};
        view_.textures = {&texture_, 1};
        view_.texels = {texels_.data(), texels_.size()};
    }
    [[nodiscard]] TextureSample mean(const TextureSpot& spot) const {
        return texture_mean(view_, accel::TextureId{0}, spot);
    }
    /// The plain mean over the spot, by `n` x `n` places in it.
    [[nodiscard]] std::array<double, 4> brute(const TextureSpot& spot, int n) const {
        std::array<double, 4> sum = {};
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const double a = (i + 0.5) / n - 0.5, b = (j + 0.5) / n - 0.5;
                const double s = spot.s + a * double(spot.side_s[0]) + b * double(spot.side_s[1]);
                const double t = spot.t + a * double(spot.side_t[0]) + b * double(spot.side_t[1]);
                const auto x = std::min(static_cast<int>((s - std::floor(s)) * texture_.width), texture_.width - 1);
                const auto y = std::min(static_cast<int>((t - std::floor(t)) * texture_.height), texture_.height - 1);
                const accel::Texel& texel = texels_[static_cast<std::size_t>(y * texture_.width + x)];
                const double alpha = texel.a / 255.0;
                sum[0] += alpha * double(accel::linear_of_byte(texel.r));
                sum[1] += alpha * double(accel::linear_of_byte(texel.g));
                sum[2] += alpha * double(accel::linear_of_byte(texel.b));
                sum[3] += alpha;
            }
        for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[3] > 0 ? sum[c] / sum[3] : 0;
        sum[3] /= n * n;
        return sum;
    }

private:
    accel::InputTexture chain_;
    std::vector<accel::Texel> texels_;
    accel::Texture texture_ = {};
    accel::SceneView view_;
};

/// Waves of a few lengths, so that neighbouring texels are alike, as they are in pictures.
OneTexture waves(std::uint32_t width, std::uint32_t height) {
    std::vector<std::array<std::uint8_t, 4>> pixels;
    const auto byte = [](double v) { return static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * v)); };
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            const double a = 2 * std::numbers::pi * (x + 0.5) / width, b = 2 * std::numbers::pi * (y + 0.5) / height;
            pixels.push_back({byte(std::sin(a)), byte(std::sin(3 * b) * std::cos(2 * a)), byte(std::cos(a + b)), 255});
        }
    return {width, height, pixels};
}

TEST(TextureLooks, AreTheMeanOfWhatAPixelCovers) {
    const OneTexture texture = waves(128, 96);
    std::mt19937_64 random(4);
    const auto number = [&] { return static_cast<float>(random() >> 40) * 0x1p-24f; };
    double sum = 0;
    constexpr int trials = 400;
    for (int i = 0; i < trials; ++i) {
        const float turn = 6.2831853f * number(), size = std::exp2(-8 + 6 * number()), longer = 1 + 6 * number();
        TextureSpot spot = {number(), number(), {}, {}};
        spot.side_s[0] = longer * size * std::cos(turn);
        spot.side_t[0] = longer * size * std::sin(turn);
        spot.side_s[1] = -size * std::sin(turn);
        spot.side_t[1] = size * std::cos(turn);
        const TextureSample seen = texture.mean(spot);
        const std::array<double, 4> truth = texture.brute(spot, 48);
        const double error =
            std::max({std::abs(double(seen.colour.x) - truth[0]), std::abs(double(seen.colour.y) - truth[1]),
                      std::abs(double(seen.colour.z) - truth[2])});
        EXPECT_LT(error, 0.15) << "size " << size << ", longer " << longer;
        EXPECT_EQ(seen.alpha, 1.0f);
        sum += error;
    }
    EXPECT_LT(sum / trials, 0.02);
}

TEST(TextureLooks, FromAfarAreTheMeanOfTheWhole) {
    const OneTexture texture = waves(64, 64);
    const TextureSpot spot = {0.3f, 0.9f, {40, 0}, {0, 40}};
    const std::array<double, 4> truth = texture.brute({0.5f, 0.5f, {1, 0}, {0, 1}}, 64);
    EXPECT_NEAR(texture.mean(spot).colour.x, truth[0], 0.005);
    EXPECT_NEAR(texture.mean(spot).colour.y, truth[1], 0.005);
    EXPECT_NEAR(texture.mean(spot).colour.z, truth[2], 0.005);
}

TEST(TextureLooks, AtTheMiddleOfATexelAreItsColour) {
    const std::vector<std::array<std::uint8_t, 4>> pixels = {{255, 0, 0, 255},  {0, 255, 0, 255},
                                                             {0, 0, 255, 255},  {9, 99, 199, 255},
                                                             {80, 80, 80, 255}, {255, 255, 255, 255}};
    const OneTexture texture(3, 2, pixels);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x) {
            const TextureSpot spot = {(static_cast<float>(x) + 0.5f) / 3, (static_cast<float>(y) + 0.5f) / 2, {}, {}};
            const TextureSample seen = texture.mean(spot);
            const auto& p = pixels[static_cast<std::size_t>(3 * y + x)];
            EXPECT_NEAR(seen.colour.x, accel::linear_of_byte(p[0]), 1e-5);
            EXPECT_NEAR(seen.colour.y, accel::linear_of_byte(p[1]), 1e-5);
            EXPECT_NEAR(seen.colour.z, accel::linear_of_byte(p[2]), 1e-5);
        }
}

// Powers of two keep every number exact, so that repeats are the same bits.
TEST(TextureLooks, RepeatInBothDirections) {
    const OneTexture texture = waves(16, 16);
    for (const float s : {0.0f, 0.03125f, 0.5f, 0.96875f})
        for (const float t : {0.0f, 0.25f, 0.984375f})
            for (const float by : {-1.0f, -8.0f, 1.0f, 64.0f}) {
                const TextureSample here = texture.mean({s, t, {0.125f, 0}, {0, 0.125f}});
                const TextureSample there = texture.mean({s + by, t - 2 * by, {0.125f, 0}, {0, 0.125f}});
                EXPECT_EQ(here.colour, there.colour) << s << " " << t << " " << by;
            }
}

TEST(TextureLooks, GoOnAcrossTheBorderWithoutASeam) {
    const OneTexture texture = waves(32, 32);
    const TextureSample before = texture.mean({0.99999f, 0.3f, {}, {}}),
                        behind = texture.mean({0.00001f, 0.3f, {}, {}});
    EXPECT_NEAR(before.colour.x, behind.colour.x, 1e-3);
    EXPECT_NEAR(before.colour.z, behind.colour.z, 1e-3);
}

TEST(TextureLooks, OfNoNumbersReadNothingForeign) {
    const OneTexture texture = waves(5, 3);
    for (const float bad : {NAN, INFINITY, -INFINITY, 1e30f, -1e30f, -1e-30f, 16777217.5f}) {
        (void)texture.mean({bad, 0.5f, {bad, 0}, {0, bad}});
        (void)texture.mean({0.5f, bad, {0, 0}, {bad, bad}});
    }
}

TEST(TextureLooks, WhatIsSeenThroughCountsForTheShareAlone) {
    const OneTexture texture(2, 1, {{200, 10, 10, 255}, {10, 200, 10, 0}});
    const TextureSample seen = texture.mean({0.5f, 0.5f, {4, 0}, {0, 4}});
    EXPECT_NEAR(seen.alpha, 0.5, 0.01);
    EXPECT_NEAR(seen.colour.x, accel::linear_of_byte(200), 1e-4);
    EXPECT_NEAR(seen.colour.y, accel::linear_of_byte(10), 1e-4);
}

}  // namespace
}  // namespace enfilade::render
