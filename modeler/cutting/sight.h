#pragma once
// What a straight cut meets on its way through a polygon.

#include <cstdint>
#include <span>
#include <vector>

#include "modeler/cutting/triangulation.h"

namespace enfilade::modeler {

/// A direction in grid units of any length. |x|, |y| <= 2^26
struct Direction {
    std::int64_t x = 0;
    std::int64_t y = 0;
};
[[nodiscard]] constexpr std::int64_t cross(Direction a, Direction b) { return a.x * b.y - a.y * b.x; }
[[nodiscard]] constexpr std::int64_t dot(Direction a, Direction b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] constexpr Direction direction(plans::GridPoint from, plans::GridPoint to) {
    return {std::int64_t(to.x) - from.x, std::int64_t(to.y) - from.y};
}

/// Where a cut ends that starts at a corner.
struct Hit {
    enum class At : std::uint8_t { Nothing, Point, Side, Cut };
    At at = At::Nothing;
    bool moved = false;           ///< it would have passed this point closer than `least_gap`
    std::uint32_t id = no_index;  ///< point, side, or the number given to the cut
    plans::GridPoint point;       ///< rounded to the grid
    double length = 0;            ///< grid units
};

/// Walks through the triangles of a polygon, which know the cuts that cross them.
class Sight {
public:
    Sight(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides);

    [[nodiscard]] const Triangulation& triangles() const { return triangles_; }
    [[nodiscard]] std::span<const plans::GridPoint> points() const { return points_; }
    /// The half-edge of the triangles along a side.
    [[nodiscard]] std::uint32_t along(std::uint32_t side) const { return along_[side]; }
    /// [side] the side that ends where this one begins, in the same wedge of the polygon.
    [[nodiscard]] std::vector<std::uint32_t> corners_before() const;

    /// Looks from where half-edge `start` begins, a direction left of it, to the first side or cut, at most `limit`
    /// triangles far; those it passes are left in `passed`.
    [[nodiscard]] Hit look(std::uint32_t start, Direction d, std::uint32_t limit,
                           std::vector<std::uint32_t>& passed) const;

    /// A cut that passed these triangles from now on ends looks.
    void add_cut(std::uint32_t id, plans::GridPoint a, plans::GridPoint b, std::span<const std::uint32_t> passed);

private:
    struct Segment {
        plans::GridPoint a, b;
        std::uint32_t id;
    };
    struct Entry {
        std::uint32_t cut, next;
    };
    struct Nearest;
    [[nodiscard]] bool is_sliver(std::uint32_t start, std::uint32_t first_triangle, const Hit& hit) const;
    void meet_point(std::uint32_t p, plans::GridPoint eye, Direction d, Nearest& nearest) const;
    void meet_cuts(std::uint32_t triangle, plans::GridPoint eye, Direction d, Nearest& nearest) const;

    std::span<const plans::GridPoint> points_;
    std::span<const PolygonSide> sides_;
    Triangulation triangles_;
    std::vector<std::uint32_t> along_;  ///< [side]
    std::vector<Segment> cuts_;
    std::vector<std::uint32_t> first_cut_;  ///< [triangle] into entries_
    std::vector<Entry> entries_;
};

/// The point of a grid nearest to where the line from `eye` along `d` meets the line through a and b.
[[nodiscard]] plans::GridPoint rounded_meeting(plans::GridPoint eye, Direction d, plans::GridPoint a,
                                               plans::GridPoint b);

}  // namespace enfilade::modeler
