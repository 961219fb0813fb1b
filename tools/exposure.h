#pragma once
// How bright pictures are, and how bright they are made.

#include <span>

#include "render/camera.h"
#include "render/image.h"

namespace enfilade::tools {

inline constexpr double darkest_ev = -20, brightest_ev = 30;  ///< beyond starlight and the sun's disc
inline constexpr double daylight_ev = 13;                     ///< at which the sky of render/look.h is as it is there

/// Luminance (candela / m2) that becomes white in a picture of this exposure value (of ISO 100: 1.2 * 2^EV), and back.
[[nodiscard]] double white_luminance(double ev);
[[nodiscard]] double exposure_value(double white_luminance);

/// The exposure value, in tenths, at which 97 % of the lit pixels of the pictures stay under white; `usual`
/// where no pixel is lit. images: candela / m2, linear RGB
[[nodiscard]] double metered_ev(std::span<const render::Image> images, double usual);

/// The same camera with at most `side` pixels a side.
[[nodiscard]] render::Camera small_camera(render::Camera camera, int side);

}  // namespace enfilade::tools
