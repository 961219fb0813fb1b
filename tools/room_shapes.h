#pragma once
// Rooms of any number of corners, to see how the time to cut them grows.

#include <cstdint>
#include <vector>

#include "modeler/cutting/polygon.h"

namespace enfilade::tools {

enum class RoomShape {
    Comb,  ///< a hall with niches along one side: pillars between them
    Star,  ///< corners in and out by turns, at uneven distances
    Arcs   ///< a corridor between two rows of round columns: walls that bulge inward, 16 chords each
};
[[nodiscard]] const char* name_of(RoomShape shape);

/// One ring, counter-clockwise, each side with a line of its own.
struct ShapedRoom {
    std::vector<plans::GridPoint> points;
    std::vector<modeler::PolygonSide> sides;
};

/// About `corners` of them (at least 64), on the grid of 1/8192 m, within 2^24 of its units up to 20,000 corners.
[[nodiscard]] ShapedRoom shaped_room(RoomShape shape, std::uint32_t corners);

}  // namespace enfilade::tools
