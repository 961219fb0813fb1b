#pragma once
// Internal to plans/: where the grid of a plan lies.

#include <cstdint>
#include <vector>

#include "plans/layout.h"

namespace enfilade::plans {

struct Site {
    GridFrame frame;
    GridPoint min;
    GridPoint max;
};

/// The grid about the middle of the chosen storeys and the site box on it. Coarsens the unit, with a finding,
/// where the site needs it. Throws InputError for numbers that are not finite, and where `snap_fixed` forbids.
[[nodiscard]] Site choose_site(const Plan& plan, const std::vector<std::uint32_t>& storeys,
                               const ArrangeOptions& options, std::vector<Finding>& findings);

}  // namespace enfilade::plans
