#include "modeler/editing/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

double distance2(GridPoint p, double x, double y) { return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y); }

std::int64_t turn(GridPoint a, GridPoint b, GridPoint c) {
    return (std::int64_t(b.x) - a.x) * (std::int64_t(c.y) - b.y) -
           (std::int64_t(b.y) - a.y) * (std::int64_t(c.x) - b.x);
}

/// Without corners that repeat the one before.
std::vector<GridPoint> without_repeats(std::vector<GridPoint> ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
}

bool lies_on_side(GridPoint p, const plans::Segment& side) {
    const double dx = double(side.b.x) - side.a.x, dy = double(side.b.y) - side.a.y;
    const double along = ((double(p.x) - side.a.x) * dx + (double(p.y) - side.a.y) * dy) / (dx * dx + dy * dy);
    return along > 0 && along < 1 &&
           distance2(p, side.a.x + along * dx, side.a.y + along * dy) <= least_thickness * least_thickness;
}

GridPoint snapped(GridPoint p, std::span<const plans::Segment> sides) {
    GridPoint best = p;
    double least = least_thickness * least_thickness;
    const auto take = [&](GridPoint at, double distance) {
        if (distance > least || (distance == least && !(at < best))) return;
        least = distance;
        best = at;
    };
    for (const plans::Segment& side : sides)
        for (const GridPoint end : {side.a, side.b}) take(end, distance2(p, end.x, end.y));
    if (best != p || least == 0) return best;
    for (const plans::Segment& side : sides) {
        if (side.a == side.b || !lies_on_side(p, side)) continue;
        const double dx = double(side.b.x) - side.a.x, dy = double(side.b.y) - side.a.y;
        const double along = ((double(p.x) - side.a.x) * dx + (double(p.y) - side.a.y) * dy) / (dx * dx + dy * dy);
        const double x = side.a.x + along * dx, y = side.a.y + along * dy;
        take({std::int32_t(std::floor(x + 0.5)), std::int32_t(std::floor(y + 0.5))}, distance2(p, x, y));
    }
    return best;
}

}  // namespace

std::vector<GridPoint> rectangle_footprint(const plans::GridFrame& frame, double centre_x, double centre_y,
                                           double width, double depth, double angle) {
    const double x = (centre_x - frame.origin_x) / frame.unit, y = (centre_y - frame.origin_y) / frame.unit;
    const double c = std::cos(angle), s = std::sin(angle);
    const std::array<std::array<double, 2>, 4> signs = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    std::array<std::array<double, 2>, 4> corners;
    std::vector<GridPoint> ring(4);
    const auto place = [&](double grow) {
        for (std::size_t k = 0; k < 4; ++k) {
            const double u = signs[k][0] * (width / frame.unit / 2 + grow);
            const double v = signs[k][1] * (depth / frame.unit / 2 + grow);
            const double px = x + u * c - v * s, py = y + u * s + v * c;
            if (grow == 0) corners[k] = {px, py};
            ring[k] = {std::int32_t(std::floor(px + 0.5)), std::int32_t(std::floor(py + 0.5))};
        }
    };
    const auto holds_all = [&] {
        for (std::size_t k = 0; k < 4; ++k)
            for (const auto& [px, py] : corners) {
                const GridPoint a = ring[k], b = ring[(k + 1) % 4];
                // A double's last bits may not make the rectangle grow.
                const double side = (double(b.x) - a.x) * (py - a.y) - (double(b.y) - a.y) * (px - a.x);
                if (side < -1e-6 * std::hypot(double(b.x) - a.x, double(b.y) - a.y)) return false;
            }
        return true;
    };
    for (double grow = 0; grow <= 2; grow += 0.125) {
        place(grow);
        if (holds_all()) break;
    }
    return ring;
}

bool is_convex_ring(std::span<const GridPoint> ring) {
    if (ring.size() < 3) return false;
    std::int64_t doubled_area = 0;
    int x_changes = 0;  // once around, x rises and falls once
    int before = 0;
    int first = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[(k + 1) % ring.size()], c = ring[(k + 2) % ring.size()];
        if (a == b || turn(a, b, c) < 0) return false;
        if (turn(a, b, c) == 0 && (std::int64_t(b.x) - a.x) * (std::int64_t(c.x) - b.x) +
                                          (std::int64_t(b.y) - a.y) * (std::int64_t(c.y) - b.y) <
                                      0)
            return false;
        doubled_area += std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
        const int direction = b.x > a.x ? 1 : b.x < a.x ? -1 : 0;
        if (direction == 0) continue;
        if (before == 0) first = direction;
        else if (direction != before) ++x_changes;
        before = direction;
    }
    if (before != first) ++x_changes;
    return doubled_area > 0 && x_changes == 2;
}

double thickness(std::span<const GridPoint> ring) {
    std::int64_t doubled_area = 0;
    double perimeter = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint a = ring[k], b = ring[(k + 1) % ring.size()];
        doubled_area += std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
        perimeter += std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    }
    return perimeter > 0 ? double(doubled_area) / perimeter : 0;
}

std::vector<GridPoint> snapped(std::span<const GridPoint> ring, std::span<const plans::Segment> sides) {
    std::vector<GridPoint> result(ring.begin(), ring.end());
    if (thickness(ring) < 4 * least_thickness) return result;
    for (GridPoint& p : result) p = snapped(p, sides);
    result = without_repeats(std::move(result));
    return result.size() < 3 ? std::vector<GridPoint>(ring.begin(), ring.end()) : result;
}

}  // namespace enfilade::modeler
