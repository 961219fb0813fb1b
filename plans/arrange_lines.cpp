#include "plans/arrange_lines.h"

#include <algorithm>
#include <cmath>

#include "base/disjoint_sets.h"

namespace enfilade::plans {
namespace {

class Groups {
public:
    explicit Groups(const std::vector<PlanLine>& lines) : sets_(lines.size()), ends_(lines.size()) {
        for (std::size_t i = 0; i < lines.size(); ++i) ends_[i] = {lines[i].a, lines[i].b};
    }

    [[nodiscard]] std::vector<std::uint32_t> lowest() { return sets_.lowest(); }

    void unite_where_straight(std::uint32_t l, std::uint32_t r) {
        l = sets_.find(l);
        r = sets_.find(r);
        if (l == r) return;
        std::vector<GridPoint> both = ends_[l];
        both.insert(both.end(), ends_[r].begin(), ends_[r].end());
        if (!one_line(both)) return;
        sets_.join(l, r);
        ends_[std::max(l, r)].clear();
        ends_[std::min(l, r)] = std::move(both);
    }

private:
    /// The ends farthest apart are extreme in x or y but for lines within a unit of a point.
    [[nodiscard]] static bool one_line(const std::vector<GridPoint>& points) {
        const auto [low, high] = std::minmax_element(points.begin(), points.end());
        const auto by_y = [](GridPoint p, GridPoint q) { return p.y != q.y ? p.y < q.y : p.x < q.x; };
        const auto [under, over] = std::minmax_element(points.begin(), points.end(), by_y);
        const bool wide = std::int64_t(high->x) - low->x >= std::int64_t(over->y) - under->y;
        const GridPoint a = wide ? *low : *under;
        const GridPoint b = wide ? *high : *over;
        const double span = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        return std::all_of(points.begin(), points.end(),
                           [&](GridPoint p) { return std::abs(double(orientation(a, b, p))) <= span; });
    }

    DisjointSets sets_;
    std::vector<std::vector<GridPoint>> ends_;  ///< of roots: the ends of all lines of the group
};

}  // namespace

std::vector<std::uint32_t> straight_groups(const Parts& parts, const NodedGraph& graph) {
    Groups groups(parts.lines);
    auto continuations = parts.continuations;
    std::sort(continuations.begin(), continuations.end());
    for (const auto& [l, r] : continuations) groups.unite_where_straight(l, r);
    for (const NodedEdge& edge : graph.edges) {
        const std::uint32_t line = parts.tags[graph.uses[edge.first_use].segment].line;
        for (std::uint32_t u = edge.first_use + 1; u < edge.first_use + edge.use_count; ++u)
            groups.unite_where_straight(line, parts.tags[graph.uses[u].segment].line);
    }
    return groups.lowest();
}

}  // namespace enfilade::plans
