#include "accel/beam_plan.h"

#include <cstdlib>

namespace enfilade::accel {
namespace {

constexpr std::uint32_t no_end = UINT32_MAX;

/// A bound of a beam is written down once, for the left: the line that turns most to the left. It passes first by
/// something on its left ("near": the source, or the right end of a gate), then by the left end of a later gate
/// ("far"). Every line of the beam meets the near thing left of the bound and the far gate right of it, so it stays on
/// the right: this is why a bound is sound, whatever gates come between. The right bound is its mirror image, side -1.

std::int64_t turn(int side, const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
    return side * accel::turn(a, b, c);
}

int sign(std::int64_t v) { return v < 0 ? -1 : 1; }

/// By how much `side()` may change when its point moves by the margin along x and y.
std::int64_t slack(const PlanLine& line, std::int64_t margin) {
    return margin * (std::abs(line.to.x - line.from.x) + std::abs(line.to.y - line.from.y));
}

bool is_near(const PlanPoint& a, const PlanPoint& b, std::int64_t distance) {
    return std::abs(a.x - b.x) <= distance && std::abs(a.y - b.y) <= distance;
}

/// The line that keeps the square of half-width near_margin around `near` on its left, that around `far` on its right,
/// and touches both: the line from near to far, turned left. Nothing where the squares are too near to tell.
std::optional<PlanLine> bitangent(int side, const PlanPoint& near, std::int64_t near_margin, const PlanPoint& far,
                                  std::int64_t far_margin) {
    if (is_near(near, far, near_margin + far_margin)) return std::nullopt;
    PlanLine line{near, far};
    if (near_margin + far_margin == 0) return line;
    for (int round = 0; round < 4; ++round) {
        // Which corners are touched depends on the direction, and that on the corners: it settles after a round or two.
        const std::int64_t to_x = side * sign(line.to.y - line.from.y), to_y = -side * sign(line.to.x - line.from.x);
        line.from = {near.x + near_margin * to_x, near.y + near_margin * to_y};
        line.to = {far.x - far_margin * to_x, far.y - far_margin * to_y};
        if (side * line.side(near) >= slack(line, near_margin) && side * line.side(far) <= -slack(line, far_margin))
            return line;
    }
    return std::nullopt;
}

/// The corner of the source that lies farthest on the right as seen from `far`. \pre !source.holds(far)
PlanPoint rightmost(int side, const BeamSource& source, const PlanPoint& far) {
    PlanPoint best = source.corners[0];
    for (const PlanPoint& corner : source.corners)
        if (turn(side, best, far, corner) < 0) best = corner;
    return best;
}

/// The gate's own line, moved by the margin to where the rays come from. Rays cross it outward, so they stay beyond it.
PlanLine own_line(int side, const PlanPoint& own, const PlanPoint& far, std::int64_t margin) {
    const std::int64_t out_x = -side * margin * sign(far.y - own.y), out_y = side * margin * sign(far.x - own.x);
    return {{own.x + out_x, own.y + out_y}, {far.x + out_x, far.y + out_y}, true};
}

/// What turns a line through `far` least to the left of all that it must have on its left: the gate's own other end,
/// the source, or the near end of a gate crossed before.
struct Near {
    PlanPoint at;
    std::int64_t margin = 0;
    enum class Kind { Own, Source, Gate } kind = Kind::Own;
    PlanPoint other = {};  ///< of a gate crossed before
};

Near nearest_bound(int side, const BeamSource& source, const PlanPoint& far, const PlanPoint& own, std::uint32_t chain,
                   std::int64_t margin, const PlanHistory& history) {
    Near near{own, margin, Near::Kind::Own, {}};
    if (!source.holds(far)) {
        const PlanPoint s = rightmost(side, source, far);
        if (!is_near(s, far, margin) && turn(side, near.at, far, s) > 0) near = {s, 0, Near::Kind::Source, {}};
    }
    std::uint32_t best = no_end;
    for (std::uint32_t k = chain; k != no_end; k = history[k].before) {
        if (is_near(history[k].at, far, 2 * margin)) continue;
        if (best != no_end && turn(side, history[best].at, far, history[k].at) <= 0) break;
        best = k;
    }
    if (best == no_end) return near;
    const PlanHistory::End& end = history[best];
    if (turn(side, near.at, far, end.at) > 0) near = {end.at, margin, Near::Kind::Gate, end.other};
    return near;
}

/// Whether the line is a bound: the near thing lies on its left, the far gate on its right, as a whole.
bool parts(int side, const PlanLine& line, const BeamSource& source, const Near& near, const PlanPoint& own,
           std::int64_t margin) {
    const std::int64_t room = slack(line, margin);
    if (side * line.side(own) > -room) return false;
    if (near.kind == Near::Kind::Gate) return side * line.side(near.other) >= room;
    for (const PlanPoint& corner : source.corners)
        if (side * line.side(corner) < 0) return false;
    return true;
}

/// The bound of before.
PlanLine kept(PlanLine bound) {
    bound.is_gate = false;
    return bound;
}

/// The bound behind a gate that is reached.
PlanLine narrowed(int side, const BeamSource& source, const PlanLine& bound, const PlanPoint& own, const PlanPoint& far,
                  std::uint32_t chain, std::int64_t margin, const PlanHistory& history) {
    // The gate's end lies on the bound or outside it: nothing changes.
    if (bound.exists() && side * bound.side(far) >= -slack(bound, margin)) return kept(bound);
    const Near near = nearest_bound(side, source, far, own, chain, margin, history);
    if (near.kind == Near::Kind::Own) return own_line(side, own, far, margin);
    const std::optional<PlanLine> line = bitangent(side, near.at, near.margin, far, margin);
    if (line && parts(side, *line, source, near, own, margin)) return *line;
    if (!bound.exists()) return own_line(side, own, far, margin);
    return kept(bound);
}

/// Whether the bound leaves something of a gate: the end on the bound's far side lies inside. On the bound counts where
/// the beam starts at that end; and where the bound is the line of the gate before, behind that gate: sides of the cell
/// begin there, on the line or as near as rounding to the grid has bent it, and the beam's other bound decides.
bool is_inside(int side, const BeamSource& source, const PlanLine& bound, const PlanPoint& end, std::int64_t margin) {
    if (!bound.exists()) return true;
    const std::int64_t s = side * bound.side(end) - slack(bound, margin);
    if (s < 0 || (s == 0 && source.holds(end))) return true;
    if (!bound.is_gate) return false;
    const PlanPoint along = {bound.to.x - bound.from.x, bound.to.y - bound.from.y};
    const PlanPoint way = {end.x - bound.from.x, end.y - bound.from.y};
    // Both ends of the gate and this one lie within a unit of where they were: two units and their leverage.
    const std::int64_t bend = 2 * (std::abs(along.x) + std::abs(along.y) + std::abs(way.x) + std::abs(way.y));
    return s <= bend && way.x * along.x + way.y * along.y <= slack(bound, margin);
}

/// Whether rays from the source can cross the gate's line at all: from inside, or from the gate itself.
bool faces(const BeamSource& source, const Gate& gate, std::int64_t margin) {
    const PlanLine line{gate.right, gate.left};
    for (const PlanPoint& corner : source.corners)
        if (line.side(corner) > -slack(line, margin)) return true;
    for (const PlanPoint& corner : source.corners) {
        if (line.side(corner) != 0) continue;
        const std::int64_t dx = gate.left.x - gate.right.x, dy = gate.left.y - gate.right.y;
        const std::int64_t along = (corner.x - gate.right.x) * dx + (corner.y - gate.right.y) * dy;
        if (along >= 0 && along <= dx * dx + dy * dy) return true;
    }
    return source.holds(gate.left) || source.holds(gate.right);
}

}  // namespace

std::uint32_t PlanHistory::add(std::uint32_t chain, const PlanPoint& at, const PlanPoint& other, int side) {
    // An end is kept while it stands out to the side of the beam, before the line from the end before it to the new
    // one.
    while (chain != no_end && ends_[chain].before != no_end &&
           turn(side, ends_[ends_[chain].before].at, at, ends_[chain].at) <= 0)
        chain = ends_[chain].before;
    ends_.push_back({at, other, chain});
    return static_cast<std::uint32_t>(ends_.size() - 1);
}

std::optional<PlanBeam> cross(const BeamSource& source, const PlanBeam& beam, const Gate& gate, std::int64_t margin,
                              PlanHistory& history) {
    if (!is_inside(1, source, beam.left, gate.right, margin) || !is_inside(-1, source, beam.right, gate.left, margin))
        return std::nullopt;
    if (!beam.left.exists() && !beam.right.exists() && !faces(source, gate, margin)) return std::nullopt;
    PlanBeam next;
    next.left = narrowed(1, source, beam.left, gate.right, gate.left, beam.right_chain, margin, history);
    next.right = narrowed(-1, source, beam.right, gate.left, gate.right, beam.left_chain, margin, history);
    next.right_chain = history.add(beam.right_chain, gate.right, gate.left, 1);
    next.left_chain = history.add(beam.left_chain, gate.left, gate.right, -1);
    return next;
}

}  // namespace enfilade::accel
