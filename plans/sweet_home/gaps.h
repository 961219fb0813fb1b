#pragma once
// A door that stands between two walls instead of in one.

#include <optional>

#include "plans/sweet_home/bodies.h"
#include "plans/sweet_home/parts.h"

namespace enfilade::plans {

/// The wall that closes the gap a door stands in, and the door in it.
struct ClosedGap {
    Wall wall;          ///< without id
    double offset = 0;  ///< of the door along it
    double width = 0;   ///< of the door: at most the gap's, less a jamb on each side
    double clear = 0;   ///< m, between the walls on both sides
    double moved = 0;   ///< m, how far the door moved aside or became narrower, whichever is more
};

/// Looks for a wall on either side of the door, not farther apart than a door needs: wall ends in line with it, or the
/// faces of walls across. Nothing where there are none, or a wall stands in between.
[[nodiscard]] std::optional<ClosedGap> close_gap(const PlacedOpening& door, const Storey& storey,
                                                 const StoreyBodies& bodies);

/// How far from a door's middle walls matter to it.
[[nodiscard]] double reach_of(const PlacedOpening& door);

}  // namespace enfilade::plans
