#pragma once
// A region of the stack divided by the footprints of boxes.

#include <cstdint>
#include <span>
#include <vector>

#include "modeler/editing/box.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

/// From one point to another along an edge of the stack, or along one of `RegionSplit::new_edges`.
struct SplitSide {
    std::uint32_t edge = 0;
    bool is_new = false;
    bool reversed = false;  ///< runs from the edge's b to its a
    plans::GridPoint from;
    plans::GridPoint to;
};

/// A connected part of the region with the same boxes over all of it.
struct RegionPart {
    std::vector<std::uint32_t> boxes;  ///< ascending; none: what is left of the region
    std::vector<SplitSide> sides;      ///< the part on the left, in no order
};

struct NewEdge {
    plans::GridPoint a;
    plans::GridPoint b;
    std::uint32_t box = 0;
    std::uint32_t side = 0;  ///< of the box's footprint
};

/// Two boxes that want the same place.
struct BoxPair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
};

struct RegionSplit {
    std::vector<RegionPart> parts;  ///< first what is left of the region
    std::vector<NewEdge> new_edges;
    std::vector<BoxPair> overlaps;
};

/// A box as one region sees it.
struct PlacedBox {
    std::uint32_t box = 0;                        ///< a number to be known by, ascending
    std::span<const plans::GridPoint> footprint;  ///< counter-clockwise
    std::int32_t z_low = 0;                       ///< within a slice of the region that the box may stand in
    std::int32_t z_high = 0;
};

/// Divides a region. Places thinner than `least_thickness` are no parts: of what two boxes share the first keeps them;
/// of a box they stay with the room; of the room, beside a box, they go to the box. \pre the boxes' ids ascend
[[nodiscard]] RegionSplit split_region(const Stack& stack, std::uint32_t region, std::span<const PlacedBox> boxes);

}  // namespace enfilade::modeler
