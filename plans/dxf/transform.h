#pragma once
// Maps of space as a drawing nests them: blocks in blocks, and each entity in the plane that its extrusion spans.

#include <cmath>

#include "plans/plan.h"

namespace enfilade::plans::dxf {

struct P3 {
    double x = 0;
    double y = 0;
    double z = 0;
    friend bool operator==(const P3&, const P3&) = default;
};

[[nodiscard]] constexpr P3 operator+(P3 a, P3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] constexpr P3 operator-(P3 a, P3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] constexpr P3 operator*(P3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
[[nodiscard]] constexpr P3 cross(P3 a, P3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(P3 a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

/// An affine map, by the images of the unit vectors and of the origin.
struct Transform {
    P3 x = {1, 0, 0};
    P3 y = {0, 1, 0};
    P3 z = {0, 0, 1};
    P3 origin;

    [[nodiscard]] constexpr P3 vector(P3 v) const { return x * v.x + y * v.y + z * v.z; }
    [[nodiscard]] constexpr P3 point(P3 p) const { return origin + vector(p); }
};

/// First `inner`, then `outer`.
[[nodiscard]] constexpr Transform operator*(const Transform& outer, const Transform& inner) {
    return {outer.vector(inner.x), outer.vector(inner.y), outer.vector(inner.z), outer.point(inner.origin)};
}

/// From the coordinates of an entity with that extrusion to those around it (the arbitrary axis algorithm of the DXF
/// reference). A normal without length counts as (0, 0, 1).
[[nodiscard]] inline Transform entity_frame(P3 normal) {
    if (normal == P3{0, 0, 1}) return {};
    const double size = length(normal);
    if (!(size > 0) || !std::isfinite(size)) return {};
    const P3 z = normal * (1 / size);
    const bool steep = std::abs(z.x) < 1.0 / 64 && std::abs(z.y) < 1.0 / 64;
    const P3 across = steep ? cross({0, 1, 0}, z) : cross({0, 0, 1}, z);
    const P3 x = across * (1 / length(across));
    return {x, cross(z, x), z, {}};
}

[[nodiscard]] constexpr Point flat(P3 p) { return {p.x, p.y}; }

}  // namespace enfilade::plans::dxf
