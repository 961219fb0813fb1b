#pragma once
// For the operations of this folder only: cell ids made equal to the orbits again where an operation changed them.

#include <cstdint>
#include <span>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap::detail {

/// Gives each orbit of dimension `i` through `touched` one id. Darts may carry `none_u32` before. Of the ids in an
/// orbit the lowest stays, unless an orbit that comes earlier in `touched` has taken it; the others are reported as
/// merged into it. An orbit left without id gets a new one, reported as split off, or as created. `lost`: ids of erased
/// darts, reported as removed where no orbit has them any more. \pre every orbit that shares an id with a touched one
/// is touched. Cost: the darts of those orbits.
void update_cells(Map& map, int i, std::span<const DartId> touched, Changes& changes,
                  std::span<const std::uint32_t> lost = {});

/// Numbers all cells from the orbits, in the order of their first darts. \pre no dart has a cell, and no cell is
/// counted.
void number_cells(Map& map);

}  // namespace enfilade::gmap::detail
