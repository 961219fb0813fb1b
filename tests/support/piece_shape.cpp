#include "tests/support/piece_shape.h"

#include <algorithm>
#include <cmath>

namespace enfilade::testing {
namespace {

using modeler::PolygonSide;
using modeler::RingCorner;
using plans::GridPoint;

double length_of(GridPoint a, GridPoint b) { return std::hypot(double(b.x) - a.x, double(b.y) - a.y); }

/// Counter-clockwise, strictly convex (Andrew's monotone chain).
std::vector<GridPoint> convex_hull(std::vector<GridPoint> points) {
    std::sort(points.begin(), points.end());
    std::vector<GridPoint> hull;
    const auto add = [&](GridPoint p, std::size_t keep) {
        while (hull.size() > keep && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
    };
    for (const GridPoint p : points) add(p, 1);
    const std::size_t upper = hull.size();
    for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, upper);
    hull.pop_back();
    return hull;
}

double off_segment(GridPoint a, GridPoint b, GridPoint p) {
    return std::abs(double(orientation(a, b, p))) / std::max(length_of(a, b), 1e-300);
}

}  // namespace

double stray(std::span<const RingCorner> ring) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t k) -> const RingCorner& { return ring[k % n]; };
    const auto is_straight = [&](std::size_t k) {
        return modeler::goes_straight(at(k + n - 1).point, at(k).point, at(k + 1).point, at(k + n - 1).line,
                                      at(k).line);
    };
    std::size_t start = 0;
    while (start < n && is_straight(start)) ++start;
    double worst = 0;
    for (std::size_t run = start; run < start + n;) {
        std::size_t end = run + 1;
        while (end < start + n && is_straight(end)) ++end;
        for (std::size_t k = run + 1; k < end && at(run).point != at(end).point; ++k)
            worst = std::max(worst, off_segment(at(run).point, at(end).point, at(k).point));
        run = end;
    }
    return worst;
}

PieceShape piece_shape(std::span<const GridPoint> points, std::span<const PolygonSide> ring) {
    std::vector<GridPoint> corners;
    for (const PolygonSide& side : ring) corners.push_back(points[side.from]);
    const std::vector<GridPoint> hull = convex_hull(corners);
    PieceShape shape;
    shape.width = HUGE_VAL;
    std::size_t narrowest = 0;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const GridPoint a = hull[k], b = hull[(k + 1) % hull.size()];
        double reach = 0;
        for (const GridPoint p : hull) reach = std::max(reach, off_segment(a, b, p));
        if (reach < shape.width) shape.width = reach, narrowest = k;
    }
    for (const GridPoint p : corners) {
        double nearest = HUGE_VAL;
        for (std::size_t k = 0; k < hull.size() && nearest > 0; ++k)
            nearest = std::min(nearest, off_segment(hull[k], hull[(k + 1) % hull.size()], p));
        shape.dent = std::max(shape.dent, nearest);
    }
    const GridPoint a = hull[narrowest], b = hull[(narrowest + 1) % hull.size()];
    double walls[2] = {0, 0}, all[2] = {0, 0};
    for (const PolygonSide& side : ring) {
        const GridPoint p = points[side.from], q = points[side.to];
        const std::int64_t along = (std::int64_t(b.x) - a.x) * (std::int64_t(q.x) - p.x) +
                                   (std::int64_t(b.y) - a.y) * (std::int64_t(q.y) - p.y);
        all[along > 0] += length_of(p, q);
        if (side.tag != modeler::cut_tag) walls[along > 0] += length_of(p, q);
    }
    shape.between_walls = 2 * walls[0] >= all[0] && 2 * walls[1] >= all[1];
    return shape;
}

}  // namespace enfilade::testing
