// Random drawings, written by the tests and read back.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numbers>

#include "tests/plans/dxf/dxf_text.h"

namespace enfilade::plans {
namespace {

using namespace dxf_text;

double random_coordinate() { return *rc::gen::inRange(-1'000'000'000, 1'000'000'000) / 8192.0; }
Point random_point() { return {random_coordinate(), random_coordinate()}; }
double random_bulge() { return *rc::gen::inRange(0, 3) == 0 ? *rc::gen::inRange(-4000, 4000) / 1024.0 : 0.0; }

/// A shape as the test knows it, and its text.
struct Written {
    ShapeKind kind;
    std::string layer;
    bool closed = false;
    std::vector<Stroke> strokes;
    std::string text;
};

Written random_line(const std::string& on) {
    const Point a = random_point();
    const Point b = random_point();
    return {ShapeKind::Line, on, false, {{a, b, 0}}, line(a.x, a.y, b.x, b.y, on.c_str())};
}

Written random_polyline(const std::string& on) {
    const bool old = *rc::gen::arbitrary<bool>();
    const bool mirrored = *rc::gen::arbitrary<bool>();
    const int count = *rc::gen::inRange(2, 8);
    Written out = {ShapeKind::Polyline, on, *rc::gen::arbitrary<bool>(), {}, ""};
    std::vector<Point> points;
    std::vector<double> bulges;
    for (int k = 0; k < count; ++k) {
        Point p = random_point();
        while (!points.empty() && (p == points.back() || p == points.front())) p.x += 1;
        points.push_back(p);
        bulges.push_back(random_bulge());
    }
    const std::string extrusion = mirrored ? pairs({{210, 0}, {220, 0}, {230, -1}}) : "";
    if (old) out.text = entity("POLYLINE", {{8, on}, {70, out.closed ? 1 : 0}}) + extrusion;
    else out.text = entity("LWPOLYLINE", {{8, on}, {90, count}, {70, out.closed ? 1 : 0}});
    const double side = mirrored ? -1 : 1;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (old) out.text += entity("VERTEX", {{8, on}});
        out.text += pairs({{10, points[k].x}, {20, points[k].y}, {42, bulges[k]}});
        if (k + 1 == points.size() && !out.closed) break;
        const Point next = points[(k + 1) % points.size()];
        out.strokes.push_back({{side * points[k].x, points[k].y}, {side * next.x, next.y}, side * bulges[k]});
    }
    out.text += old ? entity("SEQEND", {}) : extrusion;
    return out;
}

Written random_arc(const std::string& on) {
    const Point centre = random_point();
    const double r = *rc::gen::inRange(1, 1'000'000) / 1024.0;
    const int start = *rc::gen::inRange(0, 360);
    const int sweep = *rc::gen::inRange(1, 180);
    const auto at = [&](double degrees) {
        const double t = degrees * std::numbers::pi / 180;
        return Point{centre.x + r * std::cos(t), centre.y + r * std::sin(t)};
    };
    return {
        ShapeKind::Arc,
        on,
        false,
        {{at(start), at(start + sweep), std::tan(sweep * std::numbers::pi / 720)}},
        entity("ARC", {{8, on}, {10, centre.x}, {20, centre.y}, {40, r}, {50, start}, {51, (start + sweep) % 360}})};
}

Written random_shape() {
    const std::string on = *rc::gen::element<std::string>("0", "A-WALL", "W\u00E4nde", "x$0$A-DOOR");
    switch (*rc::gen::inRange(0, 3)) {
        case 0: return random_line(on);
        case 1: return random_polyline(on);
        default: return random_arc(on);
    }
}

void check_near(Point got, Point wanted, double tolerance) {
    RC_ASSERT(std::abs(got.x - wanted.x) <= tolerance);
    RC_ASSERT(std::abs(got.y - wanted.y) <= tolerance);
}

RC_GTEST_PROP(DrawingProperty, ReadsBackWhatWasWritten, ()) {
    std::vector<Written> shapes(static_cast<std::size_t>(*rc::gen::inRange(0, 20)));
    std::string entities;
    for (Written& shape : shapes) {
        shape = random_shape();
        entities += shape.text;
    }
    const Drawing drawing = read({entities, "", pairs({{9, "$ACADVER"}, {1, "AC1021"}})});
    RC_ASSERT(drawing.shapes.size() == shapes.size());
    RC_ASSERT(drawing.findings.empty());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const Written& wanted = shapes[k];
        RC_ASSERT(drawing.shapes[k].kind == wanted.kind);
        RC_ASSERT(drawing.layers.at(drawing.shapes[k].layer).name == wanted.layer);
        RC_ASSERT(drawing.shapes[k].closed == wanted.closed);
        const std::vector<Stroke> got = strokes_of(drawing, k);
        RC_ASSERT(got.size() == wanted.strokes.size());
        const double tolerance = wanted.kind == ShapeKind::Arc ? 1e-9 : 0;
        for (std::size_t s = 0; s < got.size(); ++s) {
            check_near(got[s].a, wanted.strokes[s].a, tolerance);
            check_near(got[s].b, wanted.strokes[s].b, tolerance);
            RC_ASSERT(std::abs(got[s].bulge - wanted.strokes[s].bulge) <= tolerance);
        }
    }
}

