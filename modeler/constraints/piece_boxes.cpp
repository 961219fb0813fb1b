#include "modeler/constraints/piece_boxes.h"

#include <algorithm>
#include <cmath>

#include "plans/vector2.h"

namespace enfilade::modeler {

using plans::Point;

namespace {

/// The shortest way out of the overlap across the sides of `a`; 0 where one of them parts the two.
double depth_across_sides(const Footprint& a, const Footprint& b) {
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const Point side = a[(k + 1) % a.size()] - a[k];
        const double length = plans::norm(side);
        if (length == 0) continue;
        const Point inward = plans::turned_left(side) * (1 / length);
        double deepest = -HUGE_VAL;
        for (const Point p : b) deepest = std::max(deepest, plans::dot(inward, p - a[k]));
        least = std::min(least, deepest);
    }
    return std::max(0.0, least);
}

}  // namespace

UprightBody body_of(const plans::Furniture& piece) {
    const Point along = Point{std::cos(piece.angle), std::sin(piece.angle)} * (piece.width / 2);
    const Point across = Point{-std::sin(piece.angle), std::cos(piece.angle)} * (piece.depth / 2);
    const Point p = piece.position;
    return {{p - along - across, p + along - across, p + along + across, p - along + across},
            piece.elevation,
            piece.elevation + piece.height};
}

Footprint strip(Point a, Point b, double half) {
    const double length = plans::distance(a, b);
    const Point left = length > 0 ? plans::turned_left(b - a) * (half / length) : Point{};
    return {a - left, b - left, b + left, a + left};
}

double depth_in(const Footprint& a, const Footprint& b) {
    return std::min(depth_across_sides(a, b), depth_across_sides(b, a));
}

double shared_height(const UprightBody& a, const UprightBody& b) {
    return std::min(a.z_high, b.z_high) - std::max(a.z_low, b.z_low);
}

Footprint shared(const Footprint& a, const Footprint& b) {
    Footprint polygon = a, next;
    for (std::size_t k = 0; k < b.size() && !polygon.empty(); ++k) {
        const Point from = b[k], side = b[(k + 1) % b.size()] - from;
        next.clear();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Point p = polygon[i], q = polygon[(i + 1) % polygon.size()];
            const double at_p = plans::cross(side, p - from), at_q = plans::cross(side, q - from);
            if (at_p >= 0) next.push_back(p);
            if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) next.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
        polygon.swap(next);
    }
    return polygon;
}

double area_of(const Footprint& polygon) {
    double sum = 0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        sum += plans::cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return std::abs(sum) / 2;
}

Point middle_of(const Footprint& polygon) {
    Point sum;
    for (const Point p : polygon) sum = sum + p;
    return polygon.empty() ? sum : sum * (1 / double(polygon.size()));
}

plans::PlanBox box_around(const Footprint& polygon) {
    plans::PlanBox box;
    for (const Point p : polygon) box.add(p);
    return box;
}

double depth_of(Point p, const Footprint& footprint) {
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < footprint.size(); ++k) {
        const Point side = footprint[(k + 1) % footprint.size()] - footprint[k];
        const double length = plans::norm(side);
        if (length > 0) least = std::min(least, plans::cross(side, p - footprint[k]) / length);
    }
    return least;
}

}  // namespace enfilade::modeler
