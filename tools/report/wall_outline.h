#pragma once
// What the drawing's level cuts of walls, all walls of a storey together: no seams where two of them meet.

#include "tools/report/plan_view.h"

namespace enfilade::tools {

struct WallOutlines {
    SvgPath cut;      ///< walls through which the level goes
    SvgPath low;      ///< walls that end under it
    SvgPath columns;  ///< cut ones
};

[[nodiscard]] WallOutlines wall_outlines(const PlanView& view, std::uint32_t storey);

}  // namespace enfilade::tools
