#include "modeler/cutting/polygon.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

namespace enfilade::modeler {

using plans::GridPoint;

std::optional<std::size_t> reflex_corner(std::span<const RingCorner> ring) {
    const std::size_t n = ring.size();
    const auto at = [&](std::size_t k) -> const RingCorner& { return ring[k % n]; };
    std::vector<std::size_t> ends;
    for (std::size_t k = 0; k < n; ++k)
        if (!goes_straight(at(k + n - 1).point, at(k).point, at(k + 1).point, at(k + n - 1).line, at(k).line))
            ends.push_back(k);
    if (ends.size() < 3) return std::nullopt;  // a sliver as wide as the grid, all of it on two lines
    for (std::size_t e = 0; e < ends.size(); ++e) {
        const std::size_t k = ends[e], before = ends[(e + ends.size() - 1) % ends.size()],
                          after = ends[(e + 1) % ends.size()];
        if (turns_right(at(before).point, at(k + n - 1).point, at(k).point, at(k + 1).point, at(after).point)) return k;
    }
    return std::nullopt;
}

std::int64_t area2(std::span<const GridPoint> points, std::span<const PolygonSide> ring) {
    std::int64_t sum = 0;
    for (const PolygonSide& side : ring) sum += orientation(points[ring[0].from], points[side.from], points[side.to]);
    return sum;
}

void drop_unused_points(std::uint32_t given, Partition& partition) {
    std::vector<std::uint32_t> number(partition.new_points.size(), UINT32_MAX);
    std::vector<GridPoint> used;
    for (PolygonSide& side : partition.sides)
        for (std::uint32_t* end : {&side.from, &side.to}) {
            if (*end < given) continue;
            std::uint32_t& n = number[*end - given];
            if (n == UINT32_MAX) {
                n = given + std::uint32_t(used.size());
                used.push_back(partition.new_points[*end - given]);
            }
            *end = n;
        }
    partition.new_points = std::move(used);
}

std::vector<std::uint32_t> simple_ring(std::span<const PolygonSide> sides) {
    std::unordered_map<std::uint32_t, std::uint32_t> leaving;
    leaving.reserve(sides.size());
    for (std::uint32_t k = 0; k < sides.size(); ++k)
        if (!leaving.emplace(sides[k].from, k).second) return {};
    std::vector<std::uint32_t> ring;
    std::uint32_t k = 0;
    do {
        ring.push_back(k);
        const auto follow = leaving.find(sides[k].to);
        if (follow == leaving.end()) return {};
        k = follow->second;
    } while (k != 0 && ring.size() <= sides.size());
    return ring.size() == sides.size() ? ring : std::vector<std::uint32_t>{};
}

namespace {

/// Whether a corner lies deeper within the hull of its ring than rounded lines bring it there: short sides in a row can
/// hide a reflex corner from the chords of lines.
bool is_dented(std::span<const RingCorner> ring) {
    const std::size_t n = ring.size();
    bool turns_right = false;
    for (std::size_t k = 0; k < n && !turns_right; ++k)
        turns_right = orientation(ring[k].point, ring[(k + 1) % n].point, ring[(k + 2) % n].point) < 0;
    if (!turns_right) return false;
    std::vector<GridPoint> sorted;
    for (const RingCorner& corner : ring) sorted.push_back(corner.point);
    std::sort(sorted.begin(), sorted.end());
    std::vector<GridPoint> hull;  // counter-clockwise: the lower chain, then the upper one (Andrew 1979)
    const auto add = [&](GridPoint p, std::size_t least) {
        while (hull.size() > least && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
    };
    for (const GridPoint p : sorted) add(p, 1);
    const std::size_t lower = hull.size();
    for (std::size_t k = n - 1; k-- > 0;) add(sorted[k], lower);
    hull.pop_back();
    // Ring and hull run the same way: the edge that a corner lies near is that of the corner before, or soon after it.
    std::size_t edge = 0;
    const std::size_t edges = hull.size();
    for (const RingCorner& corner : ring) {
        std::size_t steps = 0;
        for (; steps < edges; ++steps) {
            const GridPoint a = hull[(edge + steps) % edges], b = hull[(edge + steps + 1) % edges];
            const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
            if (double(orientation(a, b, corner.point)) <= 3 * most_stray * length) break;
        }
        if (steps == edges) return true;
        edge = (edge + steps) % edges;
    }
    return false;
}

}  // namespace

bool is_convex(std::span<const RingCorner> ring) { return !reflex_corner(ring) && !is_dented(ring); }

bool is_convex(std::span<const GridPoint> points, std::span<const PolygonSide> sides,
               std::span<const std::uint32_t> ring) {
    std::vector<RingCorner> corners;
    for (const std::uint32_t k : ring) corners.push_back({points[sides[k].from], sides[k].line});
    return is_convex(corners);
}

}  // namespace enfilade::modeler
