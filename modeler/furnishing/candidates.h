#pragma once
// Places of a room where a piece may be tried.

#include <vector>

#include "modeler/furnishing/occupancy.h"
#include "modeler/furnishing/wall_run.h"

namespace enfilade::modeler {

/// Width and depth in grid units.
struct PieceSize {
    double width = 0;
    double depth = 0;
};

struct Candidate {
    Pose pose;
    double wall_share = -1;  ///< where along its wall: 0 and 1 its ends; below 0: at no wall
};

/// Its back to a wall, a little off it so that the footprint, rounded outward, stays inside: along straight runs at
/// their ends, beside openings and what stands there, and evenly between; along curved walls by the chord between its
/// back corners, pushed back until it touches.
/// gap: to the wall. turned: the front to the wall. z: the levels that need wall behind them, for what hangs
struct WallSearch {
    PieceSize size;
    double gap = 0;
    bool turned = false;
    bool hangs = false;
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
};
[[nodiscard]] std::vector<Candidate> wall_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings,
                                                     const WallSearch& search);

/// Free in the room, turned as its longest wall or across it.
[[nodiscard]] std::vector<Candidate> middle_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings,
                                                       PieceSize size);

/// The places of a grid along the longest wall, row by row; `way` between the rows.
[[nodiscard]] std::vector<Candidate> row_candidates(const Occupancy& occupancy, const std::vector<WallRing>& rings,
                                                    PieceSize size, double way);

/// So many places under the ceiling, spread over the floor (Lloyd 1982).
[[nodiscard]] std::vector<plans::Point> spread_over(const RoomShape& room, const std::vector<WallRing>& rings,
                                                    std::uint32_t count);

/// The pose moved against its front until its back is `gap` off a wall; none where no wall is within `most`, or where
/// it would have to come forward by more than that. Grid units.
[[nodiscard]] std::optional<Pose> pushed_back(const RoomShape& room, Pose pose, PieceSize size, double gap,
                                              double most);

/// The way of the room's longest wall.
[[nodiscard]] plans::Point main_way(const std::vector<WallRing>& rings);

}  // namespace enfilade::modeler
