#include "render/image.h"

#include <algorithm>
#include <cmath>

namespace enfilade::render {

std::vector<std::uint8_t> to_srgb8(const Image& image) {
    std::vector<std::uint8_t> bytes(image.rgb.size());
    std::ranges::transform(image.rgb, bytes.begin(), [](float linear) {
        const float v = linear > 0 ? std::min(linear, 1.0f) : 0.0f;  // NaN becomes black
        const float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
        return static_cast<std::uint8_t>(std::lround(255 * encoded));
    });
    return bytes;
}

}  // namespace enfilade::render
