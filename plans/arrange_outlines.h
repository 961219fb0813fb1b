#pragma once
// Internal to plans/: the first step of `arrange`.

#include <cstdint>
#include <vector>

#include "plans/arrange_parts.h"

namespace enfilade::plans {

/// The outlines of all walls, openings, columns, stairs and shafts of the chosen storeys on the grid, in an order
/// that does not depend on the file's. Names what the grid swallows in `findings`.
[[nodiscard]] Parts outline_parts(const Plan& plan, const std::vector<std::uint32_t>& storeys, const GridFrame& frame,
                                  const ArrangeOptions& options, std::vector<Finding>& findings);

void add_site_box(GridPoint min, GridPoint max, Parts& parts);

}  // namespace enfilade::plans
