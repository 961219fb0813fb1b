#pragma once
// Lamps in the open air: over doors and on the site.

#include <vector>

#include "modeler/building.h"
#include "modeler/lighting/lamp_rules.h"
#include "modeler/volume_finder.h"

namespace enfilade::modeler {

/// Over each door into the open one lamp, outside, a hand's breadth from the wall and over the lintel.
[[nodiscard]] std::vector<Lamp> entrance_lamps(const Building& building, const OutdoorLight& light,
                                               const VolumeFinder& volumes);

/// On a square grid in the middle of the site, where a post from the ground to the lamp stands free of everything.
/// \throws InputError (U106) for more than a million places
[[nodiscard]] std::vector<Lamp> site_lamps(const Building& building, const OutdoorLight& light,
                                           const VolumeFinder& volumes);

}  // namespace enfilade::modeler
