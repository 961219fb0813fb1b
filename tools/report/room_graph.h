#pragma once
// Rooms and what joins them, as a graph drawn where they lie.

#include <string>

#include "tools/report/passages.h"

namespace enfilade::tools {

/// The inside of an `<svg>` for one storey, over `drawn_box`: the walls in pale, a node for each room with the number
/// of doors between it and the outside, a link through each door, opening, open border and stair.
[[nodiscard]] std::string room_graph(const PlanView& view, const Passages& passages, std::uint32_t storey);

/// "8 rooms, 9 links; 4 doors deep at most", and who cannot be reached.
[[nodiscard]] std::string room_graph_caption(const PlanView& view, const Passages& passages, std::uint32_t storey);

}  // namespace enfilade::tools
