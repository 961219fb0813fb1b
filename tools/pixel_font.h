#pragma once
// Letters of 5 x 7 pixels, for numbers in pictures.

#include <string_view>

#include "render/image.h"

namespace enfilade::tools {

inline constexpr int glyph_width = 5;
inline constexpr int glyph_height = 7;
inline constexpr int glyph_step = 6;  ///< from letter to letter

/// Writes `text` with its upper left corner at (x, y), every dot of a letter a square of `scale` pixels. Letters that
/// the font lacks are left blank, and what lies beyond the picture is cut off.
void draw_text(render::Image& image, int x, int y, int scale, std::string_view text, render::Vec3f colour);

/// Pixels from the first to the last column of `text`.
[[nodiscard]] constexpr int text_width(std::string_view text, int scale) {
    return text.empty() ? 0 : scale * (int(text.size()) * glyph_step - (glyph_step - glyph_width));
}

/// Fills a rectangle, cut off at the picture's borders.
void fill_rectangle(render::Image& image, int x, int y, int width, int height, render::Vec3f colour);

}  // namespace enfilade::tools