/// Insertions with whole quarters of a turn and scales that are powers of two: what they do can be said exactly.
RC_GTEST_PROP(DrawingProperty, InsertionsCompose, ()) {
    const int depth = *rc::gen::inRange(1, 5);
    const Point a = random_point();
    const Point b = random_point();
    const double bulge = random_bulge();
    std::string blocks =
        block("B0", entity("LWPOLYLINE", {{8, "0"}, {10, a.x}, {20, a.y}, {42, bulge}, {10, b.x}, {20, b.y}}));
    Point wanted_a = a;
    Point wanted_b = b;
    double side = 1;
    std::string insert;
    for (int k = 0; k < depth; ++k) {
        const Point at = random_point();
        const double scale = *rc::gen::element(0.25, 0.5, 1.0, 2.0);
        const bool mirror_x = *rc::gen::arbitrary<bool>();
        const bool mirror_y = *rc::gen::arbitrary<bool>();
        const bool below = *rc::gen::arbitrary<bool>();
        const int quarters = *rc::gen::inRange(0, 4);
        const auto move = [&](Point p) {
            p = {p.x * (mirror_x ? -scale : scale), p.y * (mirror_y ? -scale : scale)};
            for (int turn = 0; turn < quarters; ++turn) p = {-p.y, p.x};
            p = {p.x + at.x, p.y + at.y};
            return below ? Point{-p.x, p.y} : p;
        };
        wanted_a = move(wanted_a);
        wanted_b = move(wanted_b);
        if (mirror_x != mirror_y) side = -side;
        if (below) side = -side;
        insert = entity("INSERT", {{8, "0"},
                                   {2, "B" + std::to_string(k)},
                                   {10, at.x},
                                   {20, at.y},
                                   {41, mirror_x ? -scale : scale},
                                   {42, mirror_y ? -scale : scale},
                                   {50, quarters * 90}});
        if (below) insert += pairs({{210, 0}, {220, 0}, {230, -1}});
        blocks += block(("B" + std::to_string(k + 1)).c_str(), insert);
    }
    const Drawing drawing = read({insert, blocks});
    RC_PRE(!(a == b));
    const std::vector<Stroke> got = strokes_of(drawing, 0);
    RC_ASSERT(got.size() == 1u);
    check_near(got[0].a, wanted_a, 1e-6);
    check_near(got[0].b, wanted_b, 1e-6);
    RC_ASSERT(got[0].bulge == side * bulge);
    RC_ASSERT(drawing.insertions.size() == static_cast<std::size_t>(depth));
}

}  // namespace
}  // namespace enfilade::plans
