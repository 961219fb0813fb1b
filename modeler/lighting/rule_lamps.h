#pragma once
// Lamps by rule: under ceilings, in the furniture that is made to shine, and in the open air.

#include <vector>

#include "accel/parallel_for.h"
#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/lighting/lamp_rules.h"

namespace enfilade::modeler {

/// The lamps that rules add to a building, by ascending id; the building's own stay out of it.
/// - Rooms get lamps under their ceiling by area and kind ("<room>/lamp-1" ...), where neither the plan nor a piece of
///   the rules that `lights_room` has one already (with `count`: exactly so many in all, whatever the plan has).
///   They hang in the room, off its walls, in no column, box or cupboard.
/// - Pieces that are lamps shine ("<piece>/lamp"), but for those of which the plan says how: from the middle of their
///   glass, and throw no shadow of it.
/// - Over doors into the open hangs one each ("<door>/lamp"), over the ground one at each place of a square grid that
///   no building covers ("site/lamp-<column>-<row>").
/// What a room gets depends on nothing but that room: the same lamps, whatever the order of the plan's elements, on any
/// number of threads. catalogue: of the pieces; nullptr: our own.
/// \throws InputError (U106) where the grid outside has more than a million places
[[nodiscard]] std::vector<Lamp> rule_lamps(const Building& building, const LampRules& rules,
                                           const Catalogue* catalogue = nullptr,
                                           const accel::Executor& executor = accel::SerialExecutor());

/// Puts them into the building, with or instead of its own (`LampRules::replace`). An id that is taken gets "-2" ...
void light_building(Building& building, const LampRules& rules, const Catalogue* catalogue = nullptr,
                    const accel::Executor& executor = accel::SerialExecutor());

}  // namespace enfilade::modeler
