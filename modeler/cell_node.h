#pragma once
// The point that stands for a volume: the node of its cell in graphs, in IndoorGML, and for labels.

#include <array>
#include <cstdint>
#include <span>

#include "modeler/building.h"

namespace enfilade::modeler {

/// A point inside a simple ring of either direction, in grid units: the centroid where it is well inside (always for
/// convex rings), else the middle of the widest of some horizontal chords. Strictly inside where the ring has area.
/// Cost: corners times the logarithm of the corners, times 16 where the centroid is outside.
[[nodiscard]] std::array<double, 2> inner_point(std::span<const plans::GridPoint> ring);

/// A point inside a volume, half way between its floor and its ceiling, in world metres. Of `Outside`: a point above
/// the middle of the site box. \pre volume < building.volumes.size()
[[nodiscard]] std::array<double, 3> cell_node(const Building& building, std::uint32_t volume);

}  // namespace enfilade::modeler
