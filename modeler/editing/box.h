#pragma once
// A box that stands in a room.

#include <cstdint>
#include <string>
#include <vector>

#include "plans/grid.h"

namespace enfilade::modeler {

/// An upright prism, clipped to the room in which it stands.
struct Box {
    std::uint32_t space = 0;                  ///< the room, or the exterior: into Building::spaces
    std::vector<plans::GridPoint> footprint;  ///< a convex ring, counter-clockwise
    std::int32_t z_low = 0;                   ///< grid levels
    std::int32_t z_high = 0;
    std::string id;  ///< its own: no other box has it
    std::string name;
};

/// What is thinner than this, in grid units, is no place of its own: of a box, of the floor between box and wall, of
/// the place that two boxes share.
inline constexpr double least_thickness = 2;

}  // namespace enfilade::modeler
