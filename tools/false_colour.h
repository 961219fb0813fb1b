#pragma once
// Numbers of pixels as a picture, with a bar below that says which colour is which number.

#include <span>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/ray_counts.h"

namespace enfilade::tools {

/// The numbers that the two ends of the colour scale stand for.
struct ScaleRange {
    double least = 0;
    double most = 1;  ///< what is above has its colour, and the bar says so
};

/// From the least number of all pictures to the one that this share of them does not exceed, NaN left out and at the
/// top also 0, of which there may be any number around what is seen; 0 to 1 where there is none. One more at the top
/// than at the bottom where these are the same.
[[nodiscard]] ScaleRange range_of(std::span<const render::PixelNumbers> pictures, double share = 1);

/// The lowest rows that the bar takes of an image of this size, less than half of it; 0 under 80 x 60 pixels.
[[nodiscard]] int bar_rows(int width, int height);

/// The numbers in colours (render::scale_colour), and below them `rows` more with a bar, its numbers and `caption`
/// (what pixel_font.h can write). `rows`: bar_rows() of the image that comes out.
[[nodiscard]] render::Image false_colour(const render::PixelNumbers& numbers, ScaleRange range,
                                         const std::string& caption, int rows);

/// Numbers at which a scale is marked: whole, evenly spaced in steps of 1, 2, 5, 10, 20 ..., at most `count` of them.
[[nodiscard]] std::vector<int> scale_marks(ScaleRange range, int count);

}  // namespace enfilade::tools
