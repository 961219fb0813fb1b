#include "tools/report/plan_view.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "modeler/outline.h"
#include "plans/read.h"

namespace enfilade::tools {

using modeler::Label;
using modeler::SpacePart;

PlanView::PlanView(const modeler::Building& building)
    : building_(building), parts_(building.storeys.size()), wells_(building.storeys.size()) {
    origin_ = {std::floor(building.frame.world_x(building.site_min[0])),
               std::floor(building.frame.world_y(building.site_min[1]))};
    try {
        plan_ = plans::read_json(building.plan_json, "");
    } catch (const InputError&) {
        // Drawn without what only the plan knows: leaves of doors, furniture.
    }
    for (const modeler::StoreyInfo& storey : building.storeys) {
        const auto metre = std::int32_t(1.1 / building.frame.unit);
        cut_levels_.push_back(storey.z_floor + std::min(metre, (storey.z_ceiling - storey.z_floor) / 2));
    }
    sort_parts();
    sort_faces();
}

void PlanView::sort_faces() {
    first_side_.assign(building_.edges.size() + 1, 0);
    const auto is_side = [&](std::uint32_t f) { return building_.faces[f].direction == modeler::Direction::Side; };
    for (std::uint32_t f = 0; f < building_.faces.size(); ++f)
        if (is_side(f)) ++first_side_[building_.faces[f].edge + 1];
    for (std::size_t e = 1; e < first_side_.size(); ++e) first_side_[e] += first_side_[e - 1];
    side_faces_.resize(first_side_.back());
    std::vector<std::uint32_t> next(first_side_.begin(), first_side_.end() - 1);
    for (std::uint32_t f = 0; f < building_.faces.size(); ++f)
        if (is_side(f)) side_faces_[next[building_.faces[f].edge]++] = f;
}

void PlanView::sort_parts() {
    for (SpacePart& part : modeler::space_parts(building_)) {
        const modeler::Space& space = building_.spaces[part.space];
        if (space.storey >= building_.storeys.size()) continue;
        if (space.label == Label::Slab || space.label == Label::Exterior || space.label == Label::Ground) continue;
        const modeler::StoreyInfo& storey = building_.storeys[space.storey];
        if (part.z_low < storey.z_ceiling && part.z_high > storey.z_floor) {
            for (const Mm at : ring(part.outer)) box_.add(at);
            parts_[space.storey].push_back(std::move(part));
        } else if (space.storey + 1 < building_.storeys.size()) {
            wells_[space.storey + 1].push_back(std::move(part));
        }
    }
}

const plans::Storey* PlanView::plan_storey(std::uint32_t storey) const {
    if (!plan_) return nullptr;
    for (const plans::Storey& candidate : plan_->storeys)
        if (candidate.id == building_.storeys[storey].id) return &candidate;
    return nullptr;
}

Mm PlanView::mm(double x, double y) const {
    return {std::llround(1000 * (x - origin_[0])), std::llround(1000 * (y - origin_[1]))};
}

Mm PlanView::mm(plans::GridPoint p) const { return mm(building_.frame.world_x(p.x), building_.frame.world_y(p.y)); }

Mm PlanView::middle(const modeler::Piece& piece) const {
    const auto corner = [&](std::uint32_t k) {
        return building_.points[building_.corners[piece.first_corner + k].vertex];
    };
    const plans::GridPoint a = corner(0);
    double area = 0, x = 0, y = 0;
    for (std::uint32_t k = 1; k + 1 < piece.corner_count; ++k) {
        const plans::GridPoint b = corner(k), c = corner(k + 1);
        const double part = double(orientation(a, b, c));
        area += part;
        x += part * (double(b.x - a.x) + double(c.x - a.x)) / 3,
            y += part * (double(b.y - a.y) + double(c.y - a.y)) / 3;
    }
    const plans::GridFrame& frame = building_.frame;
    if (area == 0) return mm(a);
    return mm(frame.origin_x + frame.unit * (a.x + x / area), frame.origin_y + frame.unit * (a.y + y / area));
}

std::vector<Mm> PlanView::ring(const modeler::HalfEdgeRing& ring) const {
    std::vector<Mm> points;
    for (const std::uint32_t p : modeler::drawn_corners(building_, ring)) points.push_back(mm(building_.points[p]));
    return points;
}

std::vector<std::vector<Mm>> PlanView::rings(const SpacePart& part) const {
    std::vector<std::vector<Mm>> all = {ring(part.outer)};
    for (const modeler::HalfEdgeRing& hole : part.holes) all.push_back(ring(hole));
    return all;
}

void PlanView::add(const SpacePart& part, SvgPath& path) const {
    for (const std::vector<Mm>& points : rings(part)) path.ring(points);
}

}  // namespace enfilade::tools
