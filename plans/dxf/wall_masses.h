#pragma once
// Masses from the outlines of wall lines.

#include <vector>

#include "plans/dxf/wall_runs.h"

namespace enfilade::plans {

/// Closed outlines of wall lines, of at most 8 m2, that the runs leave more than a splinter of, and along whose outside
/// there is mostly no wall: around a room or shaft there would be walls. Cost: n log n.
[[nodiscard]] std::vector<WallMass> wall_masses(const std::vector<SheetStroke>& strokes,
                                                const std::vector<WallRun>& runs);

/// Leads the ends of runs that meet a mass, or stop short of it by `reach` metres at most, 6 cm into it.
void lead_into_masses(std::vector<WallRun>& runs, const std::vector<WallMass>& masses, double reach);

}  // namespace enfilade::plans
