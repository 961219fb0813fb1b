#include "accel/beam_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade::accel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double few_roundings = 0x1p-49;

/// v, moved by a few roundings of numbers as large as `scale`.
double above(double v, double scale) { return v + few_roundings * std::abs(scale); }
double below(double v, double scale) { return v - few_roundings * std::abs(scale); }

/// The most that slope * way can be, and the least. Ways are not negative.
double most_rise(double slope, const Interval& way) {
    const double w = slope > 0 ? way.high : way.low;
    return w == 0 || slope == 0 ? 0 : above(slope * w, slope * w);
}
double least_rise(double slope, const Interval& way) { return -most_rise(-slope, way); }

/// The steepest and the flattest that rise / way can be.
double most_slope(double rise, const Interval& way) {
    const double w = rise >= 0 ? way.low : way.high;
    if (w <= 0) return infinity;
    return rise == 0 ? 0 : above(rise / w, rise / w);
}
double least_slope(double rise, const Interval& way) { return -most_slope(-rise, way); }

/// z + rise, rounded outward where anything is added.
double raised(double z, double rise) { return rise == 0 ? z : above(z + rise, std::abs(z) + std::abs(rise)); }
double lowered(double z, double rise) { return rise == 0 ? z : below(z + rise, std::abs(z) + std::abs(rise)); }

struct RealPoint {
    double x, y;
};

double distance(const RealPoint& a, const RealPoint& b) { return std::hypot(b.x - a.x, b.y - a.y); }

double distance(const RealPoint& p, const RealPoint& a, const RealPoint& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return distance(p, {a.x + t * dx, a.y + t * dy});
}

double cross_of(const RealPoint& a, const RealPoint& b, const RealPoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

bool intersect(const RealPoint& a, const RealPoint& b, const RealPoint& c, const RealPoint& d) {
    const bool splits_cd = (cross_of(a, b, c) > 0) != (cross_of(a, b, d) > 0);
    const bool splits_ab = (cross_of(c, d, a) > 0) != (cross_of(c, d, b) > 0);
    return splits_cd && splits_ab;
}

double least_distance(const RealPoint& a, const RealPoint& b, const RealPoint& c, const RealPoint& d) {
    if (intersect(a, b, c, d)) return 0;
    return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

/// Rounded outward; what was computed from coordinates below 2^26 is wrong by less than 2^-20.
Interval outward(double least, double most) {
    return {std::max(0.0, below(least, least) - 0x1p-20), above(most, most) + 0x1p-20};
}

RealPoint real(const PlanPoint& p) { return {double(p.x), double(p.y)}; }

}  // namespace

RealSegment lit_part(const PlanBeam& beam, const Gate& gate, std::int64_t margin) {
    double from = 0, to = 1;  // from the gate's right end to its left
    const auto zero = [](double a, double b) { return a / (a - b); };
    if (beam.left.exists()) {
        const auto r = double(beam.left.side(gate.right)), l = double(beam.left.side(gate.left));
        if (r < 0 && l > 0) to = zero(r, l);
    }
    if (beam.right.exists()) {
        const auto r = double(beam.right.side(gate.right)), l = double(beam.right.side(gate.left));
        if (r < 0 && l > 0) from = zero(r, l);
    }
    const double dx = double(gate.left.x - gate.right.x), dy = double(gate.left.y - gate.right.y);
    const double spare = 0x1p-44 + 2 * double(margin) / std::max(std::abs(dx), std::abs(dy));
    from = std::max(from - spare, 0.0);
    to = std::min(to + spare, 1.0);
    const double x = double(gate.right.x), y = double(gate.right.y);
    return {x + from * dx, y + from * dy, x + to * dx, y + to * dy};
}

Interval distances(const BeamSource& source, const RealSegment& s, std::int64_t margin) {
    const RealPoint a{s.x0, s.y0}, b{s.x1, s.y1};
    double least = infinity, most = 0;
    const std::size_t count = source.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const RealPoint p = real(source.corners[i]), q = real(source.corners[(i + 1) % count]);
        least = std::min(least, least_distance(p, q, a, b));
        most = std::max({most, distance(p, a), distance(p, b)});
    }
    return outward(least - 3 * double(margin), most + 3 * double(margin));
}

