#pragma once
// From the flat layout to what stands over each place of it: bands, columns, and the regions that they form.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "accel/label.h"
#include "base/finding.h"
#include "modeler/editing/box.h"
#include "plans/layout.h"
#include "plans/plan.h"

namespace enfilade::modeler {

using accel::Label;

/// One room, wall, door, slab ... as people know it ("parent" of its volumes in the constraints' words).
struct Space {
    Label label = Label::Outside;
    std::string id;
    std::string name;
    std::string kind;                             ///< of rooms; "column" for columns; empty else
    std::uint32_t storey = UINT32_MAX;            ///< into Stack::storeys; of slabs: the storey whose floor they carry
    double area_m2 = 0;                           ///< of rooms
    std::optional<plans::Colour> colour;          ///< of its surfaces; of rooms: the floor
    std::optional<plans::Colour> ceiling_colour;  ///< of rooms
    bool closed = false;                          ///< a door whose leaf is shut
    std::uint32_t room = UINT32_MAX;              ///< of objects: the space in which they stand
};

struct StoreyInfo {
    std::string id;
    std::string name;
    std::int32_t z_floor = 0;
    std::int32_t z_ceiling = 0;
};

/// The colour that the plan gives to the side of a wall that lies on a line.
struct WallColour {
    std::uint32_t line = 0;
    std::uint32_t wall_space = 0;  ///< into Stack::spaces
    plans::Colour colour = {};
};

/// Part of a column, from the slice below it (or the band's bottom) up to `z_high`.
struct Slice {
    std::int32_t z_high = 0;
    Label label = Label::Outside;
    std::uint32_t space = 0;
    friend bool operator==(const Slice&, const Slice&) = default;
};

/// A horizontal layer of the site in which the plan does not change: the ground, a slab, a storey, the air above.
struct Band {
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
};

/// Slices from bottom to top of a band.
struct Column {
    std::uint32_t first_slice = 0;
    std::uint32_t slice_count = 0;
};

/// A connected part of the plan over which the columns of the bands first_band ... last_band are the same. Bands are
/// joined where light passes between them (air, stairs), so that pieces of the region are the same in all of them.
struct Region {
    std::uint32_t first_band = 0;
    std::uint32_t last_band = 0;
    std::uint32_t first_column = 0;     ///< into Stack::region_columns: one column per band
    std::uint32_t first_half_edge = 0;  ///< into Stack::boundary
    std::uint32_t half_edge_count = 0;  ///< boundary half-edges, region on the left, in no order
    bool carries_light = false;         ///< in some slice
};

struct StackEdge {
    std::uint32_t a = 0;  ///< into Stack::points
    std::uint32_t b = 0;
    std::uint32_t line = 0;
};

/// What `realise` turns into volumes.
struct Stack {
    plans::GridFrame frame;
    plans::GridPoint site_min;
    plans::GridPoint site_max;
    std::vector<Band> bands;  ///< bottom to top, without gaps
    std::vector<Slice> slices;
    std::vector<Column> columns;
    std::vector<Region> regions;
    std::vector<std::uint32_t> region_columns;
    std::vector<plans::GridPoint> points;
    std::vector<StackEdge> edges;         ///< a planar graph: edges meet in common points only
    std::vector<std::uint32_t> boundary;  ///< half-edges: 2 * edge, + 1 where it is run from b to a
    std::vector<Space> spaces;            ///< 0 is the exterior, 1 the ground, 2 the outside
    std::vector<StoreyInfo> storeys;
    std::uint32_t line_count = 0;
    std::vector<WallColour> wall_colours;  ///< by line, then space
    std::vector<Box> boxes;                ///< by id: what stands in its rooms (editing/place_boxes.h)
    std::shared_ptr<const Stack> bare;     ///< the same without the boxes; none where there are none
};

inline constexpr std::uint32_t exterior_space = 0;
inline constexpr std::uint32_t ground_space = 1;
inline constexpr std::uint32_t outside_space = 2;

/// Stacks the storeys of a layout. `findings` receives what was capped, moved or could not be stacked (codes P4xx).
[[nodiscard]] Stack stack(const plans::Plan& plan, const plans::Layout& layout, std::vector<Finding>& findings);

}  // namespace enfilade::modeler
