#pragma once
// The strokes of a drawing in metres, sorted by what they are part of.

#include <optional>
#include <vector>

#include "plans/dxf/drawing.h"
#include "plans/dxf/role.h"

namespace enfilade::plans {

struct SheetStroke {
    Stroke stroke;  ///< metres
    Role role = Role::Unknown;
    std::uint32_t shape = 0;  ///< into Drawing::shapes
    const RoleRule* rule = nullptr;
};

/// A circle arc as centre, radius and angles.
struct CircleArc {
    Point centre;
    double radius = 0;
    double start = 0;
    double sweep = 0;  ///< counter-clockwise positive
};

/// \pre stroke.bulge != 0
[[nodiscard]] CircleArc circle_arc(const Stroke& stroke);

/// All strokes that have a role other than Ignored, scaled and moved so that (x0, y0) of the bounds stays where it is.
[[nodiscard]] std::vector<SheetStroke> sheet_strokes(const Drawing& drawing, const Roles& roles, double scale);

}  // namespace enfilade::plans
