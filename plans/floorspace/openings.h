#pragma once
// Doors and windows of a story: out of their definitions into their walls.

#include "plans/floorspace/report.h"
#include "plans/floorspace/walls.h"

namespace enfilade::plans {

/// Places all doors and windows of `story` in the walls of `storey` (whose ids are given already, in the order of
/// `walls`). What cannot be placed is reported. `wall_height`: the story's, from floor to ceiling as the file has it,
/// of which a ratio of glass is meant.
void place_openings(const FloorFile& file, const FloorStory& story, const FloorGraph& graph, const FloorWalls& walls,
                    double wall_height, Storey& storey, FloorReport& report);

}  // namespace enfilade::plans
