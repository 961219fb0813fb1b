#include "tools/room_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace enfilade::tools {

using modeler::PolygonSide;
using modeler::RingCorner;

namespace {

bool holds_room(const modeler::Stack& stack, const modeler::Region& region) {
    for (std::uint32_t band = region.first_band; band <= region.last_band; ++band) {
        const modeler::Column& column =
            stack.columns[stack.region_columns[region.first_column + band - region.first_band]];
        for (std::uint32_t s = column.first_slice; s < column.first_slice + column.slice_count; ++s)
            if (stack.slices[s].label == accel::Label::Room) return true;
    }
    return false;
}

std::vector<PolygonSide> boundary_of(const modeler::Stack& stack, const modeler::Region& region) {
    std::vector<PolygonSide> sides;
    for (std::uint32_t k = region.first_half_edge; k < region.first_half_edge + region.half_edge_count; ++k) {
        const std::uint32_t h = stack.boundary[k];
        const modeler::StackEdge& edge = stack.edges[h / 2];
        PolygonSide side{.from = edge.a, .to = edge.b, .line = edge.line};
        if (h % 2 == 1) std::swap(side.from, side.to);
        sides.push_back(side);
    }
    return sides;
}

}  // namespace

ReflexCorners reflex_corners(std::span<const RingCorner> ring) {
    const std::size_t n = ring.size();
    std::vector<std::size_t> ends;  // of runs along one line
    for (std::size_t k = 0; k < n; ++k) {
        const RingCorner &before = ring[(k + n - 1) % n], &at = ring[k], &after = ring[(k + 1) % n];
        if (!modeler::goes_straight(before.point, at.point, after.point, before.line, at.line)) ends.push_back(k);
    }
    if (ends.size() < 3) return {};
    const std::size_t m = ends.size();
    std::vector<double> turns(m, 0);  // by how much a corner turns right; 0: it does not
    ReflexCorners found;
    for (std::size_t e = 0; e < m; ++e) {
        const std::size_t k = ends[e];
        const plans::GridPoint a = ring[ends[(e + m - 1) % m]].point, b = ring[k].point,
                               c = ring[ends[(e + 1) % m]].point;
        if (!modeler::turns_right(a, ring[(k + n - 1) % n].point, b, ring[(k + 1) % n].point, c)) continue;
        const double x = double(b.x) - a.x, y = double(b.y) - a.y, u = double(c.x) - b.x, v = double(c.y) - b.y;
        turns[e] = std::atan2(u * y - v * x, x * u + y * v);
        ++found.count;
    }
    // Chains begin anywhere: slide over the ring twice.
    double sum = 0;
    for (std::size_t first = 0, last = 0; last < 2 * m; ++last) {
        if (turns[last % m] <= 0) {
            first = last + 1;
            sum = 0;
            continue;
        }
        sum += turns[last % m];
        while (sum >= std::numbers::pi && first < last) sum -= turns[first++ % m];
        if (sum < std::numbers::pi)
            found.longest = std::max(found.longest, std::uint32_t(std::min(last + 1 - first, m)));
    }
    return found;
}

RoomPieces room_pieces(const modeler::Stack& stack, std::span<const modeler::RegionCut> cuts) {
    RoomPieces sum;
    for (std::size_t r = 0; r < cuts.size(); ++r) {
        const modeler::Region& region = stack.regions[r];
        if (region.half_edge_count == 0 || !region.carries_light || !holds_room(stack, region)) continue;
        const std::vector<PolygonSide> sides = boundary_of(stack, region);
        const std::vector<std::uint32_t> order = modeler::simple_ring(sides);
        if (order.empty()) continue;  // has holes
        std::vector<RingCorner> ring;
        for (const std::uint32_t s : order) ring.push_back({stack.points[sides[s].from], sides[s].line});
        const auto [reflex, longest] = reflex_corners(ring);
        ++sum.rooms;
        sum.reflex += reflex;
        sum.least += reflex + 1 - std::min(reflex / 2, reflex - longest);
        sum.enough += reflex == 0 ? 1 : (reflex + 1) / 2 + 1;
        sum.pieces += cuts[r].first_side.size() - 1;
    }
    return sum;
}

}  // namespace enfilade::tools
