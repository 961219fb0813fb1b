#include "plans/dxf/sheet.h"

#include <cmath>

#include "plans/vector2.h"

namespace enfilade::plans {

CircleArc circle_arc(const Stroke& stroke) {
    const double half = 2 * std::atan(stroke.bulge);  // half the swept angle, signed
    const Point chord = stroke.b - stroke.a;
    const Point middle = (stroke.a + stroke.b) * 0.5;
    const double height = norm(chord) / 2 / std::tan(half);
    CircleArc arc;
    arc.centre = middle + turned_left(chord) * (height / norm(chord));
    arc.radius = distance(arc.centre, stroke.a);
    const Point from = stroke.a - arc.centre;
    arc.start = std::atan2(from.y, from.x);
    arc.sweep = 2 * half;
    return arc;
}

std::vector<SheetStroke> sheet_strokes(const Drawing& drawing, const Roles& roles, double scale) {
    std::vector<SheetStroke> strokes;
    for (std::uint32_t k = 0; k < drawing.shapes.size(); ++k) {
        const Shape& shape = drawing.shapes[k];
        const Role role = roles.of(drawing, shape);
        if (role == Role::Ignored || role == Role::RoomName) continue;
        for (std::uint32_t s = 0; s < shape.stroke_count; ++s) {
            const Stroke& stroke = drawing.strokes[shape.first_stroke + s];
            strokes.push_back(
                {{stroke.a * scale, stroke.b * scale, stroke.bulge}, role, k, roles.rule_of(drawing, shape)});
        }
    }
    return strokes;
}

}  // namespace enfilade::plans
