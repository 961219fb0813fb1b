#include "plans/dxf/curved_bodies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plans/dxf/intervals.h"
#include "plans/vector2.h"

namespace enfilade::plans::dxf {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr double same_centre = 0.02;  ///< metres
constexpr double least_length = 0.03;

/// An arc counter-clockwise from its start; angles along it are counted from there.
struct Curve {
    CircleArc arc;
    std::optional<double> height;
    Intervals taken;
};

std::vector<Curve> curves_of(const std::vector<SheetStroke>& strokes) {
    std::vector<Curve> curves;
    for (const SheetStroke& s : strokes) {
        if (s.stroke.bulge == 0 || distance(s.stroke.a, s.stroke.b) < 1e-6) continue;
        CircleArc arc = circle_arc(s.stroke);
        if (arc.sweep < 0) arc.start += arc.sweep, arc.sweep = -arc.sweep;
        curves.push_back({arc, wall_height(s), {}});
    }
    std::stable_sort(curves.begin(), curves.end(),
                     [](const Curve& l, const Curve& r) { return l.arc.centre.x < r.arc.centre.x; });
    return curves;
}

struct CurvePair {
    std::size_t a;
    std::size_t b;
    double thickness;
};

std::vector<CurvePair> pairs_of(const std::vector<Curve>& curves, const PairLimits& limits) {
    std::vector<CurvePair> pairs;
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t j = i + 1; j < curves.size() && curves[j].arc.centre.x - curves[i].arc.centre.x < same_centre;
             ++j) {
            const double t = std::abs(curves[j].arc.radius - curves[i].arc.radius);
            if (t < limits.least || t > limits.most ||
                distance(curves[i].arc.centre, curves[j].arc.centre) > same_centre)
                continue;
            pairs.push_back({i, j, t});
        }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const CurvePair& l, const CurvePair& r) { return l.thickness < r.thickness; });
    return pairs;
}

/// Takes what both arcs share and neither has given away. `shift`: where `b` begins, counted along `a`.
void take_common(Curve& a, Curve& b, double shift, double thickness, WallBodies& bodies) {
    const Interval common = {std::max(0.0, shift), std::min(a.arc.sweep, shift + b.arc.sweep)};
    if (common.high <= common.low) return;
    Intervals taken = a.taken;
    for (const Interval& t : b.taken) taken.push_back({t.low + shift, t.high + shift});
    const double radius = (a.arc.radius + b.arc.radius) / 2;
    for (const Interval& free : without(common, taken)) {
        const double sweep = free.high - free.low;
        if (radius * sweep < least_length) continue;
        a.taken.push_back(free);
        b.taken.push_back({free.low - shift, free.high - shift});
        bodies.paired_length += 2 * radius * sweep;
        bodies.curved.push_back(
            {a.arc.centre, radius, a.arc.start + free.low, sweep, thickness, a.height ? a.height : b.height});
    }
}

}  // namespace

void pair_curved(const std::vector<SheetStroke>& strokes, const PairLimits& limits, WallBodies& bodies) {
    std::vector<Curve> curves = curves_of(strokes);
    for (const Curve& curve : curves) bodies.total_length += curve.arc.radius * curve.arc.sweep;
    for (const CurvePair& pair : pairs_of(curves, limits)) {
        Curve &a = curves[pair.a], &b = curves[pair.b];
        double shift = std::fmod(b.arc.start - a.arc.start, turn);
        if (shift < 0) shift += turn;
        // The second arc may begin behind the first one and still reach around into it.
        for (const double s : {shift, shift - turn}) take_common(a, b, s, pair.thickness, bodies);
    }
}

}  // namespace enfilade::plans::dxf
