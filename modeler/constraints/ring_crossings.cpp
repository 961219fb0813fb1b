#include "modeler/constraints/ring_crossings.h"

#include <algorithm>

#include "modeler/constraints/box_pairs.h"

namespace enfilade::modeler {
namespace {

using plans::GridPoint;

constexpr std::size_t few = 24;  ///< edges of which all pairs are looked at: a tree would cost more

int turn(GridPoint a, GridPoint b, GridPoint c) {
    const std::int64_t area = orientation(a, b, c);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Whether c, on the line ab, lies within the segment.
bool within(GridPoint a, GridPoint b, GridPoint c) {
    return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
           c.y <= std::max(a.y, b.y);
}

bool boxes_touch(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    return std::min(a.x, b.x) <= std::max(c.x, d.x) && std::min(c.x, d.x) <= std::max(a.x, b.x) &&
           std::min(a.y, b.y) <= std::max(c.y, d.y) && std::min(c.y, d.y) <= std::max(a.y, b.y);
}

/// Whether the ring turns one way only, once around: simple, without looking at pairs.
bool is_convex(std::span<const GridPoint> ring) {
    const std::size_t n = ring.size();
    int side = 0, reversals = 0;
    int last_half = 0;
    GridPoint a = ring[n - 2], b = ring[n - 1];
    const auto half = [](GridPoint p, GridPoint q) { return q.y != p.y ? (q.y > p.y ? 1 : -1) : (q.x > p.x ? 1 : -1); };
    last_half = half(a, b);
    for (const GridPoint c : ring) {
        const int sign = turn(a, b, c);
        if (b == c) return false;
        if (sign == 0 && (std::int64_t(b.x) - a.x) * (std::int64_t(c.x) - b.x) +
                                 (std::int64_t(b.y) - a.y) * (std::int64_t(c.y) - b.y) <
                             0)
            return false;
        if (sign != 0 && side == -sign) return false;
        if (sign != 0) side = sign;
        const int now = half(b, c);
        reversals += now != last_half;
        last_half = now;
        a = b, b = c;
    }
    return side != 0 && reversals == 2;
}

/// Neighbours share a corner and nothing else, unless one folds back onto the other.
bool edges_cross(std::span<const GridPoint> ring, std::size_t i, std::size_t j) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t k) { return ring[k < n ? k : k - n]; };
    if (j == i + 1 || (i == 0 && j == n - 1)) {
        const std::size_t corner = j == i + 1 ? j : 0;
        const GridPoint a = at(corner + n - 1), b = at(corner), c = at(corner + 1);
        if (turn(a, b, c) != 0) return false;
        return (std::int64_t(a.x) - b.x) * (std::int64_t(c.x) - b.x) +
                   (std::int64_t(a.y) - b.y) * (std::int64_t(c.y) - b.y) >=
               0;
    }
    return segments_meet(at(i), at(i + 1), at(j), at(j + 1));
}

}  // namespace

bool segments_meet(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    if (!boxes_touch(a, b, c, d)) return false;
    const int c_side = turn(a, b, c), d_side = turn(a, b, d), a_side = turn(c, d, a), b_side = turn(c, d, b);
    if (c_side * d_side < 0 && a_side * b_side < 0) return true;
    return (c_side == 0 && within(a, b, c)) || (d_side == 0 && within(a, b, d)) || (a_side == 0 && within(c, d, a)) ||
           (b_side == 0 && within(c, d, b));
}

std::vector<RingCrossing> ring_crossings(std::span<const GridPoint> ring, std::size_t most) {
    const std::size_t n = ring.size();
    if (n >= 3 && is_convex(ring)) return {};
    std::vector<RingCrossing> found;
    const auto look = [&](std::size_t i, std::size_t j) {
        if (edges_cross(ring, i, j)) found.push_back({std::uint32_t(i), std::uint32_t(j)});
    };
    if (n <= few) {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j) look(i, j);
    } else {
        std::vector<GridBox> boxes(n);
        for (std::size_t k = 0; k < n; ++k) {
            boxes[k].add(Point3{ring[k].x, ring[k].y, 0});
            const GridPoint next = ring[k + 1 < n ? k + 1 : 0];
            boxes[k].add(Point3{next.x, next.y, 0});
        }
        BoxTree(boxes).for_each_touching_pair(look);
        std::sort(found.begin(), found.end());
    }
    if (found.size() > most) found.resize(most);
    return found;
}

}  // namespace enfilade::modeler
