#pragma once
// Cutting a polygon with holes into discs or into convex pieces, by diagonals.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "plans/grid.h"

namespace enfilade::modeler {

/// A directed side of the polygon, which lies on its left. Sides meet only in common points.
struct PolygonSide {
    std::uint32_t from = 0;  ///< into the points given to `partition`
    std::uint32_t to = 0;
    std::uint32_t line = 0;  ///< consecutive sides of one line count as straight
    std::uint32_t tag = 0;   ///< handed through
};

inline constexpr std::uint32_t cut_tag = UINT32_MAX;

enum class PartitionGoal {
    Disc,    ///< simply connected, no point visited twice
    Convex,  ///< no reflex corner (`reflex_corner`)
};

/// The pieces as rings of sides, counter-clockwise; a cut appears in two rings, with tag `cut_tag` and line `cut_tag`.
struct Partition {
    std::vector<PolygonSide> sides;
    std::vector<std::uint32_t> first_side;  ///< [piece_count + 1]
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(first_side.size()) - 1; }
    [[nodiscard]] std::span<const PolygonSide> piece(std::uint32_t k) const {
        return std::span(sides).subspan(first_side[k], first_side[k + 1] - first_side[k]);
    }
};

/// Cuts the polygon bounded by `sides` along diagonals of its constrained Delaunay triangulation, taking diagonals out
/// again, first those within two grid units of a corner, then the longest, while the pieces keep the goal (Hertel and
/// Mehlhorn 1983 for convex pieces: at most four times the least number of them). No new points. A polygon that meets
/// the goal comes back whole. \pre sides form closed loops and do not cross. Cost: n log n.
[[nodiscard]] Partition partition(std::span<const plans::GridPoint> points, std::span<const PolygonSide> sides,
                                  PartitionGoal goal);

/// Whether a ring that passes a, b, c on these lines goes straight on at b: along one line and not back on it. (Rounded
/// lines go on within a quadrant: they may take a step of one unit at a right angle.)
[[nodiscard]] inline bool goes_straight(plans::GridPoint a, plans::GridPoint b, plans::GridPoint c,
                                        std::uint32_t line_in, std::uint32_t line_out) {
    if (line_in != line_out || line_in == cut_tag) return false;
    return (std::int64_t(b.x) - a.x) * (std::int64_t(c.x) - b.x) +
               (std::int64_t(b.y) - a.y) * (std::int64_t(c.y) - b.y) >=
           0;
}

struct RingCorner {
    plans::GridPoint point;
    std::uint32_t line = 0;  ///< of the side that leaves the corner
};

/// A corner of a counter-clockwise ring that turns right between different lines. Rounding bends lines by a unit: a
/// corner counts only where it turns right between its two sides and between the chords of the straight runs that they
/// end.
[[nodiscard]] std::optional<std::size_t> reflex_corner(std::span<const RingCorner> ring);

}  // namespace enfilade::modeler
