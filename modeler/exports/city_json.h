#pragma once
// A building as CityJSON 2.0, for city models and their viewers.

#include <string>

#include "modeler/building.h"

namespace enfilade::modeler {

/// One Building, a BuildingStorey a storey, and under it: rooms, stairs and shafts as BuildingRoom, walls, columns and
/// slabs as BuildingConstructiveElement, doors, windows and openings (the holes through their walls) as
/// BuildingInstallation. Geometry: Solid, one exact closed shell for each part of a space (MultiSolid where a wall has
/// several), level of detail 3, z up, vertices shared and exactly those of the building's grid (`transform`). Surfaces
/// say what they are: FloorSurface, CeilingSurface, InteriorWallSurface, WallSurface, RoofSurface, GroundSurface,
/// OuterCeilingSurface, OuterFloorSurface, Door, Window, ClosureSurface; `adjacent` names the object on their other
/// side. The exterior and the ground are left out. About 5 kB a room. Convex pieces do not show.
/// Throws InputError (F22) where the border of a space does not close.
[[nodiscard]] std::string to_cityjson(const Building& building);

}  // namespace enfilade::modeler
