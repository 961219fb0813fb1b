#pragma once
// S6 for objects that a rule has placed.

#include "modeler/constraints/constraints.h"

namespace enfilade::modeler {

/// Objects placed by rule lie in their room, reach into no other object (but for what carries them) and leave doors
/// their sweeps, by their boxes: errors. Objects that the plan places count only as what is in the way: what they do
/// themselves is told of the plan.
void check_furnished_objects(const Subject& subject, CheckReport& report);

}  // namespace enfilade::modeler
