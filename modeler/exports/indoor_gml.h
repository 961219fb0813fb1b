#pragma once
// A building as IndoorGML 1.1, for indoor navigation.

#include <string>

#include "modeler/building.h"

namespace enfilade::modeler {

enum class IndoorGmlVersion : std::uint8_t {
    V1_0,  ///< the namespaces of 1.0, in the form of schema 1.0.3: what older readers know
    V1_1,
};

/// The cells are the spaces that one walks through: rooms (navi:GeneralSpace), stairs and shafts
/// (navi:TransitionSpace), doors and walkable openings as thick as their walls (navi:ConnectionSpace; those to the
/// outside navi:AnchorSpace, which stand for the exterior). Not among them: walls, windows, openings over low walls,
/// the exterior. Each cell is an exact Solid; cells do not overlap. Where two touch there is one
/// navi:ConnectionBoundary (navi:AnchorBoundary for the outer face of an anchor), and where both are indoors one
/// Transition between their States: the dual graph. A State lies inside its cell; a Transition runs over the middle of
/// its boundary. Coordinates are metres in the building's own frame (`srs_name`; a URN that says so by default).
/// About 16 kB a room. Convex pieces do not show. Throws InputError (F22) where the border of a space does not close.
[[nodiscard]] std::string to_indoorgml(const Building& building, IndoorGmlVersion version = IndoorGmlVersion::V1_1,
                                       const std::string& srs_name = "");

}  // namespace enfilade::modeler
