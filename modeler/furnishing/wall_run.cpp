#include "modeler/furnishing/wall_run.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {

using plans::Point;

namespace {

constexpr double rounding = 2;  // grid units that a point may lie off its line

Point corner_at(plans::GridPoint p) { return {double(p.x), double(p.y)}; }

/// Whether the run from `a` to `b` goes on to `next` along its line.
bool goes_on(Point a, Point b, Point next) {
    const Point along = next - a, step = next - b;
    const double length = plans::norm(along);
    if (!(length > 0) || plans::dot(step, b - a) <= 0) return false;
    return std::abs(plans::cross(along, b - a)) <= rounding * length;
}

void close(WallRun& run) {
    const Point way = run.b - run.a;
    run.length = plans::norm(way);
    run.along = way * (1 / run.length);
    run.inward = plans::turned_left(run.along);
}

}  // namespace

Point WallRing::at(double s) const {
    s -= std::floor(s / length) * length;
    auto found = std::upper_bound(runs.begin(), runs.end(), s, [](double v, const WallRun& r) { return v < r.start; });
    const WallRun& run = found == runs.begin() ? runs.front() : *(found - 1);
    return run.a + run.along * std::min(s - run.start, run.length);
}

std::vector<WallRing> wall_rings(const RoomShape& room) {
    std::vector<WallRing> rings;
    for (const std::vector<RoomSide>& sides : room.rings) {
        const std::size_t n = sides.size();
        if (n < 3) continue;
        // A run begins where the side before does not lead into it.
        std::size_t start = 0;
        while (start < n &&
               goes_on(corner_at(sides[(start + n - 1) % n].a), corner_at(sides[start].a), corner_at(sides[start].b)))
            ++start;
        if (start == n) start = 0;
        WallRing ring;
        for (std::size_t k = 0; k < n; ++k) {
            const RoomSide& side = sides[(start + k) % n];
            if (side.a == side.b) continue;
            const Point a = corner_at(side.a), b = corner_at(side.b);
            if (ring.runs.empty() || !goes_on(ring.runs.back().a, a, b))
                ring.runs.push_back({a, b, {}, {}, 0, 0, 0, {}, 0});
            WallRun& run = ring.runs.back();
            const double from = plans::distance(run.a, a);
            run.b = b;
            run.spans.push_back({from, plans::distance(run.a, b), side.beyond, side.z_low, side.z_high, side.wall_top});
        }
        for (WallRun& run : ring.runs) {
            close(run);
            run.start = ring.length;
            ring.length += run.length;
        }
        for (std::size_t k = 0; k < ring.runs.size(); ++k) {
            WallRun& run = ring.runs[k];
            WallRun& next = ring.runs[(k + 1) % ring.runs.size()];
            run.turn_after = next.turn_before =
                std::atan2(plans::cross(run.along, next.along), plans::dot(run.along, next.along));
        }
        if (ring.length > 0) rings.push_back(std::move(ring));
    }
    return rings;
}

bool is_backed(const WallRun& run, double from, double to, std::int32_t z_low, std::int32_t z_high) {
    return std::all_of(run.spans.begin(), run.spans.end(), [&](const WallSpan& span) {
        if (span.to <= from || span.from >= to || span.beyond == Beyond::Wall) return true;
        return span.beyond == Beyond::Window && (z_high <= span.z_low || z_low >= span.z_high);
    });
}

}  // namespace enfilade::modeler
