#pragma once
// What spaces enclose without any of them lying there: FloorspaceJS takes it for outdoors.

#include <vector>

#include "plans/floorspace/edge_graph.h"
#include "plans/floorspace/spaces.h"

namespace enfilade::plans {

struct FloorCourtyard {
    std::vector<Point> corners;  ///< counter-clockwise
    double area = 0;
};

/// Areas that spaces surround and none covers, no narrower than `least_width` metres, by the first of their pieces.
[[nodiscard]] std::vector<FloorCourtyard> find_courtyards(const FloorStory& story, const FloorSpaces& spaces,
                                                          const FloorGraph& graph, double least_width);

}  // namespace enfilade::plans
