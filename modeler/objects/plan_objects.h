#pragma once
// The pieces of furniture that a plan places itself.

#include <span>
#include <vector>

#include "base/finding.h"
#include "modeler/building.h"
#include "modeler/catalogue/catalogue.h"

namespace enfilade::modeler {

/// The plan's own pieces (`building.plan_json`) as they were placed: overlaps are kept and reported, pieces in no room
/// (inside walls, on roofs) belong to the exterior or are left out with a finding. A piece whose model is in no
/// catalogue takes our own of the same kind, or else a plain box, and is reported.
/// spaces: only what stands in these (into Building::spaces) is taken; empty: everything.
[[nodiscard]] Furnishing plan_objects(const Building& building, const Catalogue& catalogue,
                                      std::span<const std::uint32_t> spaces, std::vector<Finding>& findings);

/// The room that holds a point of the plan (metres; z as storeys' elevations), or else the exterior; none<> in solids.
[[nodiscard]] std::uint32_t space_at(const Building& building, double x, double y, double z);

}  // namespace enfilade::modeler
