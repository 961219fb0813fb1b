#pragma once
// A storey of a flat scene as SVG.

#include <string>

#include "tools/report/scene_plan.h"

namespace enfilade::tools {

/// The inside of an `<svg>` whose user unit is the metre, y down: walls, spaces, cells, portals and cuts, and the names
/// of the rooms of storey number `storey_index` with their area and cells. A room's path has its id in `data-space`.
[[nodiscard]] std::string scene_drawing(const accel::SceneView& scene, const ScenePlan& plan,
                                        std::uint32_t storey_index);

/// Rules for it and for the text of a sheet around it, without variables, which not every program knows.
[[nodiscard]] std::string scene_style(double pixels_per_mm);

}  // namespace enfilade::tools
