#pragma once
// Where a beam starts: a point, a box or a whole cell, as a convex prism of grid points.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "accel/scene.h"

namespace enfilade::accel {

/// A point of the plan, in grid units. Coordinates stay below 2^26, so that `turn` is exact in 64 bits.
struct PlanPoint {
    std::int64_t x = 0;
    std::int64_t y = 0;
    friend bool operator==(const PlanPoint&, const PlanPoint&) = default;
};

/// Twice the signed area of the triangle a, b, c: positive where c lies left of the line from a to b.
[[nodiscard]] constexpr std::int64_t turn(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners of the convex hull, counter-clockwise from the lowest (x, y); none twice, none in the middle of a side.
/// One corner where all points are the same, two where all lie on one line. O(n log n).
[[nodiscard]] std::vector<PlanPoint> convex_hull(std::vector<PlanPoint> points);

/// A convex vertical prism inside one cell, from whose points the rays of a beam start; grid units. A point has one
/// corner and z_low = z_high.
struct BeamSource {
    CellId cell = {};
    std::vector<PlanPoint> corners;  ///< as `convex_hull` gives them; at least one
    std::int64_t z_low = 0;
    std::int64_t z_high = 0;

    /// Whether the point lies in the plan of the source, its border included.
    [[nodiscard]] bool holds(const PlanPoint& p) const;
};

/// The point (metres, scene frame) as a source in `cell`: exact where it lies on the grid, else the box of grid points
/// around it, one unit wide at most.
[[nodiscard]] BeamSource source_at(const SceneView& view, CellId cell, const std::array<double, 3>& point);
/// The same in the cell that holds the point; nothing where none does.
[[nodiscard]] std::optional<BeamSource> source_at(const SceneView& view, const std::array<double, 3>& point);
/// The whole cell.
[[nodiscard]] BeamSource source_of_cell(const SceneView& view, CellId cell);
/// Each cell of a room or another space, in ascending order.
[[nodiscard]] std::vector<BeamSource> sources_of_space(const SceneView& view, SpaceId space);
/// What the box from `low` to `high` (metres, scene frame) has in common with each cell, rounded outward to the grid;
/// in ascending order of the cells. \pre low <= high
[[nodiscard]] std::vector<BeamSource> sources_of_box(const SceneView& view, const std::array<double, 3>& low,
                                                     const std::array<double, 3>& high);

}  // namespace enfilade::accel
