#pragma once
// Faults of T8, S1-S6 and D1, put into a sound building: each breaks one constraint and no other. Where the building
// offers no place for the fault they change nothing and return nothing.

#include <optional>

#include "modeler/building.h"
#include "plans/random.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

/// A slab becomes a wall, the ground or air; or the plan has its storey elsewhere.
std::optional<InjectedFault> inject_t8(modeler::Building& building, plans::Random& random);

}  // namespace enfilade::testing
