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
    std::uint64_t least = 0;   ///< sum of r + 1 - min(r / 2, r - g): no partition has fewer (modeler/cutting/README.md)

    [[nodiscard]] double ratio() const { return enough == 0 ? 0 : double(pieces) / double(enough); }
    [[nodiscard]] double ratio_to_least() const { return least == 0 ? 0 : double(pieces) / double(least); }
    friend RoomPieces operator+(const RoomPieces& a, const RoomPieces& b) {
        return {a.rooms + b.rooms, a.pieces + b.pieces, a.enough + b.enough, a.reflex + b.reflex, a.least + b.least};
    }
};

/// Corners that turn right between different lines, as `reflex_corner` sees them.
struct ReflexCorners {
    std::uint32_t count = 0;    ///< r
    std::uint32_t longest = 0;  ///< g: most in one chain that turns by less than half a turn, like a curved wall
};
[[nodiscard]] ReflexCorners reflex_corners(std::span<const modeler::RingCorner> ring);

/// Over the regions that hold a room and whose boundary is one ring. `cuts`: of all regions.
[[nodiscard]] RoomPieces room_pieces(const modeler::Stack& stack, std::span<const modeler::RegionCut> cuts);

}  // namespace enfilade::tools
