#pragma once
// Inside of render: the cells that a line meets, found through the boxes of the point locator. How a ray goes on behind
// a wall, where no portal leads.

#include <cstdint>
#include <vector>

#include "accel/scene.h"
#include "render/ray.h"
#include "render/walk_events.h"

namespace enfilade::render::detail {

/// Where a line enters a cell and leaves it, in units of the ray's (scaled) direction.
struct CellStretch {
    double enter, leave;
    std::uint32_t cell;
    Exit by;                              ///< which of its faces the line enters by
    std::uint32_t section, next_section;  ///< of a side face
};

/// The cells that the ray meets between its parameters `from` and `to`, in the order in which it enters them. A line
/// that only touches a cell does not meet it; ties are broken as the walk breaks them. Empties `found` first.
void cells_along(const accel::SceneView& scene, const Ray<double>& ray, double from, double to,
                 std::vector<CellStretch>& found);

/// What lies behind the face by which the line enters, seen from the cell.
[[nodiscard]] accel::Target target_behind(const accel::SceneView& scene, const Ray<double>& ray,
                                          const CellStretch& stretch);

/// How far (metres) the ray's origin lies behind the plane of that face.
[[nodiscard]] double depth_behind(const accel::SceneView& scene, const Ray<double>& ray, const CellStretch& stretch);

}  // namespace enfilade::render::detail
