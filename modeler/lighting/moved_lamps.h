#pragma once
// Lamps go with the furniture that carries them.

#include <vector>

#include "modeler/lighting/lamp.h"
#include "modeler/objects/furnishing.h"

namespace enfilade::modeler {

/// The lamps of a building whose furniture `before` becomes `after`: one that a piece carries moves, turns and grows
/// with it, and goes where the piece does; all others stay. Order stays. Cost: (lamps + objects) log objects
[[nodiscard]] std::vector<Lamp> moved_lamps(std::vector<Lamp> lamps, const Furnishing& before, const Furnishing& after);

}  // namespace enfilade::modeler
