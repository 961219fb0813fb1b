#pragma once
// Lamps under the ceiling of a room.

#include <span>
#include <vector>

#include "modeler/building.h"
#include "modeler/furnishing/room_shape.h"
#include "modeler/lighting/lamp_rules.h"
#include "modeler/volume_finder.h"

namespace enfilade::modeler {

/// `count` lamps (or so many as there is room for; of a grid a few more or less where it is not exact), which share
/// what the room asks for: "<room>/lamp-1" ... objects: those in the room.
[[nodiscard]] std::vector<Lamp> ceiling_lamps(const RoomShape& room, const RoomLight& light, double utilisation,
                                              std::size_t count, bool is_exact, const VolumeFinder& volumes,
                                              std::span<const FurnishedObject* const> objects);

/// The flux that a room needs, lumen.
[[nodiscard]] double room_lumen(double area_m2, const RoomLight& light, double utilisation);

/// A place in millimetres: what is said of lamps is short, and the same on every machine.
[[nodiscard]] std::array<double, 3> to_millimetres(const std::array<double, 3>& place);

}  // namespace enfilade::modeler
