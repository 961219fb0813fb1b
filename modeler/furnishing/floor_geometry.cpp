#include "modeler/furnishing/floor_geometry.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enfilade::modeler {

using plans::GridPoint;
using plans::Point;

GridBox box_around(std::span<const GridPoint> points) {
    GridBox box{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    for (const GridPoint p : points) {
        box.x_low = std::min(box.x_low, p.x);
        box.y_low = std::min(box.y_low, p.y);
        box.x_high = std::max(box.x_high, p.x);
        box.y_high = std::max(box.y_high, p.y);
    }
    return box;
}

namespace {

/// Whether all points lie on or right of the line a -> b.
bool beyond(GridPoint a, GridPoint b, std::span<const GridPoint> points) {
    return std::all_of(points.begin(), points.end(), [&](GridPoint p) { return orientation(a, b, p) <= 0; });
}

bool some_edge_parts(const Ring& ring, std::span<const GridPoint> points) {
    for (std::size_t k = 0; k < ring.size(); ++k)
        if (beyond(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0], points)) return true;
    return false;
}

}  // namespace

bool overlap(const Ring& a, const Ring& b) { return !some_edge_parts(a, b) && !some_edge_parts(b, a); }

bool crosses(GridPoint a, GridPoint b, const Ring& ring) {
    const std::array<GridPoint, 2> ends = {a, b};
    return !some_edge_parts(ring, ends) && !beyond(a, b, ring) && !beyond(b, a, ring);
}

double distance2(Point p, const Ring& ring) {
    double least = HUGE_VAL;
    bool inside = ring.size() > 2;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const GridPoint ga = ring[k], gb = ring[k + 1 < ring.size() ? k + 1 : 0];
        const Point a{double(ga.x), double(ga.y)}, d{double(gb.x) - ga.x, double(gb.y) - ga.y};
        const Point from{p.x - a.x, p.y - a.y};
        const double square = plans::dot(d, d);
        inside = inside && plans::cross(d, from) >= 0;
        if (square == 0) continue;
        const double t = std::clamp(plans::dot(from, d) / square, 0.0, 1.0);
        const Point off{from.x - t * d.x, from.y - t * d.y};
        least = std::min(least, plans::dot(off, off));
    }
    return inside ? 0 : least;
}

Floor::Floor(std::vector<FloorSide> sides) : sides_(std::move(sides)) {
    if (sides_.empty()) return;
    std::vector<GridPoint> points;
    for (const FloorSide& side : sides_) points.push_back(side.a);
    box_ = box_around(points);
    const double width = double(box_.x_high) - box_.x_low, depth = double(box_.y_high) - box_.y_low;
    double length = 0;
    for (const FloorSide& side : sides_)
        length += std::abs(double(side.b.x) - side.a.x) + std::abs(double(side.b.y) - side.a.y);
    const double count = double(sides_.size());
    cell_ = std::max<std::int64_t>({1, std::int64_t(std::sqrt(width * depth / count)),
                                    std::int64_t(length / (2 * count)), std::int64_t(std::max(width, depth) / 1024)});
    columns_ = std::int64_t(width) / cell_ + 1;
    rows_ = std::int64_t(depth) / cell_ + 1;
    first_.assign(std::size_t(columns_ * rows_) + 1, 0);
    const auto each = [&](auto visit) {
        for (std::uint32_t k = 0; k < sides_.size(); ++k) {
            const auto [y0, y1] = std::minmax(sides_[k].a.y, sides_[k].b.y);
            const auto [x0, x1] = std::minmax(sides_[k].a.x, sides_[k].b.x);
            for (std::int64_t y = row(y0); y <= row(y1); ++y)
                for (std::int64_t x = column(x0); x <= column(x1); ++x) visit(std::size_t(y * columns_ + x), k);
        }
    };
    each([&](std::size_t bucket, std::uint32_t) { ++first_[bucket + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    entries_.resize(first_.back());
    std::vector<std::uint32_t> slot(first_.begin(), first_.end() - 1);
    each([&](std::size_t bucket, std::uint32_t k) { entries_[slot[bucket]++] = k; });
}

bool Floor::holds(GridPoint p) const {
    if (p.x < box_.x_low || p.x > box_.x_high || p.y < box_.y_low || p.y > box_.y_high || sides_.empty()) return false;
    bool inside = false;
    // A ray to the left: each side counts once, in the row of buckets where it passes p's height.
    std::vector<std::uint32_t> seen;
    bool on_border = false;
    near({box_.x_low, p.y, p.x, p.y}, [&](std::uint32_t k) { seen.push_back(k); });
    std::sort(seen.begin(), seen.end());
    seen.erase(std::unique(seen.begin(), seen.end()), seen.end());
    for (const std::uint32_t k : seen) {
        const auto [a, b] = sides_[k];
        const std::int64_t turn = orientation(a, b, p);
        const auto [x0, x1] = std::minmax(a.x, b.x);
        const auto [y0, y1] = std::minmax(a.y, b.y);
        if (turn == 0 && p.x >= x0 && p.x <= x1 && p.y >= y0 && p.y <= y1) on_border = true;
        if ((a.y > p.y) != (b.y > p.y) && (b.y > a.y ? turn < 0 : turn > 0)) inside = !inside;
    }
    return inside || on_border;
}

bool Floor::holds(const Ring& ring) const {
    const GridBox box = box_around(ring);
    if (box.x_low < box_.x_low || box.y_low < box_.y_low || box.x_high > box_.x_high || box.y_high > box_.y_high)
        return false;
    bool cut = false;
    near(box, [&](std::uint32_t k) { cut = cut || crosses(sides_[k].a, sides_[k].b, ring); });
    if (cut) return false;
    // Its middle, not a corner: corners may lie on the border of a hole that it would fill.
    std::int64_t x = 0, y = 0;
    for (const GridPoint p : ring) {
        x += p.x;
        y += p.y;
    }
    const auto count = std::int64_t(ring.size());
    return holds(GridPoint{std::int32_t(x / count), std::int32_t(y / count)});
}

double Floor::free_way(Point p, Point direction, double most) const {
    const Point end = p + direction * most;
    const GridBox box{std::int32_t(std::floor(std::min(p.x, end.x))), std::int32_t(std::floor(std::min(p.y, end.y))),
                      std::int32_t(std::ceil(std::max(p.x, end.x))), std::int32_t(std::ceil(std::max(p.y, end.y)))};
    double way = most;
    near(box, [&](std::uint32_t k) {
        const Point a{double(sides_[k].a.x), double(sides_[k].a.y)}, b{double(sides_[k].b.x), double(sides_[k].b.y)};
        const double sa = plans::cross(direction, a - p), sb = plans::cross(direction, b - p);
        if ((sa > 0) == (sb > 0)) return;
        const double at = plans::dot(direction, a - p + (b - a) * (sa / (sa - sb)));
        if (at >= 0) way = std::min(way, at);
    });
    return way;
}

}  // namespace enfilade::modeler
