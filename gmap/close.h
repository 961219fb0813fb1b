#pragma once
// A map without 3-boundary, from one that has one.

#include <utility>
#include <vector>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// Fills each connected piece of the 3-boundary with a new volume: every 3-free dart gets a twin beyond its face.
/// Returns what was created: one volume for each piece, in the order of their lowest darts; `dart` is the first twin,
/// or `none` where the map was closed. Darts free in a lower dimension stay free, and so do their twins. Undone by
/// `remove_volume` of each. Cost: the free darts and the edges they lie on.
Changes close(Map& map);

/// `close` on a copy, with the volumes that were added.
[[nodiscard]] std::pair<Map, std::vector<VolumeId>> closed_copy(const Map& map);

}  // namespace enfilade::gmap
