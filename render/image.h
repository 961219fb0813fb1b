#pragma once
// A picture in linear RGB.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/vec.h"

namespace enfilade::render {

/// Rows from the top, three floats a pixel.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;  ///< [3 * width * height]

    Image() = default;
    Image(int width_, int height_)
        : width(width_),
          height(height_),
          rgb(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}
    [[nodiscard]] Vec3f pixel(int x, int y) const {
        const float* p = rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x);
        return {p[0], p[1], p[2]};
    }
    friend bool operator==(const Image&, const Image&) = default;
};

/// The image as 8-bit sRGB (IEC 61966-2-1): [3 * width * height]. Values beyond [0, 1] are clipped.
[[nodiscard]] std::vector<std::uint8_t> to_srgb8(const Image& image);

}  // namespace enfilade::render
