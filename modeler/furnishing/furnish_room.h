#pragma once
// One room furnished by its rules.

#include <span>
#include <string>
#include <vector>

#include "modeler/furnishing/entry_lists.h"
#include "modeler/furnishing/occupancy.h"

namespace enfilade::modeler {

/// What stands in the room already.
struct StandingPiece {
    Ring footprint;  ///< convex, counter-clockwise
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    std::string kind;  ///< of its catalogue entry; empty: none
};

struct RoomPiece {
    const CatalogueEntry* entry = nullptr;
    Pose pose;                           ///< grid units
    std::int32_t z_low = 0;              ///< grid level
    std::array<double, 3> size = {};     ///< metres
    std::uint32_t carrier = UINT32_MAX;  ///< into RoomLayout::pieces
};

struct RoomLayout {
    std::vector<RoomPiece> pieces;
    std::uint32_t requested = 0;
    std::vector<std::string> no_place;  ///< kinds, once each, in the order of the rules
    std::vector<std::string> unknown;   ///< kinds that no catalogue has
};

/// What the rules ask for, placed group by group: candidate places are scored and drawn by probability; a group stays
/// where all its hard conditions hold and all ways are open still. Tries are counted: it ends after
/// O(requests * candidates) tests whatever the room is. Pure: the same arguments give the same layout.
[[nodiscard]] RoomLayout furnish_room(const RoomShape& room, const RoomRules& rules, double temperature,
                                      const EntryLists& entries, std::span<const StandingPiece> standing,
                                      std::uint64_t seed);

}  // namespace enfilade::modeler