Interval distances(const RealSegment& s, const RealSegment& t, std::int64_t margin) {
    const RealPoint a{s.x0, s.y0}, b{s.x1, s.y1}, c{t.x0, t.y0}, d{t.x1, t.y1};
    const double most = std::max({distance(a, c), distance(a, d), distance(b, c), distance(b, d)});
    return outward(least_distance(a, b, c, d) - 3 * double(margin), most + 3 * double(margin));
}

double farthest(const BeamSource& source, const std::vector<PlanPoint>& corners) {
    double most = 0;
    for (const PlanPoint& s : source.corners)
        for (const PlanPoint& p : corners) most = std::max(most, distance(real(s), real(p)));
    return outward(0, most).high;
}

double farthest(const RealSegment& s, const std::vector<PlanPoint>& corners) {
    double most = 0;
    for (const PlanPoint& p : corners)
        most = std::max({most, distance({s.x0, s.y0}, real(p)), distance({s.x1, s.y1}, real(p))});
    return outward(0, most).high;
}

std::optional<HeightBeam> through_side(const HeightBeam& beam, const Interval& source_z, const Ways& ways,
                                       const Interval& opening) {
    Interval z = {lowered(beam.z.low, least_rise(beam.slope.low, ways.from_reference)),
                  raised(beam.z.high, most_rise(beam.slope.high, ways.from_reference))};
    z.low = std::max(z.low, lowered(source_z.low, least_rise(beam.slope.low, ways.from_source)));
    z.high = std::min(z.high, raised(source_z.high, most_rise(beam.slope.high, ways.from_source)));
    if (!(z.high >= opening.low) || !(z.low < opening.high)) return std::nullopt;
    z = {std::max(z.low, opening.low), std::min(z.high, opening.high)};
    Interval slope = beam.slope;
    slope.high = std::min({slope.high, most_slope(above(z.high - beam.z.low, z.high), ways.from_reference),
                           most_slope(above(z.high - source_z.low, z.high), ways.from_source)});
    slope.low = std::max({slope.low, least_slope(below(z.low - beam.z.high, z.low), ways.from_reference),
                          least_slope(below(z.low - source_z.high, z.low), ways.from_source)});
    if (!(slope.low <= slope.high) || !(z.low <= z.high)) return std::nullopt;
    return HeightBeam{z, slope};
}

std::optional<HeightBeam> through_level(const HeightBeam& beam, const Interval& source_z, const Ways& ways, Level level,
                                        const Interval& z) {
    HeightBeam next = beam;
    if (level == Level::Floor) {
        const double lowest =
            std::max(lowered(beam.z.low, least_rise(std::min(0.0, beam.slope.low), ways.from_reference)),
                     lowered(source_z.low, least_rise(std::min(0.0, beam.slope.low), ways.from_source)));
        if (!(beam.slope.low < 0) || !(lowest < z.high)) return std::nullopt;
        next.slope.high =
            std::min({next.slope.high, 0.0, most_slope(above(z.high - beam.z.low, z.high), ways.from_reference),
                      most_slope(above(z.high - source_z.low, z.high), ways.from_source)});
    } else {
        const double highest =
            std::min(raised(beam.z.high, most_rise(std::max(0.0, beam.slope.high), ways.from_reference)),
                     raised(source_z.high, most_rise(std::max(0.0, beam.slope.high), ways.from_source)));
        if (!(beam.slope.high > 0) || !(highest >= z.low)) return std::nullopt;
        next.slope.low =
            std::max({next.slope.low, 0.0, least_slope(below(z.low - beam.z.high, z.low), ways.from_reference),
                      least_slope(below(z.low - source_z.high, z.low), ways.from_source)});
    }
    if (!(next.slope.low <= next.slope.high)) return std::nullopt;
    return next;
}

}  // namespace enfilade::accel
