#include "plans/dxf/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace enfilade::plans::dxf {
namespace {

constexpr unsigned highest_degree = 25;

double distance(Point a, Point b) { return std::hypot(b.x - a.x, b.y - a.y); }

double distance_to_chord(Point p, Point a, Point b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double along = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return distance(p, {a.x + along * dx, a.y + along * dy});
}

double diagonal(std::span<const Point> points) {
    Point low = points.front();
    Point high = low;
    for (const Point p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return distance(low, high);
}

/// A weighted point: x and y are multiplied by w.
struct Weighted {
    double x = 0;
    double y = 0;
    double w = 1;
};

Weighted mixed(Weighted a, Weighted b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, a.w + (b.w - a.w) * t};
}

/// A B-spline curve in the plane, rational where weights differ.
struct Curve {
    unsigned degree = 0;
    std::vector<Weighted> control;
    std::vector<double> knots;

    /// Within knots[span] .. knots[span + 1], by de Boor's recursion.
    [[nodiscard]] Point at(std::size_t span, double t) const {
        std::array<Weighted, highest_degree + 1> d;
        for (unsigned k = 0; k <= degree; ++k) d[k] = control[span - degree + k];
        for (unsigned round = 1; round <= degree; ++round)
            for (unsigned k = degree; k >= round; --k) {
                const double low = knots[span - degree + k];
                const double high = knots[span + 1 + k - round];
                d[k] = mixed(d[k - 1], d[k], high > low ? (t - low) / (high - low) : 0.0);
            }
        return {d[degree].x / d[degree].w, d[degree].y / d[degree].w};
    }
};

/// Halves a piece of the curve until its chord is near enough at its quarters; `out` gets all points but the first.
class Flattener {
public:
    Flattener(const Curve& curve, double tolerance, std::vector<Point>& out)
        : curve_(curve), tolerance_(tolerance), out_(out) {}

