#include "accel/lights/lamp_walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade::accel::detail {

bool LampWalk::follow(CellId cell, const std::array<float, 3>& lamp, double radius) {
    lamp_ = lamp;
    reach_ = LampCones(options_.margin + radius);
    light_.clear();
    forget();
    steps_.push_back({cell, 0, none<PortalId>, {}, {}, UINT32_MAX, false});
    last_in_cell_[index(cell)] = 0;
    for (std::uint32_t k = 0; k < steps_.size(); ++k) {
        if (steps_.size() > options_.most_steps) return false;
        expand(k);
    }
    return steps_.size() <= options_.most_steps;
}

void LampWalk::forget() {
    for (const LampStep& step : steps_) last_in_cell_[index(step.cell)] = UINT32_MAX;
    steps_.clear();
}

/// In the plane of many portals, rounding may lead this way or that at each of them: ways without number, of which only
/// those are followed that find more than others before them in the same cell.
bool LampWalk::is_known(CellId cell) const {
    for (std::uint32_t k = last_in_cell_[index(cell)]; k != UINT32_MAX; k = steps_[k].before_in_cell)
        if (reach_.is_last_within(steps_[k].reach)) return true;
    return false;
}

ConeVector LampWalk::from_lamp(std::uint32_t section, float z) const {
    return {double{view_.section_x[section]} - lamp_[0], double{view_.section_y[section]} - lamp_[1],
            double{z} - lamp_[2]};
}

bool LampWalk::is_open(const LampStep& step, PortalId portal, Target target) const {
    return target.is_portal() && portal != step.portal && (options_.through_glass || !target.is_glass());
}

/// A line enters no convex cell twice. Where rounding to the grid has bent the cell by a unit and it does, what it sees
/// beyond is also seen by the beam that went on the first time.
bool LampWalk::is_on_way(std::uint32_t number, CellId cell) const {
    for (;; number = steps_[number].parent) {
        if (steps_[number].cell == cell) return true;
        if (steps_[number].parent == number) return false;
    }
}

void LampWalk::expand(std::uint32_t number) {
    const Cell& cell = view_.cells[index(steps_[number].cell)];
    for (std::uint32_t i = 0; i < cell.section_count; ++i)
        expand_side(number, cell.first_section + i, cell.first_section + (i + 1 == cell.section_count ? 0 : i + 1));
    expand_level(number, false);
    expand_level(number, true);
}

void LampWalk::expand_side(std::uint32_t number, std::uint32_t section, std::uint32_t next) {
    float bottom = view_.cells[index(steps_[number].cell)].z_floor;
    bool is_known = false;
    ConeVector outward;
    double before = 0;
    for (std::uint32_t f = view_.section_tails[section].first_face; f < view_.section_tails[section + 1].first_face;
         ++f) {
        const SideFace& face = view_.side_faces[f];
        const float low = std::exchange(bottom, face.z_top);
        if (!is_open(steps_[number], view_.side_face_portals[f], face.target)) continue;
        if (!is_known) {
            const ConeVector right = from_lamp(section, 0), left = from_lamp(next, 0);
            const double dx = left.x - right.x, dy = left.y - right.y, size = std::hypot(dx, dy);
            outward = {dy / size, -dx / size, 0};
            before = outward.x * right.x + outward.y * right.y;
            is_known = true;
        }
        if (before < -reach_.slack()) return;
        portal_ = {from_lamp(section, low), from_lamp(next, low), from_lamp(next, face.z_top),
                   from_lamp(section, face.z_top)};
        enter(number, view_.side_face_portals[f], face.target, outward, before);
    }
}

void LampWalk::expand_level(std::uint32_t number, bool is_up) {
    const CellId id = steps_[number].cell;
    const Cell& cell = view_.cells[index(id)];
    const Target target = is_up ? cell.ceiling : cell.floor;
    const CellPortals& portals = view_.cell_portals[index(id)];
    const PortalId portal = is_up ? portals.ceiling : portals.floor;
    if (!is_open(steps_[number], portal, target)) return;
    const float z = is_up ? cell.z_ceiling : cell.z_floor;
    const double before = is_up ? double{z} - lamp_[2] : lamp_[2] - double{z};
    if (before < -reach_.slack()) return;
    portal_.clear();
    for (std::uint32_t i = 0; i < cell.section_count; ++i)
        portal_.push_back(from_lamp(cell.first_section + (is_up ? i : cell.section_count - 1 - i), z));
    enter(number, portal, target, {0, 0, is_up ? 1.0 : -1.0}, before);
}

void LampWalk::enter(std::uint32_t number, PortalId portal, Target target, const ConeVector& outward, double before) {
    const std::optional<ConePlanes> reach = reach_.behind(steps_[number].reach, portal_, outward);
    if (!reach || is_on_way(number, target.neighbour())) return;
    const CellId cell = target.neighbour();
    LampStep step = {cell, number, portal, *reach, {}, last_in_cell_[index(cell)], steps_[number].is_dark};
    step.light = light_behind(steps_[number], outward, before, step.is_dark);
    if (step.is_dark && is_known(cell)) return;
    last_in_cell_[index(cell)] = static_cast<std::uint32_t>(steps_.size());
    steps_.push_back(step);
}

ConePlanes LampWalk::light_behind(const LampStep& step, const ConeVector& outward, double before, bool& is_dark) {
    if (step.is_dark) return step.light;
    if (before >= -light_.slack()) {
        const std::optional<ConePlanes> light = light_.behind(step.light, portal_, outward);
        if (light && !light_.is_last_edge_on()) return *light;
    }
    is_dark = true;
    return light_.nothing_beside(outward);
}

void LampWalk::light_in_cell(const LampStep& step, std::vector<ConeVector>& planes) const {
    const Cell& cell = view_.cells[index(step.cell)];
    const double low = double{cell.z_floor} - lamp_[2], high = double{cell.z_ceiling} - lamp_[2];
    planes.clear();
    for (const ConeVector& plane : light_.planes(step.light)) {
        double least = 0;
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            const ConeVector corner = from_lamp(s, 0);
            const double depth = plane.x * corner.x + plane.y * corner.y;
            least = s == cell.first_section ? depth : std::min(least, depth);
        }
        least += std::min(plane.z * low, plane.z * high);
        if (least < -light_.slack()) planes.push_back(plane);
    }
}

}  // namespace enfilade::accel::detail
