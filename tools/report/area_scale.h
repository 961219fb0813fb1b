#pragma once
// The colours of cuts: by the area of their portals, in steps that look alike.

#include <array>
#include <cstddef>
#include <string>

namespace enfilade::tools {

/// Classes of area, each from its value (m2) to the next one's: doubling, and always the same, so that drawings can be
/// compared with each other.
inline constexpr std::array<double, 8> area_classes = {0, 0.5, 1, 2, 4, 8, 16, 32};

/// 0 for areas that are no number.
[[nodiscard]] std::size_t area_class(double square_metres);

enum class Ground { Light, Dark };

/// "#rrggbb". Lightness goes down on a light ground and up on a dark one in equal steps of OKLab (Ottosson 2020), so
/// that the order is seen without a legend, in grey and with colour-blind eyes too; the hue goes from yellow through
/// red to violet, and leaves green and blue to doors and windows.
[[nodiscard]] const char* area_colour(std::size_t area_class, Ground ground);

/// Rules for a page that may be light or dark: what has class `a0`, `a1`, ... strokes with its class's colour, which is
/// `var(--area)` to others.
[[nodiscard]] std::string area_style();
/// The same for a picture on a light ground, without variables.
[[nodiscard]] std::string plain_area_style();

/// "up to 0.5", "0.5 to 1", ... "over 32", in m2.
[[nodiscard]] std::string area_class_text(std::size_t area_class);

}  // namespace enfilade::tools
