#pragma once
// Convex cells, the portals between them, and the graph that both are.

#include "tools/report/plan_view.h"

namespace enfilade::tools {

struct CellPaths {
    SvgPath cells;   ///< borders
    SvgPath clear;   ///< portals by kind
    SvgPath border;  ///< virtual ones
    SvgPath glass;
    SvgPath leaves;  ///< shut doors
    SvgPath nodes;   ///< dots in the cells' middles
    SvgPath links;   ///< from middle to middle through each portal
    [[nodiscard]] std::size_t size() const;
};

struct CellCounts {
    std::size_t cells = 0;
    std::size_t portals = 0;
};

/// All cells and portals of the building, those in slabs and outdoors included.
[[nodiscard]] CellCounts count_cells(const modeler::Building& building);

/// What the drawing's level cuts in a storey.
[[nodiscard]] CellPaths cell_paths(const PlanView& view, std::uint32_t storey);

}  // namespace enfilade::tools
