#pragma once
// Which cell a point lies in.

#include <array>
#include <optional>
#include <span>

#include "accel/parallel_for.h"
#include "accel/scene.h"

namespace enfilade::accel {

/// The cell that holds `point` (metres, scene frame), or nothing inside walls and beyond the site.
/// Points on a border belong to the cell that holds point + (-e^2, -e^3, +e) for a vanishing e: the same virtual shift
/// by which the walk breaks its ties, so exactly one cell holds each point. Exact for points on the grid (the products
/// fit in a double's 53 bits). Cost: log n.
[[nodiscard]] std::optional<CellId> locate(const SceneView& view, const std::array<double, 3>& point);

/// The same for many points: cells[i] is that of points[i], `none<CellId>` where there is none. Fast for points that
/// follow each other through space, and for many more points than cells (it builds a PointGrid for those; keep one for
/// a scene that is asked often). cells: [points.size()]. `executor` nullptr: the calling thread; results do not depend
/// on it.
void locate(const SceneView& view, std::span<const std::array<double, 3>> points, std::span<CellId> cells,
            const Executor* executor = nullptr);

/// Whether that one cell holds the point, by the same rule.
[[nodiscard]] bool contains(const SceneView& view, CellId cell, const std::array<double, 3>& point);

/// Least distance (metres, about) from the point to the cell's planes, positive inside.
[[nodiscard]] double depth(const SceneView& view, CellId cell, const std::array<double, 3>& point);

}  // namespace enfilade::accel
