#pragma once
// Whether a triangle meets a box.

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade::accel {

using Corners = std::array<std::array<double, 3>, 3>;  ///< [corner][axis]

/// Whether the triangle shares a point with the box about `centre`, `half` wide to each side; borders count. Thirteen
/// axes (Akenine-Moller 2001). Rather yes than no: by a few roundings of double.
[[nodiscard]] inline bool triangle_meets_box(const Corners& corners, const std::array<double, 3>& centre, double half) {
    Corners p = corners;
    for (auto& c : p)
        for (std::size_t k = 0; k < 3; ++k) c[k] -= centre[k];
    const double wide = half * (1 + 1e-12);
    for (std::size_t k = 0; k < 3; ++k)
        if (std::min({p[0][k], p[1][k], p[2][k]}) > wide || std::max({p[0][k], p[1][k], p[2][k]}) < -wide) return false;
    std::array<std::array<double, 3>, 3> edges;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) edges[i][k] = p[(i + 1) % 3][k] - p[i][k];
    for (const auto& e : edges) {
        for (std::size_t k = 0; k < 3; ++k) {  // the axis e x unit_k
            const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
            double least = INFINITY, largest = -INFINITY;
            for (const auto& c : p) {
                const double along = e[b] * c[a] - e[a] * c[b];
                least = std::min(least, along);
                largest = std::max(largest, along);
            }
            const double reach = wide * (std::abs(e[a]) + std::abs(e[b]));
            if (least > reach || largest < -reach) return false;
        }
    }
    const std::array<double, 3> n = {edges[0][1] * edges[1][2] - edges[0][2] * edges[1][1],
                                     edges[0][2] * edges[1][0] - edges[0][0] * edges[1][2],
                                     edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0]};
    const double away = n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2];
    return std::abs(away) <= wide * (std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]));
}

}  // namespace enfilade::accel
