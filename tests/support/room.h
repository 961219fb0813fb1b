#pragma once
// A polygon to cut: what the cutters of modeler/cutting are given.

#include <vector>

#include "modeler/cutting/polygon.h"

namespace enfilade::testing {

/// Sides have distinct tags, form closed loops with the room on their left, and meet in common points only.
struct Room {
    std::vector<plans::GridPoint> points;
    std::vector<modeler::PolygonSide> sides;
};

}  // namespace enfilade::testing
