#pragma once
// Furniture that shines.

#include <vector>

#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"
#include "modeler/lighting/lamp_rules.h"

namespace enfilade::modeler {

struct PieceLamp {
    Lamp lamp;                         ///< "<piece>/lamp"
    std::uint32_t space = UINT32_MAX;  ///< that it stands in
    bool lights_room = false;
};

/// One for each object whose kind the rules know, in the order of the objects; those that carry a lamp of the building
/// already are passed over. From the middle of what of the mesh is lamp glass, else from a share of its height.
/// Cost: linear in the triangles of each used mesh, once
[[nodiscard]] std::vector<PieceLamp> piece_lamps(const Building& building, const LampRules& rules,
                                                 const Catalogue& catalogue);

}  // namespace enfilade::modeler
