#pragma once
// Faults of G1-G9, put into a sound building: each breaks one constraint and no other. Where the building offers no
// place for the fault they change nothing and return nothing.

#include <optional>

#include "modeler/building.h"
#include "plans/random.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

/// A vertex is moved onto another one.
std::optional<InjectedFault> inject_g1(modeler::Building& building, plans::Random& random);

/// A corner of a level face is pulled across one of its other sides.
std::optional<InjectedFault> inject_g2(modeler::Building& building, plans::Random& random);

/// A vertex is moved by a unit of the grid up to centimetres, so that a face is bent.
std::optional<InjectedFault> inject_g3(modeler::Building& building, plans::Random& random);

/// A face of a volume becomes a spike through an opposite one.
std::optional<InjectedFault> inject_g4(modeler::Building& building, plans::Random& random);

/// The building is built again with a wall or slab of a few millimetres. (A warning.)
std::optional<InjectedFault> inject_g6(modeler::Building& building, plans::Random& random);

/// An edge of a face is moved so that the face tilts and all faces stay flat.
std::optional<InjectedFault> inject_g7(modeler::Building& building, plans::Random& random);

/// A corner of a curved wall is moved off its circle by some millimetres, over its whole height.
std::optional<InjectedFault> inject_g9(modeler::Building& building, plans::Random& random);

/// Moves all that lies at `from` or above by `by` units, in the map, the tables and the plan alike.
void shift_levels(modeler::Building& building, std::int32_t from, std::int32_t by);

}  // namespace enfilade::testing
