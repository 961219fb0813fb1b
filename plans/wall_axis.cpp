#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/outline.h"
#include "plans/vector2.h"

namespace enfilade::plans {

WallAxis::WallAxis(Point start, Point end, double extent, double flat) : start_(start), end_(end), extent_(extent) {
    const double chord = distance(start, end);
    length_ = chord;
    if (chord / 2 * std::abs(std::tan(extent / 4)) < flat) extent_ = 0;
    if (extent_ == 0) return;
    radius_ = chord / (2 * std::sin(std::abs(extent_) / 2));
    length_ = radius_ * std::abs(extent_);
    // Left of the chord for arcs of less than half a turn to the left; the tangent's sign covers the others.
    const Point left = turned_left(end - start) * (1 / chord);
    centre_ = (start + end) * 0.5 + left * (chord / 2 / std::tan(extent_ / 2));
}

Point WallAxis::at(double t) const {
    if (t == 0) return start_;
    if (t == 1) return end_;
    if (straight()) return start_ + (end_ - start_) * t;
    const double angle = extent_ * t;
    const Point arm = start_ - centre_;
    return centre_ + arm * std::cos(angle) + turned_left(arm) * std::sin(angle);
}

Point WallAxis::normal(double t) const {
    if (straight()) return turned_left(end_ - start_) * (1 / length_);
    return (centre_ - at(t)) * ((extent_ > 0 ? 1 : -1) / radius_);
}

Point WallAxis::offset(double t, double d) const {
    if (!straight()) d = extent_ > 0 ? std::min(d, radius_) : std::max(d, -radius_);
    return at(t) + normal(t) * d;
}

double WallAxis::nearest(Point p) const {
    if (straight()) return std::clamp(dot(p - start_, end_ - start_) / (length_ * length_), 0.0, 1.0);
    const Point arm = start_ - centre_;
    const Point to = p - centre_;
    double angle = std::atan2(cross(arm, to), dot(arm, to));
    if (extent_ < 0) angle = -angle;
    const double sweep = std::abs(extent_);
    // Angles beyond the end belong to the end that is nearer around the circle.
    if (angle < (sweep - 2 * std::numbers::pi) / 2) angle += 2 * std::numbers::pi;
    return std::clamp(angle / sweep, 0.0, 1.0);
}

}  // namespace enfilade::plans
