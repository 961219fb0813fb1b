#pragma once
// The ways between the gates of a room, told by a distance field.

#include <string>
#include <vector>

#include "modeler/furnishing/verify_furnished.h"

namespace enfilade::modeler {

/// Pairs of gates, as "space to space", between which a disc of 0.3 m went before the pieces that rules placed, and
/// goes no more. A node of the lattice holds the disc's middle where nothing is nearer than 0.3 m and half a step;
/// four neighbours hang together.
[[nodiscard]] std::vector<std::string> closed_ways(const RoomShape& room, const std::vector<CheckedPiece>& pieces);

}  // namespace enfilade::modeler
