#pragma once
// The boxes of strokes, arcs with their bellies.

#include <array>
#include <vector>

#include "plans/dxf/drawing.h"

namespace enfilade::plans::dxf {

/// x0, y0, x1, y1. The arc is met exactly where it is highest, lowest, leftmost or rightmost.
[[nodiscard]] std::array<double, 4> box_of(const Stroke& stroke);

/// Around all strokes; zeros where there is none.
[[nodiscard]] std::array<double, 4> bounds_of(const std::vector<Stroke>& strokes);

}  // namespace enfilade::plans::dxf
