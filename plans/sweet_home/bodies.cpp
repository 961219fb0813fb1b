#include "plans/sweet_home/bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/sweet_home/shape.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

/// What of the polygon lies where dot(normal, p) <= limit (Sutherland and Hodgman 1974).
std::vector<Point> cut(const std::vector<Point>& polygon, Point normal, double limit) {
    std::vector<Point> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Point a = polygon[k];
        const Point b = polygon[(k + 1) % polygon.size()];
        const double from = dot(normal, a) - limit;
        const double to = dot(normal, b) - limit;
        if (from <= 0) kept.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) kept.push_back(a + (b - a) * (from / (from - to)));
    }
    return kept;
}

/// The part of the convex polygon inside the rectangle, in its coordinates; empty where they do not meet.
std::vector<Point> clipped(const std::vector<Point>& convex, const PlanRectangle& rectangle) {
    std::vector<Point> rest;
    rest.reserve(convex.size());
    for (const Point p : convex) rest.push_back(rectangle.local(p));
    const double x = rectangle.width / 2;
    const double y = rectangle.depth / 2;
    rest = cut(cut(cut(cut(rest, {1, 0}, x), {-1, 0}, x), {0, 1}, y), {0, -1}, y);
    if (rest.size() < 3) return {};
    return rest;
}

}  // namespace

Point PlanRectangle::local(Point p) const {
    const Point d = p - middle;
    return {dot(d, along), cross(along, d)};
}

WallBody::WallBody(const Wall& wall)
    : half(wall.thickness / 2), height(std::max(wall.height_at_start, wall.height_at_end)) {
    if (!(distance(wall.start, wall.end) > 1e-6)) return;
    axis = WallAxis(wall.start, wall.end, wall.arc_extent, 1e-5);
    const double step = std::numbers::pi / 36;  // 5 degrees: 1 mm beside the arc at a radius of 1 m
    const int chords = axis.straight() ? 1 : std::clamp(int(std::abs(axis.extent()) / step) + 1, 1, 96);
    for (int k = 0; k < chords; ++k) {
        const double from = double(k) / chords;
        const double to = double(k + 1) / chords;
        pieces.push_back(
            {axis.offset(from, -half), axis.offset(to, -half), axis.offset(to, half), axis.offset(from, half)});
        for (const Point p : pieces.back()) box.add(p);
    }
}

Point WallBody::along(double t) const { return turned_left(axis.normal(t)) * -1; }

double WallBody::overlap(const PlanRectangle& rectangle) const {
    double area = 0;
    for (const auto& piece : pieces) area += std::abs(signed_area(clipped(piece, rectangle)));
    return area;
}

LocalBox WallBody::extent_in(const PlanRectangle& rectangle) const {
    LocalBox extent;
    for (const auto& piece : pieces)
        for (const Point p : clipped(piece, rectangle)) extent.add(p);
    return extent;
}

double WallBody::offset_of(Point p) const {
    if (!axis.straight()) return axis.nearest(p) * axis.length();
    return dot(p - axis.at(0), along(0));
}

double WallBody::distance_of(Point p) const { return distance(p, axis.at(axis.nearest(p))); }

bool WallBody::beside(Point p, double tolerance) const {
    if (axis.straight()) {
        const double offset = offset_of(p);
        return offset >= -tolerance && offset <= axis.length() + tolerance;
    }
    const double t = axis.nearest(p);
    if (t > 0 && t < 1) return true;
    const Point end = axis.at(t);
    return std::abs(dot(p - end, along(t))) <= tolerance;
}

namespace {

std::vector<PlanBox> grown_boxes(const std::vector<WallBody>& bodies, double reach) {
    std::vector<PlanBox> boxes;
    boxes.reserve(bodies.size());
    for (const WallBody& body : bodies) boxes.push_back(body.usable() ? body.box.grown(reach) : PlanBox());
    return boxes;
}

}  // namespace

StoreyBodies::StoreyBodies(const Storey& storey, double reach)
    : bodies_(storey.walls.begin(), storey.walls.end()),
      indexed_(bodies_.size()),
      index_(grown_boxes(bodies_, reach)) {}

std::vector<std::size_t> StoreyBodies::near(Point p) const {
    std::vector<std::size_t> walls;
    index_.near(p, [&](std::uint32_t wall) { walls.push_back(wall); });
    for (std::size_t wall = indexed_; wall < bodies_.size(); ++wall)
        if (bodies_[wall].usable()) walls.push_back(wall);
    return walls;
}

}  // namespace enfilade::plans
