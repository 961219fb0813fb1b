// Where a name is written in a room: the place furthest from its walls, near its middle.
// Garcia-Castellanos and Lombardo 2007 ("poles of inaccessibility"), as the search over quarters of squares that
// Agafonkin gave it (2016).

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <utility>

#include "modeler/outline.h"
#include "modeler/space_parts.h"

namespace enfilade::modeler {
namespace {

class Outline {
public:
    explicit Outline(std::vector<OutlineSide> all) : sides(std::move(all)) {
        for (const OutlineSide& s : sides) {
            min_x = std::min(min_x, s.ax), max_x = std::max(max_x, s.ax);
            min_y = std::min(min_y, s.ay), max_y = std::max(max_y, s.ay);
        }
    }

    /// Distance from the border, negative outside.
    [[nodiscard]] double depth(double x, double y) const {
        bool inside = false;
        double nearest = INFINITY;
        for (const OutlineSide& s : sides) {
            if ((s.ay > y) != (s.by > y) && x < (s.bx - s.ax) * (y - s.ay) / (s.by - s.ay) + s.ax) inside = !inside;
            const double dx = s.bx - s.ax, dy = s.by - s.ay;
            const double t = std::clamp(((x - s.ax) * dx + (y - s.ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
            const double ex = x - s.ax - t * dx, ey = y - s.ay - t * dy;
            nearest = std::min(nearest, ex * ex + ey * ey);
        }
        return inside ? std::sqrt(nearest) : -std::sqrt(nearest);
    }

    [[nodiscard]] std::array<double, 2> centroid() const {
        double area = 0, x = 0, y = 0;
        for (const OutlineSide& s : sides) {
            const double cross = (s.ax - min_x) * (s.by - min_y) - (s.bx - min_x) * (s.ay - min_y);
            area += 3 * cross;
            x += (s.ax + s.bx - 2 * min_x) * cross;
            y += (s.ay + s.by - 2 * min_y) * cross;
        }
        return {min_x + x / area, min_y + y / area};
    }

    std::vector<OutlineSide> sides;
    double min_x = INFINITY, min_y = INFINITY, max_x = -INFINITY, max_y = -INFINITY;
};

struct Square {
    double x, y, half, depth;
    [[nodiscard]] double bound() const { return depth + half * std::numbers::sqrt2; }
    friend bool operator<(const Square& a, const Square& b) { return a.bound() < b.bound(); }
};

void add(const Building& building, const HalfEdgeRing& ring, std::vector<OutlineSide>& sides) {
    const std::vector<std::uint32_t> corners = drawn_corners(building, ring);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const plans::GridPoint a = building.points[corners[k]];
        const plans::GridPoint b = building.points[corners[(k + 1) % corners.size()]];
        sides.push_back({double(a.x), double(a.y), double(b.x), double(b.y)});
    }
}

}  // namespace

std::array<double, 2> label_point(std::vector<OutlineSide> sides) {
    const Outline outline(std::move(sides));
    const auto square = [&](double x, double y, double half) { return Square{x, y, half, outline.depth(x, y)}; };
    const double width = outline.max_x - outline.min_x, height = outline.max_y - outline.min_y;
    const auto [cx, cy] = outline.centroid();
    Square best = square(cx, cy, 0);
    // The middle of a box is where eyes look for its name, also where a tail pulls the centroid aside.
    const Square middle = square((outline.min_x + outline.max_x) / 2, (outline.min_y + outline.max_y) / 2, 0);
    if (middle.depth > best.depth) best = middle;

    const double size = std::min(width, height);
    if (!(size > 0)) return {best.x, best.y};
    const double precision = std::max(width, height) / 200;
    std::priority_queue<Square> open;
    for (double x = outline.min_x; x < outline.max_x; x += size)
        for (double y = outline.min_y; y < outline.max_y; y += size)
            open.push(square(x + size / 2, y + size / 2, size / 2));
    while (!open.empty()) {
        const Square at = open.top();
        open.pop();
        if (at.depth > best.depth) best = at;
        // Inside already, and nothing much better: done. Without a place inside the search goes on.
        if (at.bound() - best.depth <= (best.depth > 0 ? precision : 0.25)) break;
        const double half = at.half / 2;
        for (const double dx : {-half, half})
            for (const double dy : {-half, half}) open.push(square(at.x + dx, at.y + dy, half));
    }
    return {best.x, best.y};
}

std::array<double, 2> label_point(const Building& building, const SpacePart& part) {
    std::vector<OutlineSide> sides;
    add(building, part.outer, sides);
    for (const HalfEdgeRing& hole : part.holes) add(building, hole, sides);
    const auto [x, y] = label_point(std::move(sides));
    const plans::GridFrame& frame = building.frame;
    return {frame.origin_x + frame.unit * x, frame.origin_y + frame.unit * y};
}

}  // namespace enfilade::modeler
