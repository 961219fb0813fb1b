#pragma once
// How far a piece is from convex, and how wide it is.

#include <span>

#include "modeler/cutting/polygon.h"

namespace enfilade::testing {

/// Largest distance, in grid units, of a corner from the chord of the run of sides of one line on which it lies.
[[nodiscard]] double stray(std::span<const modeler::RingCorner> ring);

struct PieceShape {
    double width = 0;            ///< grid units: the narrowest strip that holds the piece
    bool between_walls = false;  ///< both long sides of that strip are sides of the polygon for the better part
    double dent = 0;             ///< grid units: largest distance of a corner from the convex hull of all
};

/// \pre the ring is simple and counter-clockwise
[[nodiscard]] PieceShape piece_shape(std::span<const plans::GridPoint> points,
                                     std::span<const modeler::PolygonSide> ring);

}  // namespace enfilade::testing
