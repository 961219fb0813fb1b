#include "accel/beam_limit.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace enfilade::accel {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t most_widenings = 4;

PlanPoint direction(const PlanLine& line) { return {line.to.x - line.from.x, line.to.y - line.from.y}; }
std::int64_t cross_of(const PlanPoint& a, const PlanPoint& b) { return a.x * b.y - a.y * b.x; }
std::int64_t dot_of(const PlanPoint& a, const PlanPoint& b) { return a.x * b.x + a.y * b.y; }

bool holds(const Interval& outer, const Interval& inner) { return outer.low <= inner.low && inner.high <= outer.high; }
Interval hull(const Interval& a, const Interval& b) { return {std::min(a.low, b.low), std::max(a.high, b.high)}; }

/// Whether what the second bound leaves of the plan behind their gate is left by the first, too; the first one passes
/// through the end of the gate. side as in beam_plan.cpp.
bool bounds_less(int side, const PlanLine& outer, const PlanLine& inner) {
    if (!outer.exists()) return true;
    if (!inner.exists()) return false;
    const PlanPoint a = direction(outer), b = direction(inner);
    const std::int64_t c = side * cross_of(a, b);
    return c < 0 || (c == 0 && dot_of(a, b) > 0);
}

/// The line through the end of a gate (the corner of the square around it, with a margin) in a direction.
PlanLine through_end(int side, const PlanPoint& end, const PlanPoint& along, bool is_gate, std::int64_t margin) {
    const std::int64_t out_x = along.y < 0 ? side : -side, out_y = along.x < 0 ? -side : side;
    const PlanPoint from = {end.x + margin * out_x, end.y + margin * out_y};
    return {from, {from.x + along.x, from.y + along.y}, is_gate};
}

/// The bound that leaves what either of the two leaves, through `end`, the end of the gate on its own side.
PlanLine wider(int side, const PlanLine& a, const PlanLine& b, const PlanPoint& end, const PlanPoint& other,
               std::int64_t margin) {
    if (!a.exists() || !b.exists()) return {};
    const PlanPoint da = direction(a), db = direction(b);
    const std::int64_t c = side * cross_of(da, db);
    // The gate's own line leaves everything.
    if (a.is_gate || b.is_gate || (c == 0 && dot_of(da, db) < 0)) {
        const PlanLine line = through_end(side, end, {end.x - other.x, end.y - other.y}, true, margin);
        return {{2 * line.from.x - line.to.x, 2 * line.from.y - line.to.y}, line.from, true};
    }
    return through_end(side, end, c > 0 ? db : da, false, margin);
}

/// A beam through a gate as one that begins there.
Beam begun_at_gate(Beam beam, const Beam& more, std::int64_t margin) {
    const Gate& gate = beam.gate;
    beam.plan.left = wider(1, beam.plan.left, more.plan.left, gate.left, gate.right, margin);
    beam.plan.right = wider(-1, beam.plan.right, more.plan.right, gate.right, gate.left, margin);
    beam.plan.left_chain = beam.plan.right_chain = UINT32_MAX;
    beam.height.z = hull(beam.height.z, more.height.z);
    beam.height.slope = hull(beam.height.slope, more.height.slope);
    beam.lit = {double(gate.right.x), double(gate.right.y), double(gate.left.x), double(gate.left.y)};
    return beam;
}

bool covers(const Beam& hull, const Beam& beam) {
    return bounds_less(1, hull.plan.left, beam.plan.left) && bounds_less(-1, hull.plan.right, beam.plan.right) &&
           holds(hull.height.z, beam.height.z) && holds(hull.height.slope, beam.height.slope);
}

/// All that gets from the source to the gate if nothing is in between.
std::optional<Beam> unhindered(const Beam& beam, const BeamSource& source, std::int64_t margin, PlanHistory& history) {
    const Interval z = {double(source.z_low), double(source.z_high)};
    Beam whole = beam;
    const std::optional<PlanBeam> plan = cross(source, {}, beam.gate, margin, history);
    if (!plan) return std::nullopt;
    whole.plan = *plan;
    whole.lit = lit_part({}, beam.gate, margin);
    const Interval way = distances(source, whole.lit, margin);
    const std::optional<HeightBeam> height = through_side({z, {-infinity, infinity}}, z, {way, way}, beam.opening);
    if (!height) return std::nullopt;
    whole.height = *height;
    return whole;
}

}  // namespace

BeamLimit::BeamLimit(std::size_t portal_count, std::uint32_t max_beams) : max_beams_(max_beams) {
    if (max_beams_ > 0) place_of_side_.resize(2 * portal_count);
}

BeamLimit::Arrivals& BeamLimit::arrivals_at(std::uint32_t side) {
    // An entry that nobody wrote since `clear` points at nothing, or at another side: no need to wipe them.
    std::uint32_t& place = place_of_side_[side];
    if (place >= arrivals_.size() || arrivals_[place].side != side) {
        place = static_cast<std::uint32_t>(arrivals_.size());
        arrivals_.push_back({side});
    }
    return arrivals_[place];
}

bool BeamLimit::admit(BeamStep& step, bool is_front, const BeamSource& source, std::int64_t margin,
                      PlanHistory& history) {
    if (max_beams_ == 0) return true;
    Arrivals& arrivals = arrivals_at(static_cast<std::uint32_t>(2 * index(step.portal) + (is_front ? 0 : 1)));
    if (arrivals.is_whole) return false;
    Beam& beam = step.beam;
    if (step.is_level) {
        if (++arrivals.count <= max_beams_) return true;
        // Beams over one floor may have come by different gates: what they have in common is their source.
        const bool goes_down = beam.height.slope.high <= 0;
        beam = {};
        beam.height = {{double(source.z_low), double(source.z_high)},
                       {goes_down ? -infinity : 0, goes_down ? 0 : infinity}};
        return arrivals.is_whole = step.is_widened = true;
    }
    if (arrivals.widened > 0 && covers(arrivals.hull, beam)) return false;
    if (++arrivals.count <= max_beams_) return true;
    arrivals.hull = begun_at_gate(arrivals.widened == 0 ? beam : arrivals.hull, beam, margin);
    step.is_widened = true;
    beam = arrivals.hull;
    if (++arrivals.widened >= most_widenings) {
        const std::optional<Beam> whole = unhindered(beam, source, margin, history);
        if (whole) beam = *whole;
        arrivals.is_whole = true;
        return whole.has_value();
    }
    beam.plan.left_chain = history.add(UINT32_MAX, beam.gate.left, beam.gate.right, -1);
    beam.plan.right_chain = history.add(UINT32_MAX, beam.gate.right, beam.gate.left, 1);
    return true;
}

}  // namespace enfilade::accel
