#include "plans/dxf/gap.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double reach = 0.12;  ///< metres by which symbols may stand out of the gap they belong to

struct Local {
    double u;
    double v;
};

}  // namespace

std::optional<DoorSwing> door_swing(const SheetStroke& stroke) {
    if (stroke.stroke.bulge == 0 || (stroke.role != Role::Door && stroke.role != Role::Opening)) return std::nullopt;
    const CircleArc arc = circle_arc(stroke.stroke);
    const double degrees = std::abs(arc.sweep) * 180 / std::numbers::pi;
    if (arc.radius < 0.45 || arc.radius > 1.6 || degrees < 15 || degrees > 185) return std::nullopt;
    return DoorSwing{arc.centre, stroke.stroke.a, stroke.stroke.b};
}

GapEvidence gap_evidence(const GapPlace& gap, const std::vector<SheetStroke>& strokes, const StrokeIndex& index) {
    const Point normal = turned_left(gap.dir);
    const double half = gap.thickness / 2;
    const auto local = [&](Point p) { return Local{dot(gap.dir, p), dot(normal, p) - gap.v}; };
    const auto world = [&](double u, double v) { return gap.dir * u + normal * (gap.v + v); };
    PlanBox box;
    for (const double u : {gap.u0, gap.u1})
        for (const double v : {-half, half}) box.add(world(u, v));

    GapEvidence evidence;
    evidence.u0 = gap.u1;
    evidence.u1 = gap.u0;
    evidence.jamb0 = gap.u0;
    evidence.jamb1 = gap.u1;
    const double middle = (gap.u0 + gap.u1) / 2;
    const auto cover = [&](double u) {
        evidence.u0 = std::min(evidence.u0, std::clamp(u, gap.u0, gap.u1));
        evidence.u1 = std::max(evidence.u1, std::clamp(u, gap.u0, gap.u1));
    };
    bool closed_low = false, closed_high = false, own_end = false;
    for (const std::uint32_t k : index.near(box.grown(reach))) {
        const SheetStroke& s = strokes[k];
        const Local a = local(s.stroke.a), b = local(s.stroke.b);
        const double length = distance(s.stroke.a, s.stroke.b);
        if (s.stroke.bulge == 0 && std::abs(b.u - a.u) < 0.2 * length && length > 0.6 * gap.thickness &&
            std::max(a.v, b.v) > 0.2 * half && std::min(a.v, b.v) < -0.2 * half) {
            // At a corner the face of the other wall closes this one, up to a thickness further on.
            const double slack = gap.thickness * 1.1 + 0.03;
            const bool low = a.u > gap.u0 - 0.03 && a.u < gap.u0 + slack && a.u < middle;
            const bool high = a.u < gap.u1 + 0.03 && a.u > gap.u1 - slack && a.u > middle;
            if (low) closed_low = true, evidence.jamb0 = std::max(evidence.jamb0, a.u);
            if (high) closed_high = true, evidence.jamb1 = std::min(evidence.jamb1, a.u);
            own_end = own_end || ((low || high) && length < 1.3 * gap.thickness + 0.03);
        }
        if (s.role == Role::Unknown && s.stroke.bulge == 0 && std::abs(b.u - a.u) > 0.9 * length &&
            length > 0.5 * (gap.u1 - gap.u0) && std::abs(a.v) < half + 0.02 && std::abs(b.v) < half + 0.02)
            ++evidence.other_lines;
        const bool tells = s.role == Role::Door || s.role == Role::Window || s.role == Role::Opening;
        if (!tells) continue;
        if (const auto swing = door_swing(s)) {
            const Local hinge = local(swing->hinge);
            const auto at_gap = [&](Local p) {
                return std::abs(p.v) < half + reach && p.u > gap.u0 - reach && p.u < gap.u1 + reach;
            };
            if (!at_gap(hinge) || !(at_gap(a) || at_gap(b))) continue;
            ++evidence.door_arcs;
            cover(hinge.u);
            cover(std::abs(a.v) < std::abs(b.v) ? a.u : b.u);
        } else {
            // Of other strokes, what runs along the wall within its width. Lines across are jambs and mullions.
            if (std::abs(b.u - a.u) < 0.5 * length || length < 0.1) continue;
            const double inside_u = std::min(std::max(a.u, b.u), gap.u1) - std::max(std::min(a.u, b.u), gap.u0);
            const double inside_v =
                std::min(std::max(a.v, b.v), half + 0.03) - std::max(std::min(a.v, b.v), -half - 0.03);
            if (inside_v < 0 || inside_u < -0.02 || inside_u < 0.4 * std::abs(b.u - a.u) ||
                inside_v < 0.5 * std::abs(b.v - a.v))
                continue;
            (s.role == Role::Door     ? evidence.door_lines
             : s.role == Role::Window ? evidence.window_lines
                                      : evidence.opening_lines)++;
            cover(a.u);
            cover(b.u);
        }
        evidence.strokes.push_back(k);
        if (s.rule && s.rule->sill) evidence.sill = s.rule->sill;
        if (s.rule && s.rule->head) evidence.head = s.rule->head;
    }
    // Faces of other walls at both ends are a room or corridor between, not an opening.
    evidence.jambs = closed_low && closed_high && own_end;
    return evidence;
}

GapKind kind_of(const GapEvidence& evidence) {
    if (evidence.door_arcs > 0) return {OpeningKind::Door, {}};
    if (evidence.window_lines > 0) return {OpeningKind::Window, {}};
    if (evidence.door_lines > 0) return {OpeningKind::Door, {}};
    if (evidence.opening_lines > 0) return {OpeningKind::Window, OpeningKind::Door};
    if (evidence.other_lines >= 2) return {OpeningKind::Window, OpeningKind::Opening};
    return {OpeningKind::Opening, {}};
}

}  // namespace enfilade::plans
