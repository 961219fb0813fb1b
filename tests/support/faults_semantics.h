#pragma once
// Faults of T8, S1-S6, D1 and D2, put into a sound building: each breaks one constraint and no other. Where the
// building offers no place for the fault they change nothing and return nothing.

#include <optional>

#include "modeler/building.h"
#include "plans/random.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

/// A slab becomes a wall, the ground or air; or the plan has its storey elsewhere.
std::optional<InjectedFault> inject_t8(modeler::Building& building, plans::Random& random);

/// A volume gets another label or space than it has, a face's row tells of another face.
std::optional<InjectedFault> inject_s1(modeler::Building& building, plans::Random& random);

/// The plan says that an opening is in another wall, or further along its own.
std::optional<InjectedFault> inject_s2(modeler::Building& building, plans::Random& random);

/// A wall beside a room becomes air, ground, or part of the room.
std::optional<InjectedFault> inject_s3(modeler::Building& building, plans::Random& random);

/// The slab closes over a stair, or the plan has one more stair than the model.
std::optional<InjectedFault> inject_s4(modeler::Building& building, plans::Random& random);

/// A room becomes a second exterior, or its only door a window (the building is built again).
std::optional<InjectedFault> inject_s5(modeler::Building& building, plans::Random& random);

/// The plan has one more piece of furniture: in a wall, in the place of another, or before a door.
std::optional<InjectedFault> inject_s6(modeler::Building& building, plans::Random& random);

/// A volume's row names the polygon of another one.
std::optional<InjectedFault> inject_d1(modeler::Building& building, plans::Random& random);

/// A portal's row joins another volume.
std::optional<InjectedFault> inject_d2(modeler::Building& building, plans::Random& random);

}  // namespace enfilade::testing
