#pragma once
// Ellipses and splines as chains of points: what arcs of circles cannot be.

#include <vector>

#include "plans/dxf/entities.h"

namespace enfilade::plans::dxf {

/// Chains stay within this share of the curve's own size (the diagonal of its box) of the curve, hence within it of the
/// drawing's.
inline constexpr double chord_error = 1e-4;

/// centre + u cos t + v sin t for t from `start` over `sweep` (signed, at most a full turn): points in order, both ends
/// among them.
[[nodiscard]] std::vector<Point> ellipse_chain(Point centre, Point u, Point v, double start, double sweep);

/// The spline seen through `map`, along z. Empty where its control points, knots and degree make no curve.
[[nodiscard]] std::vector<Point> spline_chain(const SplineEntity& spline, const Transform& map);

}  // namespace enfilade::plans::dxf
