// Ellipses and splines: chains of points on the curve, near enough to it between them.
#include <algorithm>
#include <functional>
#include <numbers>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

double distance_to_chain(Point p, const std::vector<Stroke>& chain) {
    double least = INFINITY;
    for (const Stroke& s : chain) {
        const double dx = s.b.x - s.a.x;
        const double dy = s.b.y - s.a.y;
        const double t = std::clamp(((p.x - s.a.x) * dx + (p.y - s.a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
        least = std::min(least, std::hypot(p.x - s.a.x - t * dx, p.y - s.a.y - t * dy));
    }
    return least;
}

/// The greatest distance of the curve, at 2000 places, from the chain, as a share of the drawing's diagonal.
double error_of(const Drawing& drawing, double from, double to, const std::function<Point(double)>& curve) {
    const std::vector<Stroke> chain = strokes_of(drawing, 0);
    double most = 0;
    for (int k = 0; k <= 2000; ++k)
        most = std::max(most, distance_to_chain(curve(from + (to - from) * k / 2000), chain));
    return most / std::hypot(drawing.bounds[2] - drawing.bounds[0], drawing.bounds[3] - drawing.bounds[1]);
}

void expect_joined(const Drawing& drawing) {
    const std::vector<Stroke> chain = strokes_of(drawing, 0);
    for (std::size_t k = 1; k < chain.size(); ++k) EXPECT_EQ(chain[k - 1].b, chain[k].a);
}

std::string ellipse(double ratio, double from, double to) {
    return entity("ELLIPSE", {{10, 1}, {20, 2}, {11, 3}, {21, 4}, {40, ratio}, {41, from}, {42, to}});
}

TEST(DrawingCurves, WholeEllipse) {
    const Drawing drawing = read_entities(ellipse(0.5, 0, 2 * std::numbers::pi));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Ellipse);
    EXPECT_TRUE(drawing.shapes[0].closed);
    expect_joined(drawing);
    EXPECT_EQ(strokes_of(drawing, 0).front().a, strokes_of(drawing, 0).back().b);
    EXPECT_LE(error_of(drawing, 0, 2 * std::numbers::pi,
                       [](double t) {
                           return Point{1 + 3 * std::cos(t) - 2 * std::sin(t), 2 + 4 * std::cos(t) + 1.5 * std::sin(t)};
                       }),
              1e-4);
}

TEST(DrawingCurves, EllipseReachesTheEndsOfItsAxes) {
    const Drawing drawing = read_entities(entity("ELLIPSE", {{11, 4}, {21, 0}, {40, 0.25}}));
    EXPECT_NEAR(drawing.bounds[0], -4, 1e-12);
    EXPECT_NEAR(drawing.bounds[1], -1, 1e-12);
    EXPECT_NEAR(drawing.bounds[2], 4, 1e-12);
    EXPECT_NEAR(drawing.bounds[3], 1, 1e-12);
}

TEST(DrawingCurves, SmallPieceOfAnEllipseIsAsNear) {
    const Drawing drawing = read_entities(ellipse(0.1, 6.2, 6.4));
    EXPECT_FALSE(drawing.shapes.at(0).closed);
    EXPECT_LE(
        error_of(drawing, 6.2, 6.4,
                 [](double t) {
                     return Point{1 + 3 * std::cos(t) - 0.4 * std::sin(t), 2 + 4 * std::cos(t) + 0.3 * std::sin(t)};
                 }),
        1e-4);
}

TEST(DrawingCurves, EllipseThatIsACircleIsDrawnAsArcs) {
    const Drawing drawing =
        read_entities(entity("ELLIPSE", {{11, 2}, {21, 0}, {40, 1}}) +
                      entity("ELLIPSE", {{11, 2}, {21, 0}, {40, 1}, {41, 0}, {42, std::numbers::pi / 2}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Circle);
    expect_strokes(drawing, 0, {{{2, 0}, {-2, 0}, 1}, {{-2, 0}, {2, 0}, 1}});
    EXPECT_EQ(drawing.shapes.at(1).kind, ShapeKind::Arc);
    expect_strokes(drawing, 1, {{{2, 0}, {0, 2}, std::tan(std::numbers::pi / 8)}});
}

TEST(DrawingCurves, EllipseTurnsWithItsExtrusion) {
    // Seen from below the parameter runs clockwise: a quarter ends at -2 on the minor axis.
    const Drawing drawing = read_entities(entity(
        "ELLIPSE", {{11, 4}, {21, 0}, {40, 0.5}, {41, 0}, {42, std::numbers::pi / 2}, {210, 0}, {220, 0}, {230, -1}}));
    expect_point(strokes_of(drawing, 0).front().a, {4, 0});
    expect_point(strokes_of(drawing, 0).back().b, {0, -2});
}

TEST(DrawingCurves, SplineIsItsParabola) {
    const Drawing drawing = read_entities(entity("SPLINE", {{70, 8},
                                                            {71, 2},
                                                            {40, 0},
                                                            {40, 0},
                                                            {40, 0},
                                                            {40, 1},
                                                            {40, 1},
                                                            {40, 1},
                                                            {10, 0},
                                                            {20, 0},
                                                            {10, 2},
                                                            {20, 4},
                                                            {10, 4},
                                                            {20, 0}}));
    EXPECT_EQ(drawing.shapes.at(0).kind, ShapeKind::Spline);
    expect_joined(drawing);
    expect_point(strokes_of(drawing, 0).front().a, {0, 0});
    expect_point(strokes_of(drawing, 0).back().b, {4, 0});
    EXPECT_LE(error_of(drawing, 0, 1, [](double t) { return Point{4 * t, 8 * t * (1 - t)}; }), 1e-4);
    for (const Stroke& s : strokes_of(drawing, 0)) EXPECT_NEAR(s.a.y, s.a.x * (4 - s.a.x) / 2, 1e-12);
}

TEST(DrawingCurves, RationalSplineIsItsQuarterCircle) {
    const Drawing drawing = read_entities(entity("SPLINE", {{70, 12},
                                                            {71, 2},
                                                            {72, 99},
                                                            {73, 99},
                                                            {40, 0},
                                                            {40, 0},
                                                            {40, 0},
                                                            {40, 1},
                                                            {40, 1},
                                                            {40, 1},
                                                            {41, 1},
                                                            {41, std::sqrt(0.5)},
                                                            {41, 1},
                                                            {10, 1},
                                                            {20, 0},
                                                            {10, 1},
                                                            {20, 1},
                                                            {10, 0},
                                                            {20, 1}}));
    for (const Stroke& s : strokes_of(drawing, 0)) EXPECT_NEAR(std::hypot(s.b.x, s.b.y), 1, 1e-12);
    EXPECT_LE(error_of(drawing, 0, std::numbers::pi / 2,
                       [](double t) {
                           return Point{std::cos(t), std::sin(t)};
                       }),
              1e-4);
}

TEST(DrawingCurves, CubicSplineOfSeveralSpans) {
    // Uniform knots: at knot 3 the curve is a sixth of its neighbours and two thirds of the point between.
    std::string text = pairs({{0, "SPLINE"}, {71, 3}});
    for (int k = 0; k < 10; ++k) text += pair(40, k);
    const std::vector<Point> control = {{0, 0}, {1, 3}, {2, -3}, {3, 5}, {4, 0}, {6, 1}};
    for (const Point p : control) text += pair(10, p.x) + pair(20, p.y);
    const Drawing drawing = read_entities(text);
    expect_point(strokes_of(drawing, 0).front().a, {1, (0 + 4 * 3 - 3) / 6.0});
    expect_point(strokes_of(drawing, 0).back().b, {(3 + 4 * 4 + 6) / 6.0, (5 + 4 * 0 + 1) / 6.0});
    const auto curve = [&](double t) {
        const int span = std::min(static_cast<int>(t), 2);
        const double u = t - span;
        const double w[] = {(1 - u) * (1 - u) * (1 - u) / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                            (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
        Point p;
        for (int k = 0; k < 4; ++k) {
            p.x += w[k] * control[static_cast<std::size_t>(span + k)].x;
            p.y += w[k] * control[static_cast<std::size_t>(span + k)].y;
        }
        return p;
    };
    EXPECT_LE(error_of(drawing, 0, 3, curve), 1e-4);
}

TEST(DrawingCurves, SplineOfDegreeOneIsItsPoints) {
    const Drawing drawing = read_entities(entity(
        "SPLINE",
        {{71, 1}, {40, 0}, {40, 0}, {40, 1}, {40, 2}, {40, 2}, {10, 0}, {20, 0}, {10, 1}, {20, 5}, {10, 2}, {20, 0}}));
    expect_strokes(drawing, 0, {{{0, 0}, {1, 5}, 0}, {{1, 5}, {2, 0}, 0}});
}

TEST(DrawingCurves, SplineThroughPoints) {
    std::string text = pairs({{0, "SPLINE"}, {71, 3}});
    const std::vector<Point> fit = {{0, 0}, {1, 2}, {3, 1}, {4, 4}};
    for (const Point p : fit) text += pair(11, p.x) + pair(21, p.y);
    const Drawing drawing = read_entities(text);
    const std::vector<Stroke> chain = strokes_of(drawing, 0);
    expect_joined(drawing);
    EXPECT_EQ(chain.front().a, fit.front());
    EXPECT_EQ(chain.back().b, fit.back());
    for (const Point p : fit) EXPECT_LE(distance_to_chain(p, chain), 1e-12);
    // Smooth: no corner of more than a few degrees.
    for (std::size_t k = 1; k < chain.size(); ++k) {
        const Point a = {chain[k - 1].b.x - chain[k - 1].a.x, chain[k - 1].b.y - chain[k - 1].a.y};
        const Point b = {chain[k].b.x - chain[k].a.x, chain[k].b.y - chain[k].a.y};
        EXPECT_LT(std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y)), 0.15);
    }
}

TEST(DrawingCurves, SplineThroughPointsOfALineIsStraight) {
    std::string text = pairs({{0, "SPLINE"}, {71, 3}});
    for (const double t : {0.0, 1.0, 1.5, 4.0}) text += pair(11, 2 * t) + pair(21, t);
    for (const Stroke& s : strokes_of(read_entities(text), 0)) EXPECT_NEAR(s.b.x, 2 * s.b.y, 1e-12);
}

TEST(DrawingCurves, SplineThroughPointsObeysItsTangents) {
    const Drawing drawing = read_entities(
        entity("SPLINE",
               {{71, 3}, {12, 0}, {22, 1}, {13, 0}, {23, -1}, {11, 0}, {21, 0}, {11, 1}, {21, 1}, {11, 2}, {21, 0}}));
    const Stroke first = strokes_of(drawing, 0).front();
    const Stroke last = strokes_of(drawing, 0).back();
    EXPECT_LT(std::abs(first.b.x - first.a.x), 0.1 * (first.b.y - first.a.y));
    EXPECT_LT(std::abs(last.b.x - last.a.x), 0.1 * (last.a.y - last.b.y));
}

TEST(DrawingCurves, ClosedSplineThroughPointsIsRound) {
    std::string text = pairs({{0, "SPLINE"}, {70, 1}, {71, 3}});
    for (int k = 0; k <= 12; ++k) {
        const double t = (k % 12) * std::numbers::pi / 6;
        text += pair(11, std::cos(t)) + pair(21, std::sin(t));
    }
    const Drawing drawing = read_entities(text);
    EXPECT_TRUE(drawing.shapes.at(0).closed);
    for (const Stroke& s : strokes_of(drawing, 0)) EXPECT_NEAR(std::hypot(s.a.x, s.a.y), 1, 1e-3);
}

TEST(DrawingCurves, SplineWithoutACurveIsReported) {
    const char* const cases[] = {"too few control points", "falling knots", "knots missing", "weight 0"};
    const std::string texts[] = {
        entity("SPLINE", {{71, 3}, {40, 0}, {40, 0}, {40, 1}, {40, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 1}}),
        entity("SPLINE", {{71, 1}, {40, 0}, {40, 2}, {40, 1}, {40, 3}, {10, 0}, {20, 0}, {10, 1}, {20, 1}}),
        entity("SPLINE", {{71, 1}, {40, 0}, {10, 0}, {20, 0}, {10, 1}, {20, 1}}),
        entity("SPLINE",
               {{71, 1}, {40, 0}, {40, 0}, {40, 1}, {40, 1}, {41, 0}, {41, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 1}})};
    for (int k = 0; k < 4; ++k) {
        const Drawing drawing = read_entities(texts[k] + line(0, 0, 1, 1));
        EXPECT_EQ(drawing.shapes.size(), 1u) << cases[k];
        EXPECT_NE(finding_of(drawing, "P712"), nullptr) << cases[k];
    }
}

TEST(DrawingCurves, SplineDoesNotInheritFromTheOneBefore) {
    const Drawing drawing = read_entities(
        entity("SPLINE", {{71, 1}, {40, 0}, {40, 0}, {40, 1}, {40, 1}, {10, 0}, {20, 0}, {10, 1}, {20, 1}}) +
        entity("SPLINE", {{71, 1}, {11, 5}, {21, 5}, {11, 6}, {21, 5}}));
    expect_strokes(drawing, 1, {{{5, 5}, {6, 5}, 0}}, 0);
}

}  // namespace
}  // namespace enfilade::plans
