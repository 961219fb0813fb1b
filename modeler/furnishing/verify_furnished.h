#pragma once
// Whether the guarantees of furnishing hold, told without the code that keeps them.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/building.h"
#include "modeler/furnishing/room_shape.h"

namespace enfilade::modeler {

enum class FurnishingFault : std::uint8_t { Overlap, Outside, DoorBlocked, WindowBlocked, Unreachable };
[[nodiscard]] std::string_view name_of(FurnishingFault fault);

struct FurnishingViolation {
    FurnishingFault fault = FurnishingFault::Overlap;
    std::uint32_t space = 0;  ///< the room; UINT32_MAX where a room stands for itself
    std::string object;       ///< its id; empty where a way is closed
    std::string other;        ///< the object that it overlaps, or what it stands in the way of
};

/// All objects that were placed by rule (`by_rule`) against each other and against what was there before, the rooms'
/// outlines, the sweeps of doors, windows; and the ways between the gates of each room, with and without those objects.
/// Overlaps are those of the boxes rounded outward to the grid; exempt are pairs of which one stands on the other.
/// Empty: all holds. Cost: objects of a room by pairs, and two fillings of a lattice of 2 cm for each room
[[nodiscard]] std::vector<FurnishingViolation> verify_furnished(const Building& building, const Furnishing& furnishing);

/// The same for one room.
struct CheckedPiece {
    std::string id;
    Ring footprint;
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    bool by_rule = true;
    std::string stands_on;
};
[[nodiscard]] std::vector<FurnishingViolation> verify_room(const RoomShape& room,
                                                           const std::vector<CheckedPiece>& pieces);

}  // namespace enfilade::modeler
