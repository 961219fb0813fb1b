#pragma once
// Walls of glass: panes that are drawn from wall to wall without a wall's faces.

#include <vector>

#include "plans/dxf/sheet.h"
#include "plans/dxf/wall_masses.h"
#include "plans/dxf/wall_runs.h"

namespace enfilade::plans {

/// Adds a run for each band of lines of window or opening layers, at most 25 cm wide and at least 30 cm long, that
/// reaches from wall (or mass) to wall, or to other such bands, and stands neither in nor along a wall. All of it is an
/// opening. `used`: [strokes] what belongs to openings already.
void add_panes(std::vector<WallRun>& runs, const std::vector<SheetStroke>& strokes, const std::vector<WallMass>& masses,
               std::vector<bool>& used);

}  // namespace enfilade::plans
