#pragma once
// Strokes of walls, doors and windows in metres, for tests.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plans/dxf/wall_bodies.h"
#include "plans/dxf/wall_runs.h"
#include "plans/vector2.h"

namespace enfilade::plans::wall_strokes {

using Strokes = std::vector<SheetStroke>;

inline SheetStroke stroke(Point a, Point b, Role role = Role::Wall, double bulge = 0) {
    SheetStroke s;
    s.stroke = {a, b, bulge};
    s.role = role;
    return s;
}

/// An arc around the centre, counter-clockwise where `to` > `from`. Degrees.
inline SheetStroke arc(Point centre, double radius, double from, double to, Role role = Role::Wall) {
    const double degree = std::acos(-1.0) / 180;
    const auto at = [&](double a) { return centre + Point{std::cos(a * degree), std::sin(a * degree)} * radius; };
    return stroke(at(from), at(to), role, std::tan((to - from) * degree / 4));
}

inline Strokes operator+(Strokes l, const Strokes& r) {
    l.insert(l.end(), r.begin(), r.end());
    return l;
}

/// The four sides of a box.
inline Strokes box(Point low, Point high, Role role = Role::Wall) {
    return {stroke(low, {high.x, low.y}, role), stroke({high.x, low.y}, high, role),
            stroke(high, {low.x, high.y}, role), stroke({low.x, high.y}, low, role)};
}

/// Both faces of a wall that runs along x or y, its ends open.
inline Strokes faces(Point low, Point high, Role role = Role::Wall) {
    if (high.x - low.x > high.y - low.y)
        return {stroke(low, {high.x, low.y}, role), stroke({low.x, high.y}, high, role)};
    return {stroke(low, {low.x, high.y}, role), stroke({high.x, low.y}, high, role)};
}

inline WallBodies bodies_of(const Strokes& strokes, const PairLimits& limits = {}) {
    Strokes walls = strokes;
    std::erase_if(walls, [](const SheetStroke& s) { return s.role != Role::Wall && s.role != Role::LowWall; });
    return wall_bodies(walls, limits);
}

inline std::vector<WallRun> runs_of(const Strokes& strokes) { return wall_runs(bodies_of(strokes), strokes); }

/// A wall's axis, from left to right or from below.
struct Axis {
    Point a;
    Point b;
    double thickness = 0;
    friend bool operator==(const Axis& l, const Axis& r) {
        return distance(l.a, r.a) < 1e-9 && distance(l.b, r.b) < 1e-9 && std::abs(l.thickness - r.thickness) < 1e-9;
    }
    friend std::ostream& operator<<(std::ostream& out, const Axis& x) {
        return out << '(' << x.a.x << ' ' << x.a.y << ")-(" << x.b.x << ' ' << x.b.y << ") " << x.thickness;
    }
};

inline Axis ordered(Point a, Point b, double thickness) {
    const bool swapped = std::abs(a.x - b.x) > 1e-6 ? a.x > b.x : a.y > b.y;
    return swapped ? Axis{b, a, thickness} : Axis{a, b, thickness};
}

inline void sort(std::vector<Axis>& axes) {
    const auto rounded = [](double x) { return std::lround(x * 1e6); };
    std::sort(axes.begin(), axes.end(), [&](const Axis& l, const Axis& r) {
        return std::tuple(rounded(l.a.x), rounded(l.a.y), rounded(l.b.x), rounded(l.b.y)) <
               std::tuple(rounded(r.a.x), rounded(r.a.y), rounded(r.b.x), rounded(r.b.y));
    });
}

/// Of bodies or single lines, from left to right, then from below.
inline std::vector<Axis> axes_of(const WallBodies& bodies, const std::vector<WallBody>& list) {
    std::vector<Axis> axes;
    for (const WallBody& body : list) {
        const Point dir = bodies.groups.at(body.group).dir, aside = turned_left(dir) * body.v;
        axes.push_back(ordered(dir * body.u0 + aside, dir * body.u1 + aside, body.thickness));
    }
    sort(axes);
    return axes;
}

inline std::vector<Axis> axes_of(const std::vector<WallRun>& runs) {
    std::vector<Axis> axes;
    for (const WallRun& run : runs) axes.push_back(ordered(run.start, run.end, run.thickness));
    sort(axes);
    return axes;
}

}  // namespace enfilade::plans::wall_strokes
