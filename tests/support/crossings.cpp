#include "tests/support/crossings.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace enfilade::testing {
namespace {

using plans::GridPoint;
using plans::Segment;

int side_of(const Segment& s, GridPoint p) {
    const std::int64_t turn = orientation(s.a, s.b, p);
    return (turn > 0) - (turn < 0);
}

bool holds(const Segment& s, GridPoint p) {
    return side_of(s, p) == 0 && std::min(s.a.x, s.b.x) <= p.x && p.x <= std::max(s.a.x, s.b.x) &&
           std::min(s.a.y, s.b.y) <= p.y && p.y <= std::max(s.a.y, s.b.y);
}

bool meet_wrongly(const Segment& s, const Segment& t) {
    if (s.a == t.b || s.a == t.a || s.b == t.a || s.b == t.b) {
        // An end in common: wrong only where the other end of one lies on the other segment as well.
        const bool s_end_shared = s.b == t.a || s.b == t.b, t_end_shared = t.b == s.a || t.b == s.b;
        const GridPoint s_other = s_end_shared ? s.a : s.b, t_other = t_end_shared ? t.a : t.b;
        return holds(t, s_other) || holds(s, t_other);
    }
    const int a = side_of(s, t.a), b = side_of(s, t.b), c = side_of(t, s.a), d = side_of(t, s.b);
    if (a * b < 0 && c * d < 0) return true;
    return holds(s, t.a) || holds(s, t.b) || holds(t, s.a) || holds(t, s.b);
}

}  // namespace

std::optional<std::array<std::size_t, 2>> first_crossing(std::span<const Segment> segments) {
    const auto low = [&](std::size_t k) { return std::min(segments[k].a.x, segments[k].b.x); };
    const auto high = [&](std::size_t k) { return std::max(segments[k].a.x, segments[k].b.x); };
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return low(i) < low(j); });
    std::vector<std::size_t> open;
    for (const std::size_t k : order) {
        const Segment& s = segments[k];
        const std::int32_t bottom = std::min(s.a.y, s.b.y), top = std::max(s.a.y, s.b.y);
        std::size_t kept = 0;
        for (const std::size_t other : open) {
            if (high(other) < low(k)) continue;
            open[kept++] = other;
            const Segment& t = segments[other];
            if (std::max(t.a.y, t.b.y) < bottom || std::min(t.a.y, t.b.y) > top) continue;
            if (meet_wrongly(s, t)) return std::array{std::min(k, other), std::max(k, other)};
        }
        open.resize(kept);
        open.push_back(k);
    }
    return std::nullopt;
}

}  // namespace enfilade::testing
