#pragma once
// Convex pieces with many sections cut further, where rays gain by it.

#include <span>
#include <vector>

#include "modeler/cutting/sah_partition.h"

namespace enfilade::modeler {

/// Cuts a convex ring along chords between its corners while the surface area heuristic's cost falls: a corridor with a
/// door every few metres, a round room. Appends the pieces; cuts get lines from `next_line` on. No new points.
/// `points`: given and new ones. Cost: n^2 per cut up to 64 sections, n log n beyond.
void split_sections(std::span<const plans::GridPoint> points, std::span<const PolygonSide> ring,
                    const SahOptions& options, std::uint32_t& next_line, Partition& pieces);

}  // namespace enfilade::modeler