    void piece(std::size_t span, double from, double to, Point a, Point b, int depth) {
        const double middle = (from + to) / 2;
        const Point m = curve_.at(span, middle);
        // Degree 2 and more may bend either way within a span: look at three places.
        const bool near = depth > 0 && distance_to_chord(m, a, b) <= tolerance_ &&
                          distance_to_chord(curve_.at(span, (from + middle) / 2), a, b) <= tolerance_ &&
                          distance_to_chord(curve_.at(span, (middle + to) / 2), a, b) <= tolerance_;
        if (near || depth >= 12 || curve_.degree == 1) {
            out_.push_back(b);
            return;
        }
        piece(span, from, middle, a, m, depth + 1);
        piece(span, middle, to, m, b, depth + 1);
    }

private:
    const Curve& curve_;
    double tolerance_;
    std::vector<Point>& out_;
};

std::vector<Point> flattened(const Curve& curve) {
    std::vector<std::size_t> spans;
    std::vector<Point> probes;
    for (std::size_t span = curve.degree; span < curve.control.size(); ++span) {
        const double from = curve.knots[span];
        const double to = curve.knots[span + 1];
        if (!(to > from)) continue;
        spans.push_back(span);
        for (int k = 0; k <= 4; ++k) probes.push_back(curve.at(span, from + (to - from) * k / 4));
    }
    std::vector<Point> out;
    if (spans.empty()) return out;
    Flattener flattener(curve, diagonal(probes) * chord_error / 2, out);
    out.push_back(probes.front());
    for (const std::size_t span : spans) {
        const double to = curve.knots[span + 1];
        flattener.piece(span, curve.knots[span], to, out.back(), curve.at(span, to), 0);
    }
    return out;
}

bool sound(const SplineEntity& spline) {
    const std::size_t n = spline.control.size();
    return spline.degree >= 1 && spline.degree <= highest_degree && n > spline.degree &&
           spline.knots.size() == n + spline.degree + 1 && spline.weights.size() == n &&
           std::is_sorted(spline.knots.begin(), spline.knots.end()) &&
           std::all_of(spline.weights.begin(), spline.weights.end(), [](double w) { return w > 1e-9 && w < 1e9; });
}

/// Solves a symmetric tridiagonal system with `diagonal` and `beside` (between k and k + 1), in place of `right`.
void solve(std::vector<double> diagonal, const std::vector<double>& beside, std::vector<Point>& right) {
    const std::size_t n = right.size();
    for (std::size_t k = 1; k < n; ++k) {
        const double factor = beside[k - 1] / diagonal[k - 1];
        diagonal[k] -= factor * beside[k - 1];
        right[k] = {right[k].x - factor * right[k - 1].x, right[k].y - factor * right[k - 1].y};
    }
    for (std::size_t k = n; k-- > 0;) {
        if (k + 1 < n) right[k] = {right[k].x - beside[k] * right[k + 1].x, right[k].y - beside[k] * right[k + 1].y};
        right[k] = {right[k].x / diagonal[k], right[k].y / diagonal[k]};
    }
}

/// Second derivatives at the points of the cubic spline through them, of chord length: natural ends, or ends along
/// given tangents (as long as a unit of the parameter makes them).
std::vector<Point> curvatures(std::span<const Point> points, const std::vector<double>& steps, const Point* first,
                              const Point* last) {
    const std::size_t n = points.size();
    std::vector<double> diagonal(n, 1);
    std::vector<double> beside(n, 0);
    std::vector<Point> right(n);
    const auto slope = [&](std::size_t k) {
        return Point{(points[k + 1].x - points[k].x) / steps[k], (points[k + 1].y - points[k].y) / steps[k]};
    };
    for (std::size_t k = 1; k + 1 < n; ++k) {
        const Point before = slope(k - 1);
        const Point behind = slope(k);
        diagonal[k] = 2 * (steps[k - 1] + steps[k]);
        right[k] = {6 * (behind.x - before.x), 6 * (behind.y - before.y)};
    }
    for (std::size_t k = 1; k + 2 < n; ++k) beside[k] = steps[k];
    if (first != nullptr) {
        const Point s = slope(0);
        diagonal[0] = 2 * steps[0];
        beside[0] = steps[0];
        right[0] = {6 * (s.x - first->x), 6 * (s.y - first->y)};
    }
    if (last != nullptr) {
        const Point s = slope(n - 2);
        diagonal[n - 1] = 2 * steps[n - 2];
        beside[n - 2] = steps[n - 2];
        right[n - 1] = {6 * (last->x - s.x), 6 * (last->y - s.y)};
    }
    // A natural end has no curvature: its neighbour's row does not see it, nor it the neighbour.
    solve(std::move(diagonal), beside, right);
    return right;
}

/// One cubic piece as a Bezier curve of the spline's own kind.
void flatten_piece(Point a, Point b, Point bend_a, Point bend_b, double step, double tolerance,
                   std::vector<Point>& out) {
    const auto tangent = [&](double pa, double pb, double ma, double mb, bool at_end) {
        return (pb - pa) / step + (at_end ? (ma + 2 * mb) : -(2 * ma + mb)) * step / 6;
    };
    const auto inner = [&](double pa, double pb, double ma, double mb, bool at_end) {
        const double t = tangent(pa, pb, ma, mb, at_end) * step / 3;
        return at_end ? pb - t : pa + t;
    };
    Curve curve;
    curve.degree = 3;
    curve.control = {{a.x, a.y, 1},
                     {inner(a.x, b.x, bend_a.x, bend_b.x, false), inner(a.y, b.y, bend_a.y, bend_b.y, false), 1},
                     {inner(a.x, b.x, bend_a.x, bend_b.x, true), inner(a.y, b.y, bend_a.y, bend_b.y, true), 1},
                     {b.x, b.y, 1}};
    curve.knots = {0, 0, 0, 0, 1, 1, 1, 1};
    Flattener(curve, tolerance, out).piece(3, 0, 1, a, b, 0);
}

std::vector<Point> through(const SplineEntity& spline, const Transform& map) {
    std::vector<Point> points;
    for (const P3 p : spline.fit) {
        const Point q = flat(map.point(p));
        if (points.empty() || distance(points.back(), q) > 0) points.push_back(q);
    }
    if (points.size() < 3) return points.size() == 2 ? points : std::vector<Point>();
    const bool ring = points.front() == points.back();
    const std::size_t given = points.size();
    // A closed curve has no ends: run on past both, until what happens there no longer matters.
    const std::size_t extra = ring ? 24 : 0;
    if (ring) {
        const std::size_t around = given - 1;
        std::vector<Point> wound;
        for (std::size_t k = 0; k <= around + 2 * extra; ++k)
            wound.push_back(points[(k + around * extra - extra) % around]);
        points = std::move(wound);
    }
    std::vector<double> steps;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) steps.push_back(distance(points[k], points[k + 1]));
    const auto unit = [&](P3 tangent) {
        const Point t = flat(map.vector(tangent));
        const double size = std::hypot(t.x, t.y);
        return size > 0 ? Point{t.x / size, t.y / size} : Point{};
    };
    const Point first = unit(spline.start_tangent);
    const Point last = unit(spline.end_tangent);
    const std::vector<Point> bends = curvatures(points, steps, !ring && first != Point{} ? &first : nullptr,
                                                !ring && last != Point{} ? &last : nullptr);
    const double tolerance = diagonal(points) * chord_error / 2;
    std::vector<Point> out = {points[extra]};
    for (std::size_t k = extra; k + 1 < extra + given; ++k)
        flatten_piece(points[k], points[k + 1], bends[k], bends[k + 1], steps[k], tolerance, out);
    return out;
}

}  // namespace

