#pragma once
// Internal to plans/: which lines of the plan are one straight line.

#include <vector>

#include "plans/arrange_parts.h"

namespace enfilade::plans {

/// The least line of the group of each line ([parts.lines.size()]). Lines that lie on one edge, or continue each
/// other at a joint, are one as long as all ends of the group lie within one grid unit of its longest span.
[[nodiscard]] std::vector<std::uint32_t> straight_groups(const Parts& parts, const NodedGraph& graph);

}  // namespace enfilade::plans
