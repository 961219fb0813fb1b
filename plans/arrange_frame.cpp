#include "plans/arrange_frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "base/error.h"
#include "plans/box_index.h"
#include "plans/outline.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

constexpr double kReach = 1 << 24;  ///< units that the grid may extend from its origin: float32 holds them exactly
constexpr double kMargin = 16;      ///< units at least between the building and the site box
constexpr double kMitre = 2.5;      ///< thicknesses that corners may reach beyond the end of an axis

void require_finite(double value, const char* what, const std::string& id) {
    if (std::isfinite(value)) return;
    throw InputError("P305", "", "The " + std::string(what) + " of \"" + id + "\" is not a finite number.");
}

/// All that stands on a storey; room polygons count where there is nothing else.
PlanBox extent(const Storey& storey) {
    PlanBox box;
    const auto add = [&](Point p, const std::string& id) {
        require_finite(p.x, "position", id);
        require_finite(p.y, "position", id);
        box.add(p);
    };
    double depth = 0;
    for (const Opening& opening : storey.openings) {
        for (const double d : {opening.offset, opening.width, opening.depth_left, opening.depth_right})
            require_finite(d, "size", opening.id);
        depth = std::max({depth, opening.depth_left, opening.depth_right});
    }
    for (const Wall& wall : storey.walls) {
        require_finite(wall.thickness, "thickness", wall.id);
        require_finite(wall.arc_extent, "arc", wall.id);
        PlanBox axis;
        add(wall.start, wall.id);
        add(wall.end, wall.id);
        axis.add(wall.start);
        axis.add(wall.end);
        if (wall.arc_extent != 0 && !(wall.start == wall.end)) {
            const WallAxis arc(wall.start, wall.end, wall.arc_extent, 0);
            constexpr int kSamples = 32;
            for (int k = 1; k < kSamples; ++k) axis.add(arc.at(double(k) / kSamples));
            axis = axis.grown(arc.radius() * 0.02);
        }
        axis = axis.grown(std::max(kMitre * wall.thickness, wall.thickness + depth));
        add(axis.min, wall.id);
        add(axis.max, wall.id);
    }
    for (const Column& column : storey.columns)
        for (const Point p : column.polygon) add(p, column.id);
    for (const Stair& stair : storey.stairs)
        for (const Point p : stair.polygon) add(p, stair.id);
    for (const Shaft& shaft : storey.shafts)
        for (const Point p : shaft.polygon) add(p, shaft.id);
    for (const Room& room : storey.rooms)
        for (const Point p : room.polygon) {
            require_finite(p.x, "position", room.id);
            require_finite(p.y, "position", room.id);
        }
    if (box.empty())
        for (const Room& room : storey.rooms)
            for (const Point p : room.polygon) box.add(p);
    return box;
}

struct Heights {
    double bottom = HUGE_VAL;
    double top = -HUGE_VAL;
};

Heights heights(const Plan& plan, const std::vector<std::uint32_t>& storeys) {
    Heights result;
    for (const std::uint32_t s : storeys) {
        const Storey& storey = plan.storeys[s];
        require_finite(storey.elevation, "elevation", storey.id);
        require_finite(storey.height, "height", storey.id);
        result.bottom = std::min(result.bottom, storey.elevation - storey.slab_thickness);
        result.top = std::max(result.top, storey.elevation + storey.height + storey.slab_thickness);
        for (const Wall& wall : storey.walls)
            result.top =
                std::max({result.top, storey.elevation + wall.height_at_start, storey.elevation + wall.height_at_end});
    }
    return result;
}

/// The multiple of the unit nearest to the middle; of a metre where the unit is finer.
double centre(double low, double high, double unit) {
    const double step = std::max(unit, 1.0);
    return std::round((low + (high - low) / 2) / step) * step;
}

std::string millimetres(double metres) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g mm", metres * 1000);
    return buffer;
}

}  // namespace

Site choose_site(const Plan& plan, const std::vector<std::uint32_t>& storeys, const ArrangeOptions& options,
                 std::vector<Finding>& findings) {
    PlanBox box;
    for (const std::uint32_t s : storeys) {
        const PlanBox storey_box = extent(plan.storeys[s]);
        if (storey_box.empty()) continue;
        box.add(storey_box.min);
        box.add(storey_box.max);
    }
    if (box.empty()) box = {{0, 0}, {0, 0}};
    Heights height = heights(plan, storeys);
    if (!(height.bottom <= height.top)) height = {0, 0};
    const double margin = plan.site_margin.value_or(std::max(5.0, height.top - height.bottom));
    require_finite(margin, "site margin", plan.name);
    if (!(options.snap_mm > 0) || !std::isfinite(options.snap_mm))
        throw InputError("P306", "", "The grid unit must be a positive length in millimetres.");

    // The factor forgives the rounding of decimal options.
    const double wanted = std::exp2(std::floor(std::log2(options.snap_mm / 1000 * (1 + 1e-12))));
    for (double unit = wanted;; unit *= 2) {
        Site site;
        site.frame.unit = unit;
        site.frame.origin_x = centre(box.min.x, box.max.x, unit);
        site.frame.origin_y = centre(box.min.y, box.max.y, unit);
        site.frame.origin_z = centre(height.bottom, height.top, unit);
        const PlanBox outer = box.grown(std::max(margin, kMargin * unit));
        const double reach = std::max({outer.max.x - site.frame.origin_x, site.frame.origin_x - outer.min.x,
                                       outer.max.y - site.frame.origin_y, site.frame.origin_y - outer.min.y,
                                       height.top - site.frame.origin_z, site.frame.origin_z - height.bottom}) /
                             unit;
        if (reach + 1 <= kReach) {
            const auto down = [&](double d, double from) { return std::int32_t(std::floor((d - from) / unit)); };
            const auto up = [&](double d, double from) { return std::int32_t(std::ceil((d - from) / unit)); };
            site.min = {down(outer.min.x, site.frame.origin_x), down(outer.min.y, site.frame.origin_y)};
            site.max = {up(outer.max.x, site.frame.origin_x), up(outer.max.y, site.frame.origin_y)};
            if (unit != wanted) {
                Finding finding;
                finding.code = "P301";
                finding.sentence = "The site is too large for a grid of " + millimetres(wanted) +
                                   ": all positions are rounded to " + millimetres(unit) + " instead.";
                finding.hint = "Check the units of the plan for elements far away, or build its parts alone.";
                finding.moved_mm = unit * 500;
                findings.push_back(std::move(finding));
            }
            return site;
        }
        if (options.snap_fixed)
            throw InputError("P304", "",
                             "The site does not fit on a grid of " + millimetres(wanted) +
                                 ": it spans more than 33554432 units. Choose a coarser grid or fewer storeys.");
        if (unit >= 1) throw InputError("P304", "", "The site spans more than 33554 km: check the units of the plan.");
    }
}

}  // namespace enfilade::plans
