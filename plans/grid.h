#pragma once
// The integer grid on which everything after the plan lives (1-architecture, decision 2).

#include <cmath>
#include <cstdint>

namespace enfilade::plans {

/// A point of the plan on the grid.
struct GridPoint {
    std::int32_t x = 0;
    std::int32_t y = 0;
    friend bool operator==(const GridPoint&, const GridPoint&) = default;
    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

/// Where the grid lies: `world = origin + unit * grid`; `unit` is a power of two, `origin` a multiple of it.
struct GridFrame {
    double unit = 1.0 / 8192;
    double origin_x = 0;
    double origin_y = 0;
    double origin_z = 0;

    /// Nearest grid coordinate, ties upward. \pre the result lies within +-2^24.
    [[nodiscard]] std::int32_t grid_x(double x) const { return std::int32_t(std::floor((x - origin_x) / unit + 0.5)); }
    [[nodiscard]] std::int32_t grid_y(double y) const { return std::int32_t(std::floor((y - origin_y) / unit + 0.5)); }
    [[nodiscard]] std::int32_t grid_z(double z) const { return std::int32_t(std::floor((z - origin_z) / unit + 0.5)); }
    [[nodiscard]] GridPoint grid(double x, double y) const { return {grid_x(x), grid_y(y)}; }
    [[nodiscard]] double world_x(std::int32_t x) const { return origin_x + unit * x; }
    [[nodiscard]] double world_y(std::int32_t y) const { return origin_y + unit * y; }
    [[nodiscard]] double world_z(std::int32_t z) const { return origin_z + unit * z; }
};

/// Twice the signed area of (a, b, c): positive when c lies left of a -> b. Exact for |coordinates| <= 2^30.
[[nodiscard]] constexpr std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    return (std::int64_t(b.x) - a.x) * (std::int64_t(c.y) - a.y) -
           (std::int64_t(b.y) - a.y) * (std::int64_t(c.x) - a.x);
}

}  // namespace enfilade::plans
