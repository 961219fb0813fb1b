#pragma once
// The labelled 3D model of a building: prisms on the integer grid, and the generalized map that holds their topology.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "accel/label.h"
#include "accel/scene_input.h"
#include "base/finding.h"
#include "base/id.h"
#include "gmap/defect.h"
#include "gmap/map.h"
#include "modeler/cutting/cut.h"
#include "modeler/lighting/lamp.h"
#include "modeler/objects/furnishing.h"
#include "modeler/stack.h"
#include "plans/grid.h"

namespace enfilade::modeler {

/// A simple polygon of the plan over which volumes stand: a disc, counter-clockwise.
/// Its edge k runs from corner k to corner k + 1; corners on one line are kept (walls of other volumes may end there).
struct Piece {
    std::uint32_t first_corner = 0;  ///< into Prisms::corners
    std::uint32_t corner_count = 0;
    std::uint32_t parent = 0;  ///< the piece of the unconvexified building that it is cut from
};

struct Corner {
    std::uint32_t vertex = 0;     ///< into Prisms::points
    std::uint32_t half_edge = 0;  ///< the edge to the next corner: 2 * edge, + 1 where it is run backwards
    std::uint32_t line = 0;       ///< below Building::line_count: sides of one line count as straight where they meet
};

/// A volume of the map: the prism over a piece between two levels.
struct Volume {
    Label label = Label::Outside;
    std::uint32_t space = 0;   ///< into Building::spaces
    std::uint32_t piece = 0;   ///< into Building::pieces; none for `Outside`
    std::uint32_t parent = 0;  ///< the volume of the unconvexified building that it is cut from
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
};

enum class Direction : std::uint8_t { Side, Up };

/// A face of the map. A side face lies over an edge of the plan, with `front` on the left of the edge; an `Up` face is
/// horizontal, with `front` above it and `back` below.
struct Face {
    Direction direction = Direction::Side;
    std::uint32_t front = 0;  ///< volume
    std::uint32_t back = 0;   ///< volume
    std::uint32_t edge = 0;   ///< side faces: into Building::edges
    std::int32_t z_low = 0;   ///< horizontal faces: both are their level
    std::int32_t z_high = 0;
};

/// An edge of the plan.
struct PlanEdge {
    std::uint32_t a = 0;  ///< into Building::points
    std::uint32_t b = 0;
};

struct Building {
    std::string name;
    plans::GridFrame frame;
    std::array<std::int32_t, 3> site_min = {};
    std::array<std::int32_t, 3> site_max = {};

    std::vector<Space> spaces;
    std::vector<StoreyInfo> storeys;
    std::uint32_t line_count = 0;  ///< lines of the plan and cuts
    std::vector<WallColour> wall_colours;
    std::vector<plans::GridPoint> points;
    std::vector<PlanEdge> edges;
    std::vector<Piece> pieces;
    std::vector<Corner> corners;
    std::vector<Volume> volumes;                        ///< by the map's volume id; the last one is `Outside`
    std::vector<Face> faces;                            ///< by the map's face id
    std::vector<std::array<std::int32_t, 3>> vertices;  ///< [map vertex count] grid units
    gmap::Map map;
    std::vector<gmap::Defect> map_defects;  ///< what the map's builder refused: keys with one or three darts
    bool convex = false;                    ///< `convexify` has run
    bool opaque_glass = false;
    double max_deviation = 0;  ///< grid units that snap rounding moved an edge at most
    double sagitta = 0.002;    ///< metres: chord error of curved walls that was asked for

    Furnishing furnishing;    ///< what stands in its rooms
    std::vector<Lamp> lamps;  ///< by ascending id: the plan's, and those by rule (modeler/lighting)

    /// Of the plan's walls, floors and ceilings: named by surface_textures.h.
    std::vector<std::shared_ptr<const accel::InputTexture>> pictures;

    std::string plan_json;          ///< the cleaned plan, canonical
    Stack stack;                    ///< what the volumes were made from; empty in a building read back from a scene
    CutOptions cut_options;         ///< how its regions were cut
    std::vector<RegionCut> cuts;    ///< [stack.regions.size()] for edits: regions that do not change are not cut again
    std::vector<Finding> findings;  ///< of the readers, of cleaning, of arranging and of stacking
};

}  // namespace enfilade::modeler
