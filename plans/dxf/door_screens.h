#pragma once
// Doors that close the way between two walls where no wall is drawn: swings from face to face, folding doors of
// closets.

#include <vector>

#include "plans/dxf/sheet.h"
#include "plans/dxf/wall_runs.h"

namespace enfilade::plans {

/// Adds a run with a door from solid to solid for each swing (or two whose leaves meet) whose leaf, shut, reaches from
/// one solid to another, and for each row of door lines that does. `used`: [strokes] what belongs to openings
/// already. Directions of rows are those of the runs.
void add_door_screens(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes,
                      const std::vector<WallMass>& masses, std::vector<bool>& used);

}  // namespace enfilade::plans
