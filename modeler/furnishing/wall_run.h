#pragma once
// The walls of a room as furniture sees them: straight runs, and the way around the room.

#include <vector>

#include "modeler/furnishing/room_shape.h"

namespace enfilade::modeler {

/// A stretch of a run with one thing beyond it; grid units from the run's start.
struct WallSpan {
    double from = 0;
    double to = 0;
    Beyond beyond = Beyond::Wall;
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    std::int32_t wall_top = 0;
};

/// Consecutive sides on one line (within the grid's rounding). The room is on the left.
struct WallRun {
    plans::Point a, b;
    plans::Point along;   ///< unit vector
    plans::Point inward;  ///< unit vector
    double length = 0;
    double turn_before = 0;  ///< radians to the run before it, to the left positive: the room's corners; 0: straight on
    double turn_after = 0;
    std::vector<WallSpan> spans;
    double start = 0;  ///< along the ring
};

struct WallRing {
    std::vector<WallRun> runs;
    double length = 0;
    [[nodiscard]] plans::Point at(double s) const;  ///< the point at that way around, from any whole number of rounds
};

[[nodiscard]] std::vector<WallRing> wall_rings(const RoomShape& room);

/// Whether [from, to] of the run has wall behind it between two levels (windows beyond those levels count as wall), and
/// no passage.
[[nodiscard]] bool is_backed(const WallRun& run, double from, double to, std::int32_t z_low, std::int32_t z_high);

}  // namespace enfilade::modeler
