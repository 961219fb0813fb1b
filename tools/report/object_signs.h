#pragma once
// How furniture is drawn on a plan: its box, with an arrow out of its front.

#include <array>
#include <cstdint>

#include "accel/scene.h"
#include "tools/report/plan_view.h"
#include "tools/report/svg_path.h"

namespace enfilade::tools {

/// What stands or hangs below this height above a storey's floor is drawn, if it is no speck: metres.
inline constexpr double drawn_below = 1.8;
inline constexpr double least_drawn = 0.25;

/// corner(x, y): a place of the box, from (-1, -1), the left of its front, to (1, 1), the right of its back.
template <class Corner>
void add_object_sign(SvgPath& path, const Corner& corner) {
    path.ring(std::array<Mm, 4>{corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)});
    path.polyline(std::array<Mm, 3>{corner(-0.3, -0.62), corner(0, -0.94), corner(0.3, -0.62)});
}

/// The objects that a building holds on a storey.
[[nodiscard]] SvgPath object_paths(const PlanView& view, std::uint32_t storey);
/// The same of a scene's storey, in millimetres of its frame.
[[nodiscard]] SvgPath object_paths(const accel::SceneView& scene, std::uint32_t storey_index);

}  // namespace enfilade::tools
