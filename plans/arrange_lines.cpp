#include "plans/arrange_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enfilade::plans {
namespace {

class Groups {
public:
    explicit Groups(const std::vector<PlanLine>& lines) : parent_(lines.size()), ends_(lines.size()) {
        std::iota(parent_.begin(), parent_.end(), 0u);
        for (std::size_t i = 0; i < lines.size(); ++i) ends_[i] = {lines[i].a, lines[i].b};
    }

    std::uint32_t root(std::uint32_t line) {
        while (parent_[line] != line) line = parent_[line] = parent_[parent_[line]];
        return line;
    }

    void unite_where_straight(std::uint32_t l, std::uint32_t r) {
        l = root(l);
        r = root(r);
        if (l == r) return;
        std::vector<GridPoint> both = ends_[l];
        both.insert(both.end(), ends_[r].begin(), ends_[r].end());
        if (!one_line(both)) return;
        parent_[std::max(l, r)] = std::min(l, r);
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

    std::vector<std::uint32_t> parent_;
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
    std::vector<std::uint32_t> least(parts.lines.size());
    for (std::uint32_t line = 0; line < least.size(); ++line) least[line] = groups.root(line);
    return least;
}

}  // namespace enfilade::plans
