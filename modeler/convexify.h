#pragma once
// Rooms into convex cells.

#include "modeler/building.h"

namespace enfilade::modeler {

enum class Convexifier : std::uint8_t {
    HertelMehlhorn,  ///< constrained Delaunay triangulation, diagonals taken out while pieces stay convex
};

/// The building with every volume that carries light cut into convex pieces: pieces keep the space and the parent of
/// the volume that they are cut from. \pre the building comes from `build` (it holds its stack).
/// \post no corner of a cell's floor is reflex between different lines (constraint G8)
[[nodiscard]] Building convexify(const Building& building, Convexifier convexifier = Convexifier::HertelMehlhorn);

}  // namespace enfilade::modeler
