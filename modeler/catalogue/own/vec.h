#pragma once
// Points and poses in which pieces of furniture are shaped: metres, doubles.

#include <cmath>
#include <numbers>

namespace enfilade::modeler::own {

struct Vec {
    double x = 0;
    double y = 0;
    double z = 0;
    friend constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend constexpr Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
    friend constexpr bool operator==(Vec, Vec) = default;
};

[[nodiscard]] constexpr double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double length(Vec a) { return std::sqrt(dot(a, a)); }
/// \pre `a` is not zero
[[nodiscard]] inline Vec unit(Vec a) { return (1 / length(a)) * a; }
[[nodiscard]] constexpr Vec mix(Vec a, Vec b, double t) { return a + t * (b - a); }
[[nodiscard]] constexpr double mix(double a, double b, double t) { return a + t * (b - a); }

/// Width along x, depth along y, height along z.
struct Size {
    double width = 1;
    double depth = 1;
    double height = 1;
};

/// An affine map: columns and where the origin goes.
struct Pose {
    Vec x = {1, 0, 0};
    Vec y = {0, 1, 0};
    Vec z = {0, 0, 1};
    Vec at = {0, 0, 0};

    [[nodiscard]] constexpr Vec turned(Vec p) const { return p.x * x + p.y * y + p.z * z; }
    [[nodiscard]] constexpr Vec operator()(Vec p) const { return at + turned(p); }
    /// First `b`, then `a`.
    friend constexpr Pose operator*(const Pose& a, const Pose& b) {
        return {a.turned(b.x), a.turned(b.y), a.turned(b.z), a(b.at)};
    }
};

inline constexpr double pi = std::numbers::pi;
[[nodiscard]] constexpr double degrees(double angle) { return angle * pi / 180; }

[[nodiscard]] constexpr Pose move(double x, double y, double z) { return {.at = {x, y, z}}; }
[[nodiscard]] constexpr Pose stretch(double x, double y, double z) { return {{x, 0, 0}, {0, y, 0}, {0, 0, z}}; }
/// Counter-clockwise about an axis that points at the viewer, in degrees.
[[nodiscard]] inline Pose turn_x(double angle) {
    const double c = std::cos(degrees(angle)), s = std::sin(degrees(angle));
    return {.y = {0, c, s}, .z = {0, -s, c}};
}
[[nodiscard]] inline Pose turn_y(double angle) {
    const double c = std::cos(degrees(angle)), s = std::sin(degrees(angle));
    return {.x = {c, 0, -s}, .z = {s, 0, c}};
}
[[nodiscard]] inline Pose turn_z(double angle) {
    const double c = std::cos(degrees(angle)), s = std::sin(degrees(angle));
    return {.x = {c, s, 0}, .y = {-s, c, 0}};
}

}  // namespace enfilade::modeler::own
