#pragma once
// Stretches of a line, and what is left of one when others are taken.

#include <utility>
#include <vector>

namespace enfilade::plans::dxf {

struct Interval {
    double low = 0;
    double high = 0;
};
using Intervals = std::vector<Interval>;

/// `from` without `taken`, ascending.
[[nodiscard]] inline Intervals without(Interval from, const Intervals& taken) {
    Intervals rest = {from};
    for (const Interval& t : taken) {
        Intervals next;
        for (const Interval& r : rest) {
            if (t.high <= r.low || t.low >= r.high) {
                next.push_back(r);
                continue;
            }
            if (t.low > r.low) next.push_back({r.low, t.low});
            if (t.high < r.high) next.push_back({t.high, r.high});
        }
        rest = std::move(next);
    }
    return rest;
}

}  // namespace enfilade::plans::dxf
