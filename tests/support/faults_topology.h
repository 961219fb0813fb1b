#pragma once
// Faults of T1-T7, G5 and G8, put into a sound building: each breaks one constraint and no other. Where the building
// offers no place for the fault they change nothing and return nothing.

#include <optional>

#include "modeler/building.h"
#include "plans/random.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

/// One number of the map's arrays is another one: a dart's link, or the cell that it says it is of.
std::optional<InjectedFault> inject_t1(modeler::Building& building, plans::Random& random);

/// The two sides of a face, or of an edge on a shell, or of a corner of a face, let go of each other.
std::optional<InjectedFault> inject_t2(modeler::Building& building, plans::Random& random);

/// A face is glued to its other side in a mirror.
std::optional<InjectedFault> inject_t3(modeler::Building& building, plans::Random& random);

/// Two faces, or two edges, go by one id.
std::optional<InjectedFault> inject_t4(modeler::Building& building, plans::Random& random);

/// Two vertices go by one id.
std::optional<InjectedFault> inject_t5(modeler::Building& building, plans::Random& random);

/// An edge dangles in a face, or a face has two edges.
std::optional<InjectedFault> inject_t6(modeler::Building& building, plans::Random& random);

/// Volumes of one space around something become one volume with a hole.
std::optional<InjectedFault> inject_t7(modeler::Building& building, plans::Random& random);

/// A side of the hull is moved, or the site box that it should be.
std::optional<InjectedFault> inject_g5(modeler::Building& building, plans::Random& random);

/// A volume is higher in the table than in the map, or a piece has a corner elsewhere. Convex buildings alone.
std::optional<InjectedFault> inject_g8(modeler::Building& building, plans::Random& random);

}  // namespace enfilade::testing
