#pragma once
// What a room sees through its walls: the room, or the outdoors, that lies straight across each stretch of them.

#include <cstdint>
#include <vector>

#include "modeler/space_parts.h"

namespace enfilade::modeler {

enum class Across : std::uint8_t {
    Nothing,  ///< the end of another wall, a column, more than `most_thickness` of wall: no heat passes
    Part,     ///< another part with light (maybe the same one)
    Outdoors,
    Ground,
};

/// A door, window or opening in a wall tile. `u` in metres along the side, z in metres of the frame.
struct WallOpening {
    std::uint32_t part = 0;  ///< of the door or window
    double u_low = 0, u_high = 0, z_low = 0, z_high = 0;
};

/// A rectangle of one side with one thing across it.
struct WallTile {
    Across across = Across::Nothing;
    bool is_air = false;     ///< nothing solid between: the two touch, or an opening without leaf joins them
    std::uint32_t part = 0;  ///< Across::Part: into the parts
    std::uint32_t side = 0;  ///< Across::Part: into WallViews::sides
    double u_low = 0, u_high = 0, z_low = 0, z_high = 0;
    std::vector<WallOpening> openings;  ///< by part; inside of the rectangle
};

/// A straight side of a part, from `from` to `to` (metres of the frame), the part on the left.
struct ViewedSide {
    std::uint32_t part = 0;
    std::array<double, 2> from = {};
    std::array<double, 2> to = {};
    std::vector<WallTile> tiles;  ///< they tile the side; none for parts that are no rooms
};

struct WallViews {
    std::vector<ViewedSide> sides;  ///< by part
};

/// The sides of all parts with light, and the tiles of those of rooms, stairs and shafts. A tile looks at right angles
/// to its side, through walls of up to `most_thickness` metres. Stretches of less than a millimetre are given to their
/// neighbours. Cost: linear for walls of bounded length.
[[nodiscard]] WallViews wall_views(const Building& building, const std::vector<SpacePart>& parts,
                                   double most_thickness = 1.5);

/// Parts that are rooms to an energy model: rooms, stairs, shafts.
[[nodiscard]] bool is_room(const Building& building, const SpacePart& part);

}  // namespace enfilade::modeler
