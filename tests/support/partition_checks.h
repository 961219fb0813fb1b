#pragma once
// Whether a partition is one: asked of its rings alone, in integers.

#include <span>
#include <string>
#include <vector>

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/polygon.h"

namespace enfilade::testing {

/// What was asked of a cutter.
struct PartitionWish {
    modeler::PartitionGoal goal = modeler::PartitionGoal::Convex;
    bool new_points = false;  ///< whether cuts may end at new points
};

/// What is wrong with a partition, and how good it is otherwise.
struct PartitionVerdict {
    std::vector<std::string> faults;  ///< a sentence each
    double stray = 0;                 ///< grid units, of corners from the chord of the straight run that they lie on
    double dent = 0;                  ///< grid units, of corners from the convex hull of their piece
    std::int64_t area2_change = 0;    ///< twice the area that sides bent to rounded points took or gave
    std::uint32_t unused = 0;         ///< new points that no side leads to
    std::uint32_t thin_walls = 0;     ///< pieces under 2 units wide between sides of the polygon: they are as given
    std::uint32_t thin_corners = 0;   ///< ... others, with given corners only
    std::uint32_t thin_cuts = 0;      ///< ... others: a cut that ends at a new point made them
    [[nodiscard]] std::string text() const;
};

/// A point of a line is rounded twice, by half a unit per axis each time; the ends of the line's chord once (G8).
inline constexpr double most_stray = 2.1213203435596424;

/// Corners that lines bent by rounding make reflex lie this near to the convex hull of their piece: the dents of some
/// short sides in a row add up.
inline constexpr double most_dent = 3 * most_stray;

/// Exact: (1) rings close, visit no point twice and have positive area; (2) the parts of every side lead from its start
/// to its end, each handed on as it was, with points that lie on it to half a unit per axis; (3) every cut is run once
/// in each direction, and on one line; (4) all sides together are a plane graph. Then every piece is a simple
/// counter-clockwise ring, and as cuts cancel out the pieces wind once around every point of the polygon between the
/// chains of its sides, and never around any other: they are a partition of it, and their areas sum to its area.
/// (5) Where convex pieces are asked for: no reflex corner, no corner stray from its line, none far inside the hull.
/// \pre sides have distinct tags
[[nodiscard]] PartitionVerdict judge_partition(std::span<const plans::GridPoint> points,
                                               std::span<const modeler::PolygonSide> sides,
                                               const modeler::Partition& partition, const PartitionWish& wish);

}  // namespace enfilade::testing
