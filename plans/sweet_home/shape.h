#pragma once
// Shapes that pieces cut out: the `d` of an SVG path (SVG 1.1, section 8.3) inside the unit square, y down.

#include <optional>
#include <string_view>
#include <vector>

#include "plans/plan.h"

namespace enfilade::plans {

/// Rings of the path, curves as chords; nothing where the text is no path. Rings with fewer than 3 corners are left
/// out.
[[nodiscard]] std::optional<std::vector<std::vector<Point>>> path_rings(std::string_view path);

[[nodiscard]] double signed_area(const std::vector<Point>& ring);

}  // namespace enfilade::plans
