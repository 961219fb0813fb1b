#pragma once
// The signs of an architect's plan: leaves of doors with their swing, panes, steps, furniture.

#include "tools/report/passages.h"
#include "tools/report/plan_view.h"
#include "tools/report/svg_path.h"

namespace enfilade::tools {

struct DoorPaths {
    SvgPath leaves;
    SvgPath swings;            ///< the quarter circles
    SvgPath sills;             ///< lines across the hole on both faces of the wall
    std::vector<MmBox> swept;  ///< around each leaf and its swing
};

/// Where the plan does not say which way a door opens, it opens away from corridors and from outdoors, into the
/// smaller room, around the jamb that is nearer to an end of its wall. From 1.3 m on it has two leaves, from 2.6 m on
/// none that swing.
[[nodiscard]] DoorPaths door_paths(const PlanView& view, const Passages& passages, std::uint32_t storey);

/// Two lines along each window.
[[nodiscard]] SvgPath window_paths(const PlanView& view, std::uint32_t storey);

/// Two lines across each opening without a leaf, where it meets the rooms.
[[nodiscard]] SvgPath opening_paths(const PlanView& view, std::uint32_t storey);

struct StairPaths {
    SvgPath treads;
    SvgPath arrows;  ///< from the first step to the last
};

/// Steps across the longer side of each stair's footprint, up from where the storey reaches it.
[[nodiscard]] StairPaths stair_paths(const PlanView& view, std::uint32_t storey);

/// Boxes of furniture, each with a line along its back.
[[nodiscard]] SvgPath furniture_paths(const PlanView& view, std::uint32_t storey);

}  // namespace enfilade::tools
