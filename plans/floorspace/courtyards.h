#pragma once
// What spaces enclose without any of them lying there: FloorspaceJS takes it for outdoors.

#include <vector>

#include "plans/floorspace/edge_graph.h"
#include "plans/floorspace/spaces.h"

namespace enfilade::plans {

/// An area that spaces surround and none covers.
struct FloorCourtyard {
    FloorOutline outline;       ///< of no space
    std::vector<Point> beside;  ///< places in it, at the middle of each of its sides
    bool narrow = false;        ///< walls fill it
    bool covered = false;       ///< stories above lie over all of it
};

struct FloorVoids {
    std::vector<FloorCourtyard> courtyards;  ///< by the first of their pieces
    std::vector<Point> beside;               ///< places just outside of spaces, at the middle of each piece
};

/// `least_width`: metres; what is narrower is no courtyard. \post `covered` is not set yet
[[nodiscard]] FloorVoids find_voids(const FloorStory& story, const FloorSpaces& spaces, const FloorGraph& graph,
                                    double least_width);

/// Sets `covered` where no place of a courtyard is seen that has the sky over it. Both by story, from the bottom up.
void find_covered(const std::vector<FloorSpaces>& spaces, std::vector<FloorVoids>& voids);

}  // namespace enfilade::plans
