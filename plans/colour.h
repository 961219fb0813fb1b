#pragma once
// sRGB, as files write colours, to the linear RGB that the model holds, and back (IEC 61966-2-1).

#include <cmath>
#include <cstdint>

#include "plans/plan.h"

namespace enfilade::plans {

[[nodiscard]] inline float linear_from_srgb(std::uint32_t byte) {
    const double value = byte / 255.0;
    return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

/// [0, 1] to [0, 1].
[[nodiscard]] inline float srgb_from_linear(float linear) {
    const double value = double{linear};
    return static_cast<float>(value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
}

/// `rgb`: 0xRRGGBB; higher bits are ignored.
[[nodiscard]] inline Colour colour_from_rgb(std::uint32_t rgb) {
    return {linear_from_srgb((rgb >> 16) & 0xFF), linear_from_srgb((rgb >> 8) & 0xFF), linear_from_srgb(rgb & 0xFF)};
}

}  // namespace enfilade::plans