std::vector<Point> ellipse_chain(Point centre, Point u, Point v, double start, double sweep) {
    // The chord of a parameter step d is at most (1 - cos(d / 2)) of the greater half axis away, which the box of the
    // whole ellipse exceeds; a piece of it may be much smaller than the whole, so its own box is asked.
    const auto at = [&](double t) {
        return Point{centre.x + u.x * std::cos(t) + v.x * std::sin(t),
                     centre.y + u.y * std::cos(t) + v.y * std::sin(t)};
    };
    std::array<Point, 17> probes;
    for (std::size_t k = 0; k < probes.size(); ++k) probes[k] = at(start + sweep * static_cast<double>(k) / 16);
    const double greater = std::sqrt(u.x * u.x + u.y * u.y + v.x * v.x + v.y * v.y);
    const double share = greater > 0 ? std::min(1.0, chord_error * diagonal(probes) / greater) : 1.0;
    const double step = std::max(2 * std::acos(1 - share), 1e-3);
    const bool full = std::abs(sweep) >= 2 * std::numbers::pi;
    int count = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / step)));
    if (full) count = (count + 3) / 4 * 4;  // the ends of the axes are among the points
    std::vector<Point> out;
    out.reserve(static_cast<std::size_t>(count) + 1);
    for (int k = 0; k <= count; ++k) out.push_back(at(start + sweep * k / count));
    if (full) out.back() = out.front();
    return out;
}

std::vector<Point> spline_chain(const SplineEntity& spline, const Transform& map) {
    if (spline.control.empty() || !sound(spline)) return through(spline, map);
    Curve curve;
    curve.degree = spline.degree;
    curve.knots = spline.knots;
    for (std::size_t k = 0; k < spline.control.size(); ++k) {
        const Point p = flat(map.point(spline.control[k]));
        const double w = spline.weights[k];
        curve.control.push_back({p.x * w, p.y * w, w});
    }
    return flattened(curve);
}

}  // namespace enfilade::plans::dxf
