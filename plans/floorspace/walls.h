#pragma once
// Walls from the pieces of a story's edges: one for each straight chain that nothing ends on.

#include <vector>

#include "plans/floorspace/edge_graph.h"
#include "plans/floorspace/spaces.h"

namespace enfilade::plans {

/// Where a piece lies in its wall: the wall's offset of the piece's a, and whether the wall runs from a to b.
struct FloorPiecePlace {
    std::uint32_t wall = 0;
    double offset = 0;
    bool forward = true;
};

struct FloorWall {
    std::uint32_t edge = 0;  ///< the first edge of the file that lies in it
    Point start;
    Point end;
    double thickness = 0;
    /// Metres at its ends that other walls take up: no opening can be there.
    double taken_at_start = 0;
    double taken_at_end = 0;
};

struct FloorWalls {
    std::vector<FloorWall> walls;
    std::vector<FloorPiecePlace> of_piece;  ///< [FloorGraph::pieces]
    std::vector<std::uint32_t> thinned;     ///< outlines for which walls are thinner than asked for
    std::vector<std::uint32_t> lost;        ///< outlines narrower than any walls, ascending
};

/// `thickness`: metres asked for, greater than 0. Walls of a narrow space are as thick as its area divided by its
/// perimeter, so that half of the circle that fits into it stays free (that circle's radius is no less, for any simple
/// polygon: Bonnesen), but 2 cm at least.
[[nodiscard]] FloorWalls make_walls(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph,
                                    double thickness);

}  // namespace enfilade::plans
