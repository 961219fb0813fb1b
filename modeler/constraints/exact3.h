#pragma once
// Signs of determinants of integer points in space. Exact for coordinates within +-2^28.

#include <array>
#include <cstdint>

namespace enfilade::modeler {

using Point3 = std::array<std::int32_t, 3>;

/// The cross product (b - a) x (c - a).
[[nodiscard]] constexpr std::array<std::int64_t, 3> normal_of(const Point3& a, const Point3& b, const Point3& c) {
    const std::int64_t ux = std::int64_t(b[0]) - a[0], uy = std::int64_t(b[1]) - a[1], uz = std::int64_t(b[2]) - a[2];
    const std::int64_t vx = std::int64_t(c[0]) - a[0], vy = std::int64_t(c[1]) - a[1], vz = std::int64_t(c[2]) - a[2];
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}

/// (p - a) . normal: six times the volume of a tetrahedron where the normal is that of a, b, c.
[[nodiscard]] constexpr __int128 height_over(const Point3& a, const std::array<std::int64_t, 3>& normal,
                                             const Point3& p) {
    __int128 sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += static_cast<__int128>(normal[i]) * (std::int64_t(p[i]) - a[i]);
    return sum;
}

[[nodiscard]] constexpr int sign_of(__int128 value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// On which side of the plane through a, b, c the point d lies: positive where a, b, c are seen counter-clockwise.
[[nodiscard]] constexpr int side_of(const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    return sign_of(height_over(a, normal_of(a, b, c), d));
}

}  // namespace enfilade::modeler
