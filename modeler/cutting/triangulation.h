#pragma once
// The constrained Delaunay triangulation of a polygon with holes: what cutters find their way with.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

inline constexpr std::uint32_t no_index = UINT32_MAX;

/// Half-edge h = 3 * triangle + i runs along a triangle's edge i, counter-clockwise.
struct Triangulation {
    std::vector<std::uint32_t> from;  ///< [3 * triangle_count] the point at which a half-edge starts
    std::vector<std::uint32_t> twin;  ///< [3 * triangle_count] the half-edge back; `no_index` along a side
    std::vector<std::uint32_t> side;  ///< [3 * triangle_count] the side along it; `no_index` for diagonals
    [[nodiscard]] std::uint32_t triangle_count() const { return std::uint32_t(from.size() / 3); }
};

[[nodiscard]] constexpr std::uint32_t next_in_triangle(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
[[nodiscard]] constexpr std::uint32_t previous_in_triangle(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// The triangles within the polygon bounded by `sides`. \pre sides form closed loops and do not cross. Cost: n log n.
[[nodiscard]] Triangulation triangulate(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides);

}  // namespace enfilade::modeler
