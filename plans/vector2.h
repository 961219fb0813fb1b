#pragma once
// The few operations on plan vectors that outlines need.

#include <cmath>

#include "plans/plan.h"

namespace enfilade::plans {

constexpr Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
constexpr Point operator*(Point a, double s) { return {a.x * s, a.y * s}; }
constexpr double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
constexpr Point turned_left(Point a) { return {-a.y, a.x}; }
inline double norm(Point a) { return std::hypot(a.x, a.y); }
inline double distance(Point a, Point b) { return norm(b - a); }

/// Distance from p to the segment ab.
inline double distance(Point p, Point a, Point b) {
    const Point d = b - a;
    const double square = dot(d, d);
    if (square == 0) return distance(p, a);
    const double t = std::fmin(1.0, std::fmax(0.0, dot(p - a, d) / square));
    return distance(p, a + d * t);
}

}  // namespace enfilade::plans
