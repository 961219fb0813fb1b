#pragma once
// Exact measures of volumes, from the map and its integer points alone.

#include <optional>
#include <vector>

#include "modeler/building.h"

namespace enfilade::modeler {

using Int128 = __int128;

/// Six times the volume of each 3-cell, in cubed grid units, positive for cells that face like most of space
/// (`Outside` is negative). Nothing where the map is not orientable: then inside and outside have no meaning.
/// [map volume bound] Cost: linear in the darts.
[[nodiscard]] std::optional<std::vector<Int128>> volumes6(const gmap::Map& map,
                                                          const std::vector<std::array<std::int32_t, 3>>& vertices);

}  // namespace enfilade::modeler
