#include "modeler/editing/route.h"

#include <algorithm>
#include <optional>
#include <tuple>

namespace enfilade::modeler {
namespace {

using plans::GridPoint;
using plans::Segment;

using Wide = __int128;

/// Nearest integer of from + extent * num / den, ties upward. \pre den > 0
std::int32_t rounded(std::int32_t from, std::int64_t extent, std::int64_t num, std::int64_t den) {
    const Wide doubled = 2 * Wide(extent) * num + den;
    const Wide wide_den = 2 * Wide(den);
    Wide quotient = doubled / wide_den;
    if (doubled % wide_den < 0) --quotient;
    return std::int32_t(from + std::int64_t(quotient));
}

/// Where two segments cross or one ends on the other, rounded; nothing where they are parallel.
std::optional<GridPoint> crossing(const Segment& s, const Segment& t) {
    const std::int64_t a = orientation(t.a, t.b, s.a), b = orientation(t.a, t.b, s.b);
    const std::int64_t c = orientation(s.a, s.b, t.a), d = orientation(s.a, s.b, t.b);
    if ((a > 0 && b > 0) || (a < 0 && b < 0) || (c > 0 && d > 0) || (c < 0 && d < 0) || a == b) return std::nullopt;
    const std::int64_t num = a > b ? a : -a, den = a > b ? a - b : b - a;
    return GridPoint{rounded(s.a.x, std::int64_t(s.b.x) - s.a.x, num, den),
                     rounded(s.a.y, std::int64_t(s.b.y) - s.a.y, num, den)};
}

/// Whether a segment meets the square of side 1 around a point, its upper and right sides not counted. Ends of segments
/// are integers, so that they lie on no side of a square.
bool meets(const Segment& s, GridPoint p) {
    const auto apart = [](std::int32_t from, std::int32_t to, std::int32_t at) {
        return std::max(from, to) < at || std::min(from, to) > at;
    };
    if (apart(s.a.x, s.b.x, p.x) || apart(s.a.y, s.b.y, p.y)) return false;
    // Corners in half units: twice the orientation of each.
    const std::int64_t dx = std::int64_t(s.b.x) - s.a.x, dy = std::int64_t(s.b.y) - s.a.y;
    if (dx == 0 && dy == 0) return true;
    const std::int64_t middle = 2 * orientation(s.a, s.b, p);
    const std::int64_t corners[4] = {middle - dx + dy, middle - dx - dy, middle + dx - dy, middle + dx + dy};
    const bool above = std::any_of(corners, corners + 4, [](std::int64_t c) { return c > 0; });
    const bool below = std::any_of(corners, corners + 4, [](std::int64_t c) { return c < 0; });
    if (above && below) return true;
    return corners[0] == 0 && std::min(s.a.x, s.b.x) < p.x && std::min(s.a.y, s.b.y) < p.y;
}

bool boxes_meet(const Segment& s, const Segment& t) {
    return std::max(s.a.x, s.b.x) >= std::min(t.a.x, t.b.x) && std::max(t.a.x, t.b.x) >= std::min(s.a.x, s.b.x) &&
           std::max(s.a.y, s.b.y) >= std::min(t.a.y, t.b.y) && std::max(t.a.y, t.b.y) >= std::min(s.a.y, s.b.y);
}

void sort_unique(std::vector<GridPoint>& points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

/// The points whose squares a segment meets, with its ends, in its order.
std::vector<GridPoint> chain_of(const Segment& s, std::span<const GridPoint> sorted) {
    std::vector<GridPoint> chain = {s.a, s.b};
    const std::int32_t least = std::min(s.a.x, s.b.x), most = std::max(s.a.x, s.b.x);
    for (auto at = std::lower_bound(sorted.begin(), sorted.end(), GridPoint{least, INT32_MIN});
         at != sorted.end() && at->x <= most; ++at)
        if (meets(s, *at)) chain.push_back(*at);
    const bool x_falls = s.b.x < s.a.x, y_falls = s.b.y < s.a.y;
    std::sort(chain.begin(), chain.end(), [&](GridPoint p, GridPoint q) {
        if (p.x != q.x) return (p.x < q.x) != x_falls;
        return p.y != q.y && (p.y < q.y) != y_falls;
    });
    chain.erase(std::unique(chain.begin(), chain.end()), chain.end());
    return chain;
}

RoutedGraph graph_of(const std::vector<std::vector<GridPoint>>& chains, std::size_t fixed_count) {
    RoutedGraph result;
    plans::NodedGraph& graph = result.graph;
    for (const auto& chain : chains)
        if (chain.size() > 1) graph.vertices.insert(graph.vertices.end(), chain.begin(), chain.end());
    sort_unique(graph.vertices);
    struct Use {
        std::uint32_t a, b, segment, step;
        bool reversed;
    };
    std::vector<Use> uses;
    for (std::uint32_t s = 0; s < chains.size(); ++s)
        for (std::uint32_t k = 0; k + 1 < chains[s].size(); ++k) {
            const auto index = [&](GridPoint p) {
                return std::uint32_t(std::lower_bound(graph.vertices.begin(), graph.vertices.end(), p) -
                                     graph.vertices.begin());
            };
            const std::uint32_t a = index(chains[s][k]), b = index(chains[s][k + 1]);
            uses.push_back({std::min(a, b), std::max(a, b), s, k, b < a});
        }
    std::sort(uses.begin(), uses.end(), [](const Use& p, const Use& q) {
        return std::tie(p.a, p.b, p.segment, p.step) < std::tie(q.a, q.b, q.segment, q.step);
    });
    result.chains.resize(fixed_count);
    for (std::size_t s = 0; s < fixed_count; ++s) result.chains[s].resize(chains[s].size() - 1);
    for (const Use& use : uses) {
        if (graph.edges.empty() || graph.edges.back().a != use.a || graph.edges.back().b != use.b)
            graph.edges.push_back({use.a, use.b, std::uint32_t(graph.uses.size()), 0});
        ++graph.edges.back().use_count;
        graph.uses.push_back({use.segment, use.reversed});
        if (use.segment < fixed_count)
            result.chains[use.segment][use.step] = 2 * std::uint32_t(graph.edges.size() - 1) + (use.reversed ? 1 : 0);
    }
    return result;
}

}  // namespace

RoutedGraph route(std::span<const Segment> fixed, std::span<const Segment> added) {
    std::vector<GridPoint> brought;
    for (std::size_t k = 0; k < added.size(); ++k) {
        brought.push_back(added[k].a);
        brought.push_back(added[k].b);
        const auto cross = [&](const Segment& other) {
            if (!boxes_meet(added[k], other)) return;
            if (const auto at = crossing(added[k], other)) brought.push_back(*at);
        };
        for (const Segment& other : fixed) cross(other);
        for (const Segment& other : added.subspan(k + 1)) cross(other);
    }
    sort_unique(brought);
    std::vector<GridPoint> all = brought;
    for (const Segment& s : fixed) all.insert(all.end(), {s.a, s.b});
    sort_unique(all);
    std::vector<std::vector<GridPoint>> chains;
    for (const Segment& s : fixed) chains.push_back(chain_of(s, brought));
    for (const Segment& s : added) chains.push_back(chain_of(s, all));
    return graph_of(chains, fixed.size());
}

}  // namespace enfilade::modeler
