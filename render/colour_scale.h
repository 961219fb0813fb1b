#pragma once
// Numbers as colours, in an order that eyes see.

#include "render/vec.h"

namespace enfilade::render {

/// Colours from dark violet by blue and green to bright yellow, `t` from 0 to 1 (beyond: the ends; NaN: grey).
/// Lightness rises evenly as OKLab has it, so the order is seen in grey and by the colour-blind, too; hue turns evenly;
/// chroma is what sRGB can show of 0.15. Returns linear RGB within [0, 1].
/// Source: B. Ottosson, "A perceptual color space for image processing", 2020, for OKLab.
[[nodiscard]] Vec3f scale_colour(double t);

/// Lightness of a linear RGB colour in OKLab: 0 black, 1 white.
[[nodiscard]] double oklab_lightness(Vec3f linear);

}  // namespace enfilade::render
