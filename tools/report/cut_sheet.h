#pragma once
// A picture of how rooms are cut: storeys of flat scenes side by side, as SVG that needs no page around it.

#include <span>
#include <string>
#include <vector>

#include "tools/report/scene_plan.h"

namespace enfilade::tools {

/// One plan of a sheet.
struct CutPanel {
    const accel::SceneView* scene = nullptr;
    SceneStorey storey;
    std::string title;
    std::vector<std::string> lines;  ///< of text under it
};

/// Rooms softly filled, walls dark, cells outlined; cuts in the colour of their portal's area (area_scale.h), which a
/// legend explains; doors, windows and borders between rooms in their own; a bar for the scale. All panels are drawn at
/// one scale. In groups: `panel` each, `legend`. The same input gives the same bytes.
[[nodiscard]] std::string cut_sheet(const std::string& title, std::span<const CutPanel> panels);

/// A panel for each of these storeys, with rooms, cells and the area of cuts under it.
[[nodiscard]] std::vector<CutPanel> storey_panels(const accel::SceneView& scene, std::span<const SceneStorey> storeys);

}  // namespace enfilade::tools
