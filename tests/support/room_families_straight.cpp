// Rooms with straight walls.

#include <algorithm>
#include <cmath>

#include "tests/support/room_families.h"

namespace enfilade::testing::families {

using plans::Point;

namespace {

/// Whole units, so that boxes of one sketch meet exactly.
double units(const Brush& brush, double low, double high) { return std::round(brush.random.uniform(low, high)); }

/// A box on one of the walls of a hall w by d, reaching in or out.
Ring box_on_wall(const Brush& brush, double w, double d, double width, double depth, bool inwards) {
    const std::uint32_t wall = brush.random.below(4);
    const double along = wall % 2 == 0 ? w : d;
    const double at = units(brush, -width, along), in = inwards ? depth : -depth;
    switch (wall) {
        case 0: return box(at, std::min(0.0, in), at + width, std::max(0.0, in));
        case 1: return box(std::min(w, w - in), at, std::max(w, w - in), at + width);
        case 2: return box(at, std::min(d, d - in), at + width, std::max(d, d - in));
        default: return box(std::min(0.0, in), at, std::max(0.0, in), at + width);
    }
}

}  // namespace

void notched(const Brush& brush) {
    const double w = units(brush, 2 * metre, 20 * metre), d = units(brush, 2 * metre, 12 * metre);
    brush.room(box(0, 0, w, d));
    const std::uint32_t niches = brush.few(0, 12), piers = brush.few(0, 20);
    for (std::uint32_t k = 0; k < niches; ++k)
        brush.room(box_on_wall(brush, w, d, std::round(brush.magnitude(4, 3 * metre)),
                               std::round(brush.magnitude(2, metre)), false));
    for (std::uint32_t k = 0; k < piers; ++k)
        brush.solid(box_on_wall(brush, w, d, std::round(brush.magnitude(4, 2 * metre)),
                                std::round(brush.magnitude(2, metre)), true));
}

void letters(const Brush& brush) {
    const std::uint32_t bars = 2 + brush.random.below(4);
    for (std::uint32_t k = 0; k < bars; ++k) {
        const bool lying = brush.random.chance(0.5);
        const double length = units(brush, 3 * metre, 15 * metre), width = units(brush, metre, 3 * metre);
        const double raster = brush.random.chance(0.5) ? metre : 1;
        const double x = std::round(brush.random.uniform(-4, 4) * metre / raster) * raster,
                     y = std::round(brush.random.uniform(-4, 4) * metre / raster) * raster;
        brush.room(lying ? box(x, y, x + length, y + width) : box(x, y, x + width, y + length));
    }
}

void comb(const Brush& brush) {
    const std::uint32_t teeth = brush.few(1, 48);
    const double pitch = units(brush, 3, metre),
                 gap = std::max(1.0, std::round(pitch * brush.random.uniform(0.1, 0.9)));
    const double back = units(brush, 2, metre), depth = std::round(brush.magnitude(1, 6 * metre));
    const bool one_line = brush.random.chance(0.5), ragged = brush.random.chance(0.3);
    Ring ring = {{0, 0}, {teeth * pitch, 0}};
    std::vector<std::uint32_t> lines = {0, 1};
    for (std::uint32_t k = teeth; k-- > 0;) {
        const double top = back + (ragged ? std::round(depth * brush.random.uniform(0.2, 1)) + 1 : depth);
        const Ring tooth = {{(k + 1) * pitch, top}, {k * pitch + gap, top}, {k * pitch + gap, back}, {k * pitch, back}};
        ring.insert(ring.end(), tooth.begin(), tooth.end());
        const std::uint32_t next = std::uint32_t(ring.size());
        lines.insert(lines.end(),
                     {one_line && !ragged ? 1000000 : next, next + 1, one_line ? 1000001 : next + 2, next + 3});
    }
    lines.pop_back(), ring.pop_back();  // the last gap ends at the left wall
    ring.push_back({0, back});
    lines.push_back(999999);
    for (std::uint32_t& line : lines)
        if (line >= 999999) line = line - 999999 + 4 * teeth + 8;
    brush.sketch.paint(Paint::Room, ring, lines);
}

void star(const Brush& brush) {
    const std::uint32_t corners = brush.few(5, 200);
    const double radius = brush.magnitude(50, 20 * metre), low = brush.random.uniform(0.02, 0.9);
    Ring ring;
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double angle = whole_turn * k / corners, r = radius * brush.random.uniform(low, 1);
        ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    brush.room(ring);
    if (brush.random.chance(0.3)) brush.solid(circle({0, 0}, radius * low / 2, 3 + brush.random.below(5), 0.1));
}

void zigzag(const Brush& brush) {
    const std::uint32_t bends = brush.few(2, 60);
    const Point across = {brush.random.uniform(-200, 200), brush.magnitude(2, 2 * metre)};
    Ring low, high;
    double x = 0;
    for (std::uint32_t k = 0; k < bends; ++k) {
        const double y = (k % 2 == 0 ? 1 : -1) * brush.magnitude(10, 2 * metre);
        low.push_back({x, y});
        high.push_back({x + across.x, y + across.y});
        x += brush.magnitude(20, 2 * metre);
    }
    low.insert(low.end(), high.rbegin(), high.rend());
    brush.room(low);
}

void courtyards(const Brush& brush) {
    double half = 12 * metre;
    const std::uint32_t layers = 2 + brush.random.below(5);
    Point middle = {0, 0};
    for (std::uint32_t k = 0; k < layers; ++k) {
        const Paint paint = k % 2 == 0 ? Paint::Room : Paint::Solid;
        const std::uint32_t kind = brush.random.below(3);
        const Ring ring = kind == 0   ? box_at(middle, 2 * half, half * brush.random.uniform(1, 2))
                          : kind == 1 ? circle(middle, half, 4 + brush.random.below(20), brush.random.uniform(0, 1))
                                      : moved(turned(box_at({0, 0}, 1.4 * half, 1.4 * half), 0.5), middle);
        brush.sketch.paint(paint, ring);
        if (brush.random.chance(0.2)) {  // another yard beside it
            const Point beside = {middle.x + brush.random.uniform(-0.4, 0.4) * half, middle.y - half / 2};
            brush.solid(box_at(beside, half / 5, half / 6));
        }
        half *= brush.random.uniform(0.3, 0.6);
        middle = {middle.x + brush.random.uniform(-0.2, 0.2) * half, middle.y + brush.random.uniform(-0.2, 0.2) * half};
    }
    if (brush.random.chance(0.3)) brush.room(box_at({0, 0}, 30 * metre, 0.4 * metre));  // a passage through all
}

void pinched(const Brush& brush) {
    const double w = units(brush, 2 * metre, 10 * metre), d = units(brush, 2 * metre, 10 * metre);
    brush.room(box(0, 0, w, d));
    const std::uint32_t holes = 1 + brush.random.below(5);
    Point last = {w / 2, d / 2};
    for (std::uint32_t k = 0; k < holes; ++k) {
        const double size = std::round(brush.magnitude(4, std::min(w, d) / 4));
        Point touch = {units(brush, size, w - size), 0};  // on the lower wall
        const std::uint32_t kind = brush.random.below(4);
        if (kind == 1) touch = {0, units(brush, size, d - size)};
        if (kind == 2) touch = last;    // on the hole before
        if (kind == 3) touch = {w, d};  // in the corner
        const bool right = kind == 1, down = kind == 3;
        const double dx = right ? size : size / 2, dy = right ? size / 2 : size;
        Ring hole = {touch, {touch.x + dx, touch.y + (right ? -dy : dy)}, {touch.x + (right ? dx : -dx), touch.y + dy}};
        if (down) hole = {touch, {touch.x - size, touch.y - size / 2}, {touch.x - size / 2, touch.y - size}};
        for (Point& p : hole) p = {std::round(p.x), std::round(p.y)};
        brush.solid(hole);
        last = hole[1];
    }
}

void needles(const Brush& brush) {
    const double angle = brush.magnitude(1e-5, 0.05), length = brush.magnitude(100, 15 * metre);
    const double width = std::max(1.0, length * angle);
    brush.room({{0, 0}, {length, 0}, {length, width}});
    if (brush.random.chance(0.7)) brush.room(box(length - 10, -metre, length + 2 * metre, metre));
    if (brush.random.chance(0.4)) {  // a wedge of wall in a hall
        brush.room(box(-metre, -3 * metre, length, -metre / 2));
        brush.solid({{-metre, -2 * metre}, {length / 2, -2 * metre - 2}, {-metre, -2 * metre + width}});
    }
    if (brush.random.chance(0.3)) brush.room(turned({{0, 0}, {length, 0}, {length, width}}, 2 * angle));
}

void gaps(const Brush& brush) {
    const double w = units(brush, metre, 5 * metre), d = units(brush, metre, 5 * metre);
    const double gap = 1 + brush.random.below(4);
    brush.room(box(0, 0, w, d));
    const std::uint32_t count = brush.few(1, 12);
    for (std::uint32_t k = 0; k < count; ++k) {
        const double at = units(brush, 10, d - 10), far = units(brush, w / 8, w);
        switch (brush.random.below(4)) {
            case 0: brush.solid(box(0, at, far, at + gap)); break;           // a wall as thin as the grid
            case 1: brush.room(box(w, at, w + far, at + gap)); break;        // a slit
            case 2: brush.solid(box(gap, at, far, at + metre / 8)); break;   // a block that close to the wall
            default: brush.solid(box(far, gap, far + gap, d - gap)); break;  // nearly through
        }
    }
    if (brush.random.chance(0.5)) brush.room(box(w + metre, 0, 2 * w + metre, d));
}

void steps(const Brush& brush) {
    const std::uint32_t corners = brush.few(3, 40);
    const double radius = brush.magnitude(100, 5 * metre);
    Ring ring;
    for (const Point p : circle({0, 0}, radius, corners, 0.3)) {
        ring.push_back({std::round(p.x), std::round(p.y)});
        const std::uint32_t more = brush.random.below(4);
        for (std::uint32_t k = 0; k < more; ++k)
            ring.push_back({ring.back().x + brush.random.below(3) - 1.0, ring.back().y + brush.random.below(3) - 1.0});
    }
    brush.room(ring);
    const std::uint32_t piers = brush.few(0, 12);
    for (std::uint32_t k = 0; k < piers; ++k)
        brush.solid(box_at({units(brush, -radius, radius), units(brush, -radius, radius)},
                           2 * (1 + brush.random.below(3)), 2 * (1 + brush.random.below(40))));
}

void bent(const Brush& brush) {
    const std::uint32_t corners = brush.few(3, 24);
    const double radius = brush.magnitude(30, 6 * metre);
    Ring ring;
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double angle = whole_turn * k / corners, r = radius * brush.random.uniform(0.3, 1);
        ring.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    brush.room(ring);
    const std::uint32_t lines = 3 + brush.few(0, 40);
    for (std::uint32_t k = 0; k < lines; ++k) {
        const double angle = brush.random.uniform(0, whole_turn), off = brush.random.uniform(-radius, radius);
        const Point along = {std::cos(angle), std::sin(angle)}, at = {-along.y * off, along.x * off};
        brush.sketch.scratch({at.x - 2 * radius * along.x, at.y - 2 * radius * along.y},
                             {at.x + 2 * radius * along.x, at.y + 2 * radius * along.y});
    }
}

namespace {

void paint_anything(const Brush& brush, double size, std::uint32_t count, bool first_room) {
    for (std::uint32_t k = 0; k < count; ++k) {
        const double x = brush.random.uniform(-size, size), y = brush.random.uniform(-size, size);
        const double extent = size * brush.random.uniform(0.05, 0.8);
        Ring ring;
        switch (brush.random.below(4)) {
            case 0: ring = box_at({x, y}, extent, size * brush.random.uniform(0.02, 0.8)); break;
            case 1: ring = circle({x, y}, extent / 2, 3 + brush.random.below(16), brush.random.uniform(0, 6)); break;
            case 2: ring = moved(turned(box_at({0, 0}, extent, size * 0.1), brush.random.uniform(0, 3)), {x, y}); break;
            default:
                for (int c = 0; c < 4; ++c)
                    ring.push_back(
                        {x + extent * brush.random.uniform(-1, 1), y + extent * brush.random.uniform(-1, 1)});
        }
        if (brush.random.chance(0.3))
            for (Point& p : ring) p = {std::round(p.x / size * 8) * size / 8, std::round(p.y / size * 8) * size / 8};
        brush.sketch.paint((first_room && k == 0) || brush.random.chance(0.5) ? Paint::Room : Paint::Solid, ring);
    }
}

}  // namespace

void collage(const Brush& brush) {
    const double size = brush.magnitude(200, 10 * metre);
    brush.room(box_at({0, 0}, 1.5 * size, 1.2 * size));
    paint_anything(brush, size, brush.few(2, 24), true);
}

void pebbles(const Brush& brush) {
    const double size = brush.magnitude(4, 60);
    brush.room(box_at({0, 0}, 1.5 * size, 1.2 * size));
    paint_anything(brush, size, brush.few(2, 16), true);
}

}  // namespace enfilade::testing::families
