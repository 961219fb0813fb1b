#pragma once
// The one colour of a picture.

#include <array>
#include <optional>
#include <string_view>

namespace enfilade::modeler {

/// The mean of a PNG's or JPEG's pixels in linear RGB, each by its alpha. Nothing for what is neither, is damaged, has
/// more than 2^26 pixels, or is wholly transparent. JPEGs of more than 64 pixels a side are averaged in blocks of 8 x 8
/// before they are made linear.
[[nodiscard]] std::optional<std::array<float, 3>> mean_colour(std::string_view bytes);

/// sRGB in [0, 1] to linear (IEC 61966-2-1).
[[nodiscard]] std::array<float, 3> linear_colour(const std::array<double, 3>& srgb);

}  // namespace enfilade::modeler
