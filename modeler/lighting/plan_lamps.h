#pragma once
// The lamps that a plan places itself.

#include <span>
#include <vector>

#include "modeler/lighting/lamp.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

/// Those of the storeys that are built, by ascending id; of two with one id the first. A light of a piece of furniture
/// has that piece as its carrier. \pre plan is cleaned. Cost: n log n
[[nodiscard]] std::vector<Lamp> plan_lamps(const plans::Plan& plan, std::span<const StoreyInfo> storeys);

}  // namespace enfilade::modeler
