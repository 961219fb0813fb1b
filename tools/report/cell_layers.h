#pragma once
// Convex cells, the portals between them, and the graph that both are: drawn alike from a building and from a scene.

#include <array>
#include <map>
#include <vector>

#include "tools/report/area_scale.h"
#include "tools/report/plan_view.h"

namespace enfilade::tools {

enum class SideKind : std::uint8_t {
    Solid,
    Leaf,   ///< of a shut door
    Clear,  ///< a portal of a door or an opening
    Glass,
    Seam,  ///< a virtual portal where one room becomes another
    Cut,   ///< a virtual portal within a room
};
[[nodiscard]] SideKind side_kind(accel::PortalKind kind, bool same_space);

/// A side of a cell where a drawing's level cuts it; a portal comes once for its two cells.
struct CellSide {
    Mm from, to;
    std::uint32_t front = 0, back = 0;  ///< cells; `back` of portals alone
    SideKind kind = SideKind::Solid;
    double area_m2 = 0;  ///< of portals
};

/// What a level cuts of the cells.
struct CellPlan {
    std::vector<CellSide> sides;
    std::map<std::uint32_t, Mm> middles;  ///< by cell; empty: no graph is drawn
};

struct CellPaths {
    SvgPath cells;                                  ///< borders
    SvgPath clear;                                  ///< portals by kind
    SvgPath border;                                 ///< seams
    std::array<SvgPath, area_classes.size()> cuts;  ///< by area of the whole portal between two cells
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
[[nodiscard]] CellPlan cell_plan(const PlanView& view, std::uint32_t storey);
[[nodiscard]] CellPaths cell_paths(const CellPlan& plan);

/// `<path>`s of the portals that are none within a room, and of the cuts: in millimetres, y up.
[[nodiscard]] std::string portal_tags(const CellPaths& paths);
[[nodiscard]] std::string cut_tags(const CellPaths& paths);

}  // namespace enfilade::tools
