#pragma once
// Internal to wall_bodies: curved walls between arcs about one centre.

#include <vector>

#include "plans/dxf/wall_bodies.h"

namespace enfilade::plans::dxf {

/// Adds the curved walls, and the lengths of the arcs. The thinnest wall first; a stretch of an arc belongs to one.
void pair_curved(const std::vector<SheetStroke>& strokes, const PairLimits& limits, WallBodies& bodies);

}  // namespace enfilade::plans::dxf
