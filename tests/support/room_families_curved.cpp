// Rooms with curved walls and columns.

#include <algorithm>
#include <cmath>

#include "tests/support/room_families.h"

namespace enfilade::testing::families {

using plans::Point;

void columns(const Brush& brush) {
    const double w = brush.random.uniform(3, 16) * metre, d = brush.random.uniform(3, 16) * metre;
    brush.room(brush.random.chance(0.7) ? box_at({0, 0}, w, d) : circle({0, 0}, w / 2, 12 + brush.random.below(30)));
    const std::uint32_t count = brush.few(1, 30), most = std::max(3u, 180 / count);
    const bool in_rows = brush.random.chance(0.4), alike = brush.random.chance(0.5);
    const std::uint32_t chords = 3 + brush.random.below(std::min(most, 64u) - 2);
    const double radius = brush.magnitude(0.02, 0.6) * metre, spin = brush.random.uniform(0, 1);
    const std::uint32_t row = std::max(1u, std::uint32_t(std::sqrt(double(count))));
    for (std::uint32_t k = 0; k < count; ++k) {
        Point at = {brush.random.uniform(-0.5, 0.5) * w, brush.random.uniform(-0.5, 0.5) * d};
        if (in_rows) at = {(double(k % row) + 0.5) / row * w - w / 2, (k / row + 0.5) / (count / row + 1) * d - d / 2};
        const double own = alike ? radius : brush.magnitude(0.02, 0.6) * metre;
        if (brush.random.chance(0.3)) brush.solid(box_at(at, 2 * own, own));
        else brush.solid(circle(at, own, alike ? chords : 3 + brush.random.below(std::min(most, 64u) - 2), spin));
    }
}

void spirals(const Brush& brush) {
    const bool square = brush.random.chance(0.4);
    const std::uint32_t chords = square ? 4 : 5 + brush.random.below(30);
    const double turns = std::min(brush.random.uniform(1, 8), 90.0 / chords);
    brush.room(spiral(brush.magnitude(500, 15 * metre), brush.random.uniform(0.1, 0.95), turns, chords));
}

void arc_walls(const Brush& brush) {
    const std::uint32_t corners = 3 + brush.random.below(8);
    const double radius = brush.magnitude(100, 10 * metre);
    Ring ring;
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double angle = whole_turn * k / corners, r = radius * brush.random.uniform(0.6, 1);
        ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    std::vector<double> angles;
    std::vector<std::uint32_t> chords;
    for (std::uint32_t k = 0; k < corners; ++k) {
        angles.push_back(brush.random.chance(0.4) ? 0 : brush.sign() * brush.magnitude(0.05, 3));
        chords.push_back(brush.few(3, 150 / corners));
    }
    brush.room(with_arcs(ring, angles, chords));
    if (brush.random.chance(0.3)) brush.solid(box_at({0, 0}, radius / 4, radius / 6));
}

void circles(const Brush& brush) {
    const double radius = brush.magnitude(20, 12 * metre);
    const std::uint32_t chords = brush.few(3, 100);
    brush.room(circle({0, 0}, radius, chords, brush.random.uniform(0, 1)));
    const std::uint32_t holes = brush.random.below(3);
    for (std::uint32_t k = 0; k < holes; ++k) {
        const double own = radius * brush.random.uniform(0.05, 0.9);
        const double off = brush.random.chance(0.3) ? 0 : (radius - own) * brush.random.uniform(0, 1.01);
        const double angle = brush.random.uniform(0, whole_turn);
        brush.solid(circle({off * std::cos(angle), off * std::sin(angle)}, own,
                           brush.random.chance(0.5) ? chords : brush.few(3, 64), brush.random.uniform(0, 1)));
    }
}

void tangents(const Brush& brush) {
    const double w = std::round(brush.random.uniform(2, 12) * metre),
                 d = std::round(brush.random.uniform(2, 12) * metre);
    const double most = std::min(w, d) / 2, r = std::round(brush.magnitude(10, most));
    Ring ring;  // fillets in some corners, a half round where two meet
    const Point corners[4] = {{0, 0}, {w, 0}, {w, d}, {0, d}}, along[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int k = 0; k < 4; ++k) {
        const Point before = along[(k + 3) % 4], after = along[k];
        ring.push_back({corners[k].x - r * before.x, corners[k].y - r * before.y});
        const Point end = {corners[k].x + r * after.x, corners[k].y + r * after.y};
        switch (brush.random.below(3)) {
            case 0: append_arc(ring, end, whole_turn / 4, 3 + brush.few(0, 30)); break;
            case 1: append_arc(ring, end, -whole_turn / 4, 3 + brush.few(0, 30)); break;
            default: ring.push_back(corners[k]), ring.push_back(end);
        }
    }
    brush.room(ring);
    const std::uint32_t discs = brush.random.below(3);
    for (std::uint32_t k = 0; k < discs; ++k) {  // columns that touch a wall, or miss it by a unit or two
        const double own = brush.magnitude(10, most / 2), off = brush.random.below(4) - 1.0;
        brush.solid(circle({brush.random.uniform(r + own, std::max(r + own + 1, w - r - own)), own + off}, own,
                           4 * (1 + brush.random.below(12)), 0));
    }
}

void lenses(const Brush& brush) {
    const double length = brush.magnitude(50, 12 * metre);
    const double one = brush.magnitude(0.001, 3),
                 other = brush.random.chance(0.4) ? -0.9 * one : brush.magnitude(0.001, 3);
    Ring ring = {{0, 0}};  // two arcs that meet in a lens or a crescent
    append_arc(ring, {length, 0}, one, brush.few(2, 64));
    append_arc(ring, {0, 0}, other, brush.few(2, 64));
    ring.pop_back();
    brush.room(ring);
    if (brush.random.chance(0.4)) brush.room(box(length * 0.9, -length / 4, length * 1.5, length / 4));
}

void clovers(const Brush& brush) {
    const std::uint32_t lobes = 2 + brush.random.below(6);
    const double radius = brush.magnitude(200, 5 * metre);
    const bool inwards = brush.random.chance(0.4);
    if (inwards) brush.room(circle({0, 0}, 2.5 * radius, 4 + brush.random.below(12)));
    for (std::uint32_t k = 0; k < lobes; ++k) {
        const double angle = whole_turn * k / lobes, off = radius * brush.random.uniform(0.5, 1.6);
        brush.sketch.paint(inwards ? Paint::Solid : Paint::Room,
                           circle({off * std::cos(angle), off * std::sin(angle)}, radius,
                                  6 + brush.random.below(std::max(2u, 120 / lobes)), brush.random.uniform(0, 1)));
    }
}

void curved_corridors(const Brush& brush) {
    const double radius = brush.magnitude(300, 15 * metre), width = radius * brush.magnitude(0.002, 0.9);
    const double angle = brush.random.uniform(0.1, whole_turn - 0.05);
    const std::uint32_t chords = brush.few(2, 80);
    brush.room(
        sector({0, 0}, radius - width, radius, 0, angle, chords, brush.random.chance(0.6) ? chords : brush.few(2, 80)));
    if (brush.random.chance(0.5)) {  // and on around the other side: an S
        const double middle = 2 * radius - width;
        brush.room(
            sector({middle, 0}, radius - width, radius, whole_turn / 2, whole_turn / 2 + angle / 2, chords, chords));
    }
    if (brush.random.chance(0.3)) brush.room(box(radius - width, -metre, radius + metre, width / 2));
}

void shallow_arcs(const Brush& brush) {
    const double w = brush.magnitude(metre, 40 * metre), d = brush.magnitude(100, 6 * metre);
    Ring ring = {{0, 0}};
    for (const Point to : {Point{w, 0}, Point{w, d}, Point{0, d}, Point{0, 0}}) {
        const double radius = brush.magnitude(w, 10000 * metre);
        const double angle = 2 * std::asin(std::min(0.9, w / 2 / radius));
        const bool straight = to.x != ring.back().x ? brush.random.chance(0.2) : true;
        append_arc(ring, to, brush.sign() * angle, straight ? 1 : brush.few(3, 90));
    }
    ring.pop_back();
    brush.room(ring);
}

void tiny_arcs(const Brush& brush) {
    const double w = std::round(brush.magnitude(400, 4 * metre)), d = std::round(brush.magnitude(400, 4 * metre));
    brush.room(box(0, 0, w, d));
    const std::uint32_t count = 1 + brush.random.below(5);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double radius = brush.magnitude(3, 82);  // up to a centimetre
        const bool at_wall = brush.random.chance(0.6);
        const Point at = {brush.random.uniform(0, w), at_wall ? 0 : brush.random.uniform(0, d)};
        brush.sketch.paint(brush.random.chance(0.6) ? Paint::Solid : Paint::Room,
                           circle(at, radius, 3 + brush.random.below(40), brush.random.uniform(0, 1)));
    }
}

}  // namespace enfilade::testing::families
