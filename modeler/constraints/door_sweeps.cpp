#include "modeler/constraints/door_sweeps.h"

#include <algorithm>
#include <cmath>

#include "modeler/constraints/wall_bodies.h"
#include "plans/vector2.h"

namespace enfilade::modeler {
namespace {

using plans::Point;

constexpr double two_leaves = 1.3;  // metres of width, as architects' plans have it
constexpr double sliding = 2.6;
constexpr int arc_steps = 12;
constexpr double clearance = 0.05;  // metres under and over the leaf that rugs and lamps may have

/// The points (x, height(x)) for x in [from, to] over the base line, which closes the polygon.
template <class Height>
Footprint over_base(Point origin, Point along, Point out, double from, double to, Height height) {
    Footprint polygon = {origin + along * from, origin + along * to};
    for (int k = arc_steps; k >= 0; --k) {
        const double x = from + (to - from) * k / arc_steps, y = height(x);
        if (y > 0) polygon.push_back(origin + along * x + out * y);
    }
    return polygon;
}

}  // namespace

std::vector<DoorSweep> door_sweeps(const plans::Wall& wall, const plans::Opening& door) {
    std::vector<DoorSweep> sweeps;
    const plans::WallAxis axis = axis_of(wall);
    if (door.width >= sliding || !(axis.length() > 0)) return sweeps;
    const double t = std::clamp(door.offset / axis.length(), 0.0, 1.0);
    const Point middle = axis.at(t), left = axis.normal(t);
    for (const double side : {1.0, -1.0}) {
        const double depth = wall.thickness / 2 + (side > 0 ? door.depth_left : door.depth_right);
        const Point out = left * side;
        const Point along = plans::turned_left(out) * -1.0;  // so that `out` is on its left
        const Point mouth = middle + out * depth;
        const Point jamb = mouth - along * (door.width / 2);
        const auto add = [&](Footprint footprint) {
            sweeps.push_back({{std::move(footprint), door.sill + clearance, door.head - clearance}, mouth});
        };
        const double w = door.width;
        const auto circle = [](double radius, double x) { return std::sqrt(std::max(0.0, radius * radius - x * x)); };
        if (w < two_leaves) {
            add(over_base(jamb, along, out, 0, w, [&](double x) { return std::min(circle(w, x), circle(w, w - x)); }));
        } else {
            add(over_base(jamb, along, out, 0, w / 2, [&](double x) { return circle(w / 2, x); }));
            add(over_base(jamb, along, out, w / 2, w, [&](double x) { return circle(w / 2, w - x); }));
        }
    }
    return sweeps;
}

double depth_in_sweep(const UprightBody& body, const DoorSweep& sweep, const WallBodies& bodies, std::uint32_t host) {
    constexpr double doubtful = 0.08;  // metres: rugs, and lamps over the leaf
    if (shared_height(body, sweep.body) < doubtful) return 0;
    const Footprint common = shared(body.footprint, sweep.body.footprint);
    if (common.empty()) return 0;
    const Point middle = middle_of(common);
    double depth = depth_of(middle, sweep.body.footprint);
    for (const Point p : common) depth = std::max(depth, depth_of(p, sweep.body.footprint));
    constexpr int samples = 8;
    for (int k = 1; k < samples; ++k)
        if (bodies.wall_at(sweep.mouth + (middle - sweep.mouth) * (double(k) / samples), host)) return 0;
    return depth;
}

}  // namespace enfilade::modeler
