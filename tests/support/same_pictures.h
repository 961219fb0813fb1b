#pragma once
// Pictures of a device and of the scalar tracer: the same bits where the same formulas are compiled by the same
// compiler; on a card the same colours, but for one pixel in 100,000.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "render/cuda/device.h"
#include "render/framebuffer.h"
#include "render/image.h"

namespace enfilade::test {

class SamePictures {
public:
    explicit SamePictures(const render::cuda::Device& device) : is_exact_(!device.is_card()) {}
    SamePictures(const SamePictures&) = delete;
    SamePictures& operator=(const SamePictures&) = delete;
    ~SamePictures() { EXPECT_LE(differing_, is_exact_ ? 0 : 1 + pixels_ / 100'000) << first_ << ", of " << pixels_; }

    void add(const render::Image& expected, const render::Image& actual, const std::string& name) {
        ASSERT_EQ(expected.width, actual.width);
        ASSERT_EQ(expected.height, actual.height);
        for (std::size_t i = 0; i + 2 < expected.rgb.size(); i += 3) {
            bool same = true;
            for (std::size_t k = i; k < i + 3; ++k) same = same && is_same(expected.rgb[k], actual.rgb[k]);
            count(same, name, i / 3, static_cast<std::size_t>(expected.width));
            if (expected.rgb[i] + expected.rgb[i + 1] + expected.rgb[i + 2] > 0) ++lit_;
        }
    }
    void add(const render::Framebuffer& expected, const render::Framebuffer& actual, const std::string& name) {
        ASSERT_EQ(expected.width, actual.width);
        ASSERT_EQ(expected.height, actual.height);
        for (std::size_t i = 0; i < expected.rgba.size(); ++i) {
            bool same = true;
            for (int shift = 0; shift < 32; shift += 8) {
                const int a = static_cast<int>(expected.rgba[i] >> shift & 255u);
                const int b = static_cast<int>(actual.rgba[i] >> shift & 255u);
                same = same && std::abs(a - b) <= (is_exact_ ? 0 : 1);
            }
            count(same, name, i, static_cast<std::size_t>(expected.width));
            if ((expected.rgba[i] & 0xffffffu) != 0) ++lit_;
        }
    }
    [[nodiscard]] std::size_t pixels() const { return pixels_; }
    /// Pixels that were expected to show anything at all.
    [[nodiscard]] std::size_t lit() const { return lit_; }

private:
    [[nodiscard]] bool is_same(float a, float b) const {
        if (is_exact_) return std::memcmp(&a, &b, sizeof a) == 0;
        return a == b || std::abs(a - b) <= 1e-3f * std::max(std::abs(a), std::abs(b));
    }
    void count(bool same, const std::string& name, std::size_t pixel, std::size_t width) {
        ++pixels_;
        if (same) return;
        if (differing_++ == 0)
            first_ = name + ": the first at " + std::to_string(pixel % width) + ", " + std::to_string(pixel / width);
    }

    bool is_exact_;
    std::size_t pixels_ = 0, differing_ = 0, lit_ = 0;
    std::string first_ = "none differs";
};

}  // namespace enfilade::test
