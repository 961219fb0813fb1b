#include "accel/beam_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "accel/locate.h"

namespace enfilade::accel {
namespace {

std::int64_t units(double metres, double unit) { return std::llround(metres / unit); }
std::int64_t units_below(double metres, double unit) { return static_cast<std::int64_t>(std::floor(metres / unit)); }
std::int64_t units_above(double metres, double unit) { return static_cast<std::int64_t>(std::ceil(metres / unit)); }

struct RealPoint {
    double x, y;
};

/// The part of a convex ring where sign * (coordinate - bound) >= 0 (Sutherland and Hodgman 1974).
template <class Coordinate>
std::vector<RealPoint> clipped(const std::vector<RealPoint>& ring, double sign, double bound,
                               const Coordinate& coordinate) {
    std::vector<RealPoint> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const RealPoint& a = ring[i];
        const RealPoint& b = ring[(i + 1) % ring.size()];
        const double da = sign * (coordinate(a) - bound), db = sign * (coordinate(b) - bound);
        if (da >= 0) kept.push_back(a);
        if ((da < 0) != (db < 0)) {
            const double t = da / (da - db);
            kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return kept;
}

}  // namespace

std::vector<PlanPoint> convex_hull(std::vector<PlanPoint> points) {
    const auto before = [](const PlanPoint& a, const PlanPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    std::sort(points.begin(), points.end(), before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    // Andrew 1979: the lower chain, then the upper one.
    std::vector<PlanPoint> hull;
    const auto add = [&](const PlanPoint& p, std::size_t keep) {
        while (hull.size() > keep && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
    };
    for (const PlanPoint& p : points) add(p, 1);
    const std::size_t lower = hull.size();
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.pop_back();
    return hull;
}

bool BeamSource::holds(const PlanPoint& p) const {
    if (corners.size() == 1) return corners[0] == p;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (turn(corners[i], corners[(i + 1) % corners.size()], p) < 0) return false;
    if (corners.size() > 2) return true;
    const auto [low_x, high_x] = std::minmax(corners[0].x, corners[1].x);
    const auto [low_y, high_y] = std::minmax(corners[0].y, corners[1].y);
    return p.x >= low_x && p.x <= high_x && p.y >= low_y && p.y <= high_y;
}

BeamSource source_at(const SceneView& view, CellId cell, const std::array<double, 3>& point) {
    const double unit = view.unit;
    const std::int64_t x0 = units_below(point[0], unit), x1 = units_above(point[0], unit);
    const std::int64_t y0 = units_below(point[1], unit), y1 = units_above(point[1], unit);
    return {cell, convex_hull({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}), units_below(point[2], unit),
            units_above(point[2], unit)};
}

std::optional<BeamSource> source_at(const SceneView& view, const std::array<double, 3>& point) {
    const std::optional<CellId> cell = locate(view, point);
    if (!cell) return std::nullopt;
    return source_at(view, *cell, point);
}

BeamSource source_of_cell(const SceneView& view, CellId id) {
    const Cell& cell = view.cells[index(id)];
    std::vector<PlanPoint> ring;
    for (std::size_t s = cell.first_section; s < std::size_t{cell.first_section} + cell.section_count; ++s)
        ring.push_back({units(double{view.section_x[s]}, view.unit), units(double{view.section_y[s]}, view.unit)});
    return {id, convex_hull(std::move(ring)), units(double{cell.z_floor}, view.unit),
            units(double{cell.z_ceiling}, view.unit)};
}

std::vector<BeamSource> sources_of_space(const SceneView& view, SpaceId space) {
    std::vector<BeamSource> sources;
    for (std::size_t c = 0; c < view.cells.size(); ++c)
        if (view.cells[c].space == space) sources.push_back(source_of_cell(view, static_cast<CellId>(c)));
    return sources;
}

std::vector<BeamSource> sources_of_box(const SceneView& view, const std::array<double, 3>& low,
                                       const std::array<double, 3>& high) {
    std::vector<BeamSource> sources;
    for (std::size_t c = 0; c < view.cells.size(); ++c) {
        const Cell& cell = view.cells[c];
        if (!(double{cell.z_floor} <= high[2]) || !(double{cell.z_ceiling} >= low[2])) continue;
        std::vector<RealPoint> ring;
        for (std::size_t s = cell.first_section; s < std::size_t{cell.first_section} + cell.section_count; ++s)
            ring.push_back({double{view.section_x[s]}, double{view.section_y[s]}});
        const auto x = [](const RealPoint& p) { return p.x; };
        const auto y = [](const RealPoint& p) { return p.y; };
        ring = clipped(ring, 1, low[0], x);
        ring = clipped(ring, -1, high[0], x);
        ring = clipped(ring, 1, low[1], y);
        ring = clipped(ring, -1, high[1], y);
        if (ring.empty()) continue;
        std::vector<PlanPoint> corners;
        for (const RealPoint& p : ring)
            for (const std::int64_t px : {units_below(p.x, view.unit), units_above(p.x, view.unit)})
                for (const std::int64_t py : {units_below(p.y, view.unit), units_above(p.y, view.unit)})
                    corners.push_back({px, py});
        sources.push_back({static_cast<CellId>(c), convex_hull(std::move(corners)),
                           units_below(std::max(low[2], double{cell.z_floor}), view.unit),
                           units_above(std::min(high[2], double{cell.z_ceiling}), view.unit)});
    }
    return sources;
}

}  // namespace enfilade::accel
