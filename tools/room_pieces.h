#pragma once
// How many pieces rooms are cut into, beside what no way of cutting can beat by much.

#include <cstdint>
#include <span>

#include "modeler/cutting/cut.h"
#include "modeler/stack.h"

namespace enfilade::tools {

struct RoomPieces {
    std::uint64_t rooms = 0;
    std::uint64_t pieces = 0;
    std::uint64_t enough = 0;  ///< sum of ceil(r / 2) + 1 over the rooms; of 1 where r is 0
    std::uint64_t reflex = 0;  ///< r: corners that turn right, between different lines

    [[nodiscard]] double ratio() const { return enough == 0 ? 0 : double(pieces) / double(enough); }
    friend RoomPieces operator+(const RoomPieces& a, const RoomPieces& b) {
        return {a.rooms + b.rooms, a.pieces + b.pieces, a.enough + b.enough, a.reflex + b.reflex};
    }
};

/// Corners that turn right between different lines, as `reflex_corner` sees them.
[[nodiscard]] std::uint32_t reflex_count(std::span<const modeler::RingCorner> ring);

/// Over the regions that hold a room and whose boundary is one ring. `cuts`: of all regions.
[[nodiscard]] RoomPieces room_pieces(const modeler::Stack& stack, std::span<const modeler::RegionCut> cuts);

}  // namespace enfilade::tools
