#pragma once
// Simple polygons of the kinds that rooms are: without holes, counter-clockwise.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "modeler/cutting/polygon.h"
#include "plans/random.h"

namespace enfilade::modeler::samples {

using plans::GridPoint;
using Ring = std::vector<GridPoint>;

inline GridPoint rounded(double x, double y) { return {std::int32_t(std::lround(x)), std::int32_t(std::lround(y))}; }

struct Polygon {
    std::vector<GridPoint> points;
    std::vector<PolygonSide> sides;

    /// Every side has its own line, tag, look and number of faces; tags count from 100.
    explicit Polygon(Ring ring = {}) : points(std::move(ring)) {
        const auto count = std::uint32_t(points.size());
        for (std::uint32_t k = 0; k < count; ++k)
            sides.push_back({k, (k + 1) % count, k, 100 + k, 2000000 + k, 1 + k % 3});
    }

    /// Corners that turn right between different lines.
    [[nodiscard]] std::uint32_t reflex_count() const {
        std::uint32_t count = 0;
        const std::size_t n = sides.size();
        for (std::size_t k = 0; k < n; ++k) {
            const PolygonSide& in = sides[(k + n - 1) % n];
            count +=
                in.line != sides[k].line && orientation(points[in.from], points[k], points[sides[k].to]) < 0 ? 1 : 0;
        }
        return count;
    }
};

/// Around the origin: a corner per step of the angle, each at a radius of its own.
inline Polygon star(plans::Random& random, int corners, double least, double most) {
    Ring ring;
    for (int k = 0; k < corners; ++k) {
        const double angle = 2 * std::numbers::pi * k / corners, r = random.uniform(least, most);
        ring.push_back(rounded(r * std::cos(angle), r * std::sin(angle)));
    }
    return Polygon(ring);
}

/// A passage that winds inwards, `chords` to a turn.
inline Polygon spiral(double turns, int chords, double width) {
    Ring outer, inner;
    const int steps = int(turns * chords);
    for (int k = 0; k <= steps; ++k) {
        const double angle = 2 * std::numbers::pi * k / chords;
        const double r = 2 * width * (turns + 2 - double(k) / chords);
        outer.push_back(rounded(r * std::cos(angle), r * std::sin(angle)));
        inner.push_back(rounded((r - width) * std::cos(angle), (r - width) * std::sin(angle)));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return Polygon(outer);
}

/// Niches of random depth and width along a wall: axis-aligned. Depths never repeat from one to the next.
inline Polygon comb(plans::Random& random, int teeth) {
    Ring top;
    std::int32_t x = 0;
    for (int k = 0; k < teeth; ++k) {
        const auto y = std::int32_t(random.uniform(10000, 40000)) / 2 * 2 + k % 2;
        top.push_back({x, y});
        x += std::int32_t(random.uniform(500, 20000));
        top.push_back({x, y});
    }
    Ring ring = {{0, 0}, {x, 0}};
    ring.insert(ring.end(), top.rbegin(), top.rend());
    return Polygon(ring);
}

/// A room of four walls, each straight or bulging in or out, in at most `chords` chords.
inline Polygon arched_room(plans::Random& random, int chords) {
    const double side = 60000;
    Ring ring;
    for (int wall = 0; wall < 4; ++wall) {
        const int count = 1 + int(random.uniform(0, chords));
        const double sagitta = count == 1 ? 0 : random.uniform(-0.19, 0.19) * side;
        for (int k = 0; k < count; ++k) {
            double x = side * k / count, y = 0;
            if (std::abs(sagitta) > 1) {
                const double radius = (side * side / 4 + sagitta * sagitta) / (2 * std::abs(sagitta));
                const double half = std::asin(side / 2 / radius), angle = half * (2.0 * k / count - 1);
                x = side / 2 + radius * std::sin(angle);
                y = std::copysign(radius * (std::cos(angle) - std::cos(half)), sagitta);
            }
            const double u = x - side / 2, v = y - side / 2;
            ring.push_back(wall == 0   ? rounded(u, v)
                           : wall == 1 ? rounded(-v, u)
                           : wall == 2 ? rounded(-u, -v)
                                       : rounded(v, -u));
        }
    }
    return Polygon(ring);
}

/// The polygon with its sides in several parts of one line, at points rounded to the grid.
inline Polygon bent(plans::Random& random, const Polygon& polygon, int parts) {
    Polygon result;
    for (const PolygonSide& side : polygon.sides) {
        const GridPoint a = polygon.points[side.from], b = polygon.points[side.to];
        const int count = 1 + int(random.uniform(0, parts));
        for (int k = 0; k < count; ++k) {
            const double t = double(k) / count;
            const GridPoint p = rounded(a.x + t * (double(b.x) - a.x), a.y + t * (double(b.y) - a.y));
            if (k > 0 && (p == a || p == b || p == result.points.back())) continue;
            const auto at = std::uint32_t(result.points.size());
            result.points.push_back(p);
            result.sides.push_back({at, at + 1, side.line, 100 + at, 2000000 + at, 1});
        }
    }
    result.sides.back().to = 0;
    return result;
}

/// Squares joined along whole edges, without holes and without two that touch in a corner only; the contour has a
/// corner at every square, moved by up to `jitter`.
inline Polygon polyomino(plans::Random& random, std::uint32_t squares, std::int32_t size, std::int32_t jitter) {
    using Cell = std::pair<std::int32_t, std::int32_t>;
    constexpr std::array<Cell, 8> around = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
    std::set<Cell> filled = {{0, 0}};
    std::vector<Cell> order = {{0, 0}};
    for (std::uint32_t tries = 0; order.size() < squares && tries < 50 * squares; ++tries) {
        const Cell at = order[random.below(std::uint32_t(order.size()))];
        const Cell step = around[2 * random.below(4)];
        const Cell cell = {at.first + step.first, at.second + step.second};
        std::uint32_t runs = 0;  // of filled cells around it: one, and the contour stays one ring
        const auto is_filled = [&](std::size_t k) {
            return filled.contains({cell.first + around[k % 8].first, cell.second + around[k % 8].second});
        };
        for (std::size_t k = 0; k < 8; ++k) runs += !is_filled(k) && is_filled(k + 1) ? 1u : 0u;
        if (filled.contains(cell) || runs != 1) continue;
        filled.insert(cell);
        order.push_back(cell);
    }
    std::map<Cell, Cell> contour;  // from the start of a side to its end, the squares on its left
    for (const auto& [x, y] : filled) {
        if (!filled.contains({x, y - 1})) contour[{x, y}] = {x + 1, y};
        if (!filled.contains({x + 1, y})) contour[{x + 1, y}] = {x + 1, y + 1};
        if (!filled.contains({x, y + 1})) contour[{x + 1, y + 1}] = {x, y + 1};
        if (!filled.contains({x - 1, y})) contour[{x, y + 1}] = {x, y};
    }
    Ring ring;
    Cell at = contour.begin()->first;
    do {
        const auto moved = [&](std::int32_t k) {
            return k * size + std::int32_t(random.below(2 * std::uint32_t(jitter) + 1)) - jitter;
        };
        const std::int32_t x = moved(at.first);
        ring.push_back({x, moved(at.second)});
        at = contour[at];
    } while (at != contour.begin()->first);
    return Polygon(ring);
}

/// The polygon with sides that go straight on laid on one line, now and then.
inline Polygon joined(plans::Random& random, Polygon polygon) {
    for (std::size_t k = 1; k < polygon.sides.size(); ++k) {
        const PolygonSide& in = polygon.sides[k - 1];
        PolygonSide& out = polygon.sides[k];
        if (random.chance(0.8) &&
            goes_straight(polygon.points[in.from], polygon.points[in.to], polygon.points[out.to], in.line, in.line) &&
            std::abs(orientation(polygon.points[in.from], polygon.points[in.to], polygon.points[out.to])) <
                std::abs(polygon.points[out.to].x - polygon.points[in.from].x) +
                    std::abs(polygon.points[out.to].y - polygon.points[in.from].y))
            out.line = in.line;
    }
    return polygon;
}

}  // namespace enfilade::modeler::samples
