#pragma once
// Polygons with holes whose sides remember what they are, and the pieces that they are cut into.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plans/grid.h"

namespace enfilade::modeler {

/// A directed side of the polygon, which lies on its left. Sides meet only in common points.
struct PolygonSide {
    std::uint32_t from = 0;  ///< into the points of the polygon
    std::uint32_t to = 0;
    std::uint32_t line = 0;   ///< consecutive sides of one line count as straight; below `first_cut_line` if given
    std::uint32_t tag = 0;    ///< handed through
    std::uint32_t look = 0;   ///< consecutive sides of one line that look alike become one vertical section
    std::uint32_t faces = 1;  ///< faces of the stack over it
};

inline constexpr std::uint32_t cut_tag = UINT32_MAX;

/// Lines of cuts in a `Partition`, from here on: a cut that others end on is one line in several sides. A cut that
/// prolongs a side of the polygon has that side's line.
inline constexpr std::uint32_t first_cut_line = 1u << 31;

/// The pieces as rings of sides, counter-clockwise; a cut appears in two rings, with tag `cut_tag`. A side of the
/// polygon on which cuts end comes in several parts with its tag: from and to tell which.
struct Partition {
    std::vector<PolygonSide> sides;
    std::vector<std::uint32_t> first_side = {0};  ///< [piece_count + 1]
    std::vector<plans::GridPoint> new_points;     ///< points from the number of given points on
    std::uint32_t moved = 0;        ///< cuts that would have passed a point closer than `least_gap`: they end there
    std::uint32_t fallen_back = 0;  ///< polygons that rounding spoilt: cut again without new points
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(first_side.size()) - 1; }
    [[nodiscard]] std::span<const PolygonSide> piece(std::uint32_t k) const {
        return std::span(sides).subspan(first_side[k], first_side[k + 1] - first_side[k]);
    }
};

/// Cuts keep this distance, in grid units, from the points that they do not end at.
inline constexpr double least_gap = 2;

/// Whether a ring that passes a, b, c on these lines goes straight on at b: along one line and not back on it. (Rounded
/// lines go on within a quadrant: they may take a step of one unit at a right angle.)
[[nodiscard]] inline bool goes_straight(plans::GridPoint a, plans::GridPoint b, plans::GridPoint c,
                                        std::uint32_t line_in, std::uint32_t line_out) {
    if (line_in != line_out) return false;
    return (std::int64_t(b.x) - a.x) * (std::int64_t(c.x) - b.x) +
               (std::int64_t(b.y) - a.y) * (std::int64_t(c.y) - b.y) >=
           0;
}

struct RingCorner {
    plans::GridPoint point;
    std::uint32_t line = 0;  ///< of the side that leaves the corner
};

/// Farthest that rounding moves points of one line from its chord, in grid units: each point is rounded twice, by half
/// a unit per axis each time, the ends of the chord once.
inline constexpr double most_stray = 1.5 * 1.4142135623730951;

/// Whether a ring turns right at `corner`, from the run of one line that begins at `run_before` and ends with the side
/// from `before`, to the run that begins with the side to `after` and ends at `run_after`. Rounding bends lines by a
/// unit: a corner counts only where the chords of both runs turn right, and either the sides do so, too, or the corner
/// lies deeper within than rounding moves it.
[[nodiscard]] inline bool turns_right(plans::GridPoint run_before, plans::GridPoint before, plans::GridPoint corner,
                                      plans::GridPoint after, plans::GridPoint run_after) {
    const std::int64_t turn = orientation(run_before, corner, run_after);
    if (turn >= 0) return false;
    if (orientation(before, corner, after) < 0) return true;
    const double x = double(run_after.x) - run_before.x, y = double(run_after.y) - run_before.y;
    return double(turn) * double(turn) > most_stray * most_stray * (x * x + y * y);
}

/// A corner of a counter-clockwise ring that turns right (`turns_right`) between different lines.
[[nodiscard]] std::optional<std::size_t> reflex_corner(std::span<const RingCorner> ring);

/// Twice the area of a ring.
[[nodiscard]] std::int64_t area2(std::span<const plans::GridPoint> points, std::span<const PolygonSide> ring);

/// Leaves out the new points that no piece touches.
void drop_unused_points(std::uint32_t given_point_count, Partition& partition);

/// The order of the sides of a polygon that is one ring and visits no point twice: indices into `sides`, each followed
/// by the side that leaves where it ends. Empty for any other polygon.
[[nodiscard]] std::vector<std::uint32_t> simple_ring(std::span<const PolygonSide> sides);

/// Whether a ring has no reflex corner (`reflex_corner`), and none that short sides in a row hide: no corner lies
/// deeper within the hull than rounded lines bring it there.
[[nodiscard]] bool is_convex(std::span<const RingCorner> ring);

/// The same of the sides taken in this order.
[[nodiscard]] bool is_convex(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                             std::span<const std::uint32_t> ring);

}  // namespace enfilade::modeler
