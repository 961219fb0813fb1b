#pragma once
// What the exact 2D stage hands to the modeler: all storeys in one planar subdivision on the integer grid.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "plans/grid.h"
#include "plans/noding.h"
#include "plans/plan.h"
#include "plans/planar_map.h"

namespace enfilade::plans {

enum class OwnerKind : std::uint8_t { Exterior, Room, Wall, Opening, Column, Stair, Shaft };

/// Who holds a face of the subdivision in one storey.
struct Owner {
    OwnerKind kind = OwnerKind::Exterior;
    std::uint32_t element = 0;  ///< index into the storey's walls, openings, columns, stairs, shafts; `FoundRoom` for
                                ///< rooms and stairs' rooms
    friend bool operator==(const Owner&, const Owner&) = default;
    friend auto operator<=>(const Owner&, const Owner&) = default;
};

/// A room found from the walls.
struct FoundRoom {
    std::string id;    ///< of the plan's polygon; "room@<storey>/<k>" where none names it
    std::string name;  ///< empty where none names it
    std::string kind = "room";
    std::optional<std::uint32_t> polygon;  ///< index into the storey's rooms
    double area_m2 = 0;
};

struct StoreyLayout {
    std::uint32_t plan_storey = 0;  ///< index into Plan::storeys
    std::vector<Owner> owner;       ///< [face_count]; face 0 is beyond the site box
    std::vector<FoundRoom> rooms;
    /// Stairs and shafts that open the slab above this storey over a face: index into stairs, or into shafts after
    /// all stairs (stairs.size() + k); none: UINT32_MAX. Walls of this storey and the next are never open.
    std::vector<std::uint32_t> opens_up;  ///< [face_count]
};

/// The supporting line of an edge: edges of one line count as straight where they meet (1-architecture, decision 2).
enum class LineId : std::uint32_t {};

/// One side of a wall as the renderer colours it.
struct LineSource {
    std::uint32_t storey = UINT32_MAX;  ///< index into Layout::storeys; UINT32_MAX: site box or cut
    std::uint32_t wall = UINT32_MAX;    ///< index into the storey's walls
    bool left_side = false;             ///< of the wall's axis
};

struct Layout {
    GridFrame frame;
    NodedGraph graph;  ///< its segments are internal to `arrange`
    PlanarMap map;
    std::vector<LineId> edge_line;  ///< [graph.edges.size()]
    std::vector<LineId> use_line;   ///< [graph.uses.size()] each use's own line: what a storey alone sees of an edge
    std::vector<LineSource> lines;  ///< by LineId
    std::vector<StoreyLayout> storeys;  ///< by ascending elevation
    GridPoint site_min;
    GridPoint site_max;
    std::vector<Finding> findings;
};

struct ArrangeOptions {
    double snap_mm = 1000.0 / 8192;      ///< grid unit; rounded down to a power of two of a metre
    bool snap_fixed = false;             ///< the user asked for it: refuse rather than coarsen
    double sagitta_mm = 2;               ///< largest chord error of arcs
    std::vector<std::uint32_t> storeys;  ///< indices into Plan::storeys; empty: all
};

/// Lays all wall outlines, openings, columns, stairs and the site box of the chosen storeys into one exact
/// subdivision, and finds who owns each face in each storey: openings before walls, thicker walls before thinner
/// ones, then the lower id. \pre `plan` has been through `clean`.
/// Throws InputError where the plan cannot lie on the grid (`snap_fixed`, or larger than 2^24 units at 1 m a unit).
[[nodiscard]] Layout arrange(const Plan& plan, const ArrangeOptions& options = {});

}  // namespace enfilade::plans
