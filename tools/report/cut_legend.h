#pragma once
// What the colours and lines of a cut sheet mean, and how long a metre is on it.

#include <string>

namespace enfilade::tools {

inline constexpr double legend_width = 880;  ///< pixels

/// A `<g class="legend">` with its upper left corner there; pixels.
[[nodiscard]] std::string cut_legend(double x, double y, double pixels_per_mm);

}  // namespace enfilade::tools
