#include "tests/support/room_shapes.h"

#include <algorithm>
#include <cmath>

namespace enfilade::testing {

using plans::Point;

Ring box(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Ring box_at(Point middle, double width, double depth) {
    return box(middle.x - width / 2, middle.y - depth / 2, middle.x + width / 2, middle.y + depth / 2);
}

Ring circle(Point middle, double radius, std::uint32_t chords, double phase) {
    Ring ring;
    for (std::uint32_t k = 0; k < chords; ++k) {
        const double angle = phase + whole_turn * k / chords;
        ring.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    }
    return ring;
}

void append_arc(Ring& ring, Point to, double angle, std::uint32_t chords) {
    const Point from = ring.back();
    if (chords > 1 && std::abs(angle) > 1e-12) {
        const double to_middle = 0.5 / std::tan(angle / 2);
        const Point middle = {(from.x + to.x) / 2 - (to.y - from.y) * to_middle,
                              (from.y + to.y) / 2 + (to.x - from.x) * to_middle};
        for (std::uint32_t k = 1; k < chords; ++k) {
            const double a = angle * k / chords, c = std::cos(a), s = std::sin(a);
            const double x = from.x - middle.x, y = from.y - middle.y;
            ring.push_back({middle.x + c * x - s * y, middle.y + s * x + c * y});
        }
    }
    ring.push_back(to);
}

Ring with_arcs(const Ring& corners, const std::vector<double>& angles, const std::vector<std::uint32_t>& chords) {
    Ring ring = {corners[0]};
    for (std::size_t k = 0; k < corners.size(); ++k)
        append_arc(ring, corners[(k + 1) % corners.size()], angles[k], chords[k]);
    ring.pop_back();
    return ring;
}

Ring sector(Point middle, double inner, double outer, double from, double to, std::uint32_t inner_chords,
            std::uint32_t outer_chords) {
    Ring ring;
    const auto add = [&](double radius, double angle) {
        ring.push_back({middle.x + radius * std::cos(angle), middle.y + radius * std::sin(angle)});
    };
    for (std::uint32_t k = 0; k <= outer_chords; ++k) add(outer, from + (to - from) * k / outer_chords);
    for (std::uint32_t k = 0; k <= inner_chords; ++k) add(inner, to + (from - to) * k / inner_chords);
    return ring;
}

Ring spiral(double radius, double width, double turns, std::uint32_t chords_per_turn) {
    Ring outer, inner;
    const std::uint32_t count = std::max(2u, std::uint32_t(turns * chords_per_turn));
    const double least = radius / 20, pitch = (radius - least) / turns;
    for (std::uint32_t k = 0; k <= count; ++k) {
        const double angle = whole_turn * k / chords_per_turn, r = radius - pitch * k / chords_per_turn;
        outer.push_back({r * std::cos(angle), r * std::sin(angle)});
        const double s = std::max(r - width * pitch, r / 2);
        inner.push_back({s * std::cos(angle), s * std::sin(angle)});
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

Ring turned(const Ring& ring, double angle) {
    Ring result;
    const double c = std::cos(angle), s = std::sin(angle);
    for (const Point p : ring) result.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
    return result;
}

Ring moved(const Ring& ring, Point by) {
    Ring result;
    for (const Point p : ring) result.push_back({p.x + by.x, p.y + by.y});
    return result;
}

}  // namespace enfilade::testing
