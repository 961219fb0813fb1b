#include "accel/lights/beam_planes.h"

namespace enfilade::accel::detail {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

BeamPlane plane(const Vector& normal, double sign) {
    return {static_cast<float>(sign * normal[0]), static_cast<float>(sign * normal[1]),
            static_cast<float>(sign * normal[2])};
}

void add_side(const SceneView& view, const Vector& lamp, const BeamStep& step, std::int64_t margin,
              std::vector<BeamPlane>& planes) {
    const auto from_lamp = [&](const PlanPoint& p, double z) {
        return Vector{double(p.x) * view.unit - lamp[0], double(p.y) * view.unit - lamp[1], z * view.unit - lamp[2]};
    };
    const double low = step.beam.opening.low + double(margin), high = step.beam.opening.high - double(margin);
    const Gate& gate = step.beam.gate;
    const Vector left = from_lamp(gate.left, low), right = from_lamp(gate.right, low);
    planes.push_back(plane({left[1], -left[0], 0}, 1));
    planes.push_back(plane({right[1], -right[0], 0}, -1));
    planes.push_back(plane(cross(right, left), 1));
    planes.push_back(plane(cross(from_lamp(gate.right, high), from_lamp(gate.left, high)), -1));
}

void add_level(const SceneView& view, const Vector& lamp, const BeamStep& step, std::vector<BeamPlane>& planes) {
    const Cell& from = view.cells[index(step.from)];
    const bool is_up = view.cells[index(step.cell)].z_floor >= from.z_ceiling;
    const double z = double{is_up ? from.z_ceiling : from.z_floor} - lamp[2];
    const auto corner = [&](std::uint32_t i) {
        const std::uint32_t s = from.first_section + i % from.section_count;
        return Vector{double{view.section_x[s]} - lamp[0], double{view.section_y[s]} - lamp[1], z};
    };
    for (std::uint32_t i = 0; i < from.section_count; ++i)
        planes.push_back(plane(cross(corner(i), corner(i + 1)), is_up ? 1 : -1));
}

}  // namespace

void add_portal_planes(const SceneView& view, const Vector& lamp, const BeamStep& step, std::int64_t margin,
                       std::vector<BeamPlane>& planes) {
    if (step.is_level) add_level(view, lamp, step, planes);
    else add_side(view, lamp, step, margin, planes);
}

}  // namespace enfilade::accel::detail
