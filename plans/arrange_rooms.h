#pragma once
// Internal to plans/: places between walls -> rooms, exterior, and what is too small to be either.

#include <cstdint>
#include <vector>

#include "plans/arrange_owners.h"
#include "plans/room_match.h"

namespace enfilade::plans {

/// The room polygons of a storey on the grid.
struct RoomRings {
    std::vector<std::uint32_t> room;            ///< indices into Storey::rooms, by ascending id
    std::vector<std::vector<GridPoint>> rings;  ///< counter-clockwise
};

/// Polygons without extent are left out and named in `findings`.
[[nodiscard]] RoomRings room_rings(const Storey& storey, const GridFrame& frame, std::vector<Finding>& findings);

/// What the second step knows of one storey.
struct StoreyRooms {
    const Storey* storey = nullptr;
    const GridFrame* frame = nullptr;
    const StoreyOutlines* outlines = nullptr;
    const RoomRings* rings = nullptr;
    const RoomMatch* match = nullptr;  ///< null where the storey has no room polygons
    const Places* places = nullptr;
};

/// Completes `layout.owner` and `layout.rooms`: exterior, rooms with their names, places too small to be rooms
/// given to the wall beside them. \pre owner is `strongest_owners`
void settle_rooms(const Overlay& overlay, const StoreyRooms& from, StoreyLayout& layout,
                  std::vector<Finding>& findings);

/// What the plan's room polygons did not find: places that they share, walls that do not close around them.
void report_rooms(const StoreyRooms& from, std::vector<Finding>& findings);

}  // namespace enfilade::plans
