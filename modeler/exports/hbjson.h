#pragma once
// A building as Honeybee JSON (HBJSON), for energy and daylight models (Ladybug Tools, Pollination, EnergyPlus).

#include <string>

#include "modeler/building.h"

namespace enfilade::modeler {

/// A Model with a Room for each room, stair and shaft, in its storey. Faces are those of `energy_model`: rooms as they
/// are inside, with walls of real thickness between them; the two faces through a wall or slab are paired by `Surface`
/// conditions in both directions and have equal areas, which is what Honeybee and EnergyPlus ask of them. Doors are
/// Doors, windows (and holes to the outdoors) Apertures, both paired like their faces; openings without leaf and
/// rooms that touch are AirBoundary faces. Outdoors and Ground as they are; Adiabatic where no room is straight across
/// (ends of walls, columns, walls below). Metres, tolerance 1 mm. About 7 kB a room.
[[nodiscard]] std::string to_hbjson(const Building& building);

}  // namespace enfilade::modeler
