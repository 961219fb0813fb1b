#pragma once
// A building's map taken apart into faces and put together again, so that faults can be built that no plan has.

#include "gmap/cell_tuples.h"
#include "modeler/building.h"

namespace enfilade::testing {

/// The faces of the map, in the order of their ids. \pre the topology is sound
[[nodiscard]] gmap::CellTuples tuples_of(const modeler::Building& building);

/// Makes the map of the tuples; faces beyond those that the building knows are appended to its tables as copies of
/// `like`. \pre vertices and volumes are those of the building
void rebuild(modeler::Building& building, const gmap::CellTuples& tuples, std::uint32_t like = 0);

/// Replaces a face by the triangles between its sides and a new vertex at `apex`, whose id is returned.
std::uint32_t raise_spike(modeler::Building& building, std::uint32_t face, const std::array<std::int32_t, 3>& apex);

}  // namespace enfilade::testing
