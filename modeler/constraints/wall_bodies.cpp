#include "modeler/constraints/wall_bodies.h"

#include <cmath>

#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

constexpr double most_grown = 0.01;  ///< metres
constexpr double flat = 0.00003;     ///< metres, as the outlines have it: arcs that bulge less are straight

std::vector<plans::WallAxis> axes_of(const plans::Storey& storey) {
    std::vector<plans::WallAxis> axes;
    for (const plans::Wall& wall : storey.walls) axes.push_back(axis_of(wall));
    return axes;
}

std::vector<plans::PlanBox> boxes_of(const plans::Storey& storey, const std::vector<plans::WallAxis>& axes) {
    std::vector<plans::PlanBox> boxes;
    for (std::size_t w = 0; w < axes.size(); ++w) {
        plans::PlanBox box;
        for (int k = 0; k <= 16; ++k) box.add(axes[w].at(k / 16.0));
        const double bulge = axes[w].straight() ? 0 : 0.05 * axes[w].length();
        boxes.push_back(box.grown(storey.walls[w].thickness / 2 + bulge + most_grown));
    }
    for (const plans::Column& column : storey.columns) {
        plans::PlanBox box;
        for (const plans::Point p : column.polygon) box.add(p);
        boxes.push_back(box);
    }
    return boxes;
}

/// Within the wall's strip and not beyond its ends, where other walls decide.
bool holds(const plans::WallAxis& axis, double half, plans::Point point) {
    constexpr double beyond = 1e-6;
    const double t = axis.nearest(point);
    const plans::Point from = point - axis.at(t);
    const double lateral = plans::dot(from, axis.normal(t));
    return std::abs(lateral) <= half && plans::norm(from - axis.normal(t) * lateral) <= beyond;
}

}  // namespace

plans::WallAxis axis_of(const plans::Wall& wall) {
    return plans::WallAxis(wall.start, wall.end, wall.arc_extent, flat);
}

WallBodies::WallBodies(const plans::Storey& storey)
    : storey_(storey), axes_(axes_of(storey)), index_(boxes_of(storey, axes_)) {}

std::optional<std::uint32_t> WallBodies::at(plans::Point point, const BodySearch& search) const {
    std::optional<std::uint32_t> found;
    index_.near(point, [&](std::uint32_t i) {
        if (found || i == search.except) return;
        if (i >= axes_.size()) {
            if (holds(storey_.columns[i - axes_.size()].polygon, point)) found = i;
        } else if (holds(axes_[i], storey_.walls[i].thickness / 2 + search.grown, point)) {
            found = i;
        }
    });
    return found;
}

OpeningOffset offset_from(const plans::WallAxis& axis, const plans::Opening& opening, plans::Point point) {
    const double t = axis.nearest(point);
    return {t * axis.length() - opening.offset, plans::dot(point - axis.at(t), axis.normal(t))};
}

bool holds(const std::vector<plans::Point>& polygon, plans::Point p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const plans::Point a = polygon[k], b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
}

}  // namespace enfilade::modeler
