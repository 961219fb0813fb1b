#include "modeler/editing/split_edges.h"

#include <algorithm>

#include "base/check.h"

namespace enfilade::modeler {

using plans::GridPoint;

void StackChains::add(const Stack& stack, std::uint32_t edge, GridPoint point) {
    if (point == stack.points[stack.edges[edge].a] || point == stack.points[stack.edges[edge].b]) return;
    points_[edge].push_back(point);
}

std::uint32_t StackChains::point(Stack& stack, GridPoint at) {
    const auto [found, is_new] = new_points_.try_emplace(at, std::uint32_t(stack.points.size()));
    if (is_new) stack.points.push_back(at);
    return found->second;
}

void StackChains::split(Stack& stack) {
    for (auto& [edge, points] : points_) {
        const StackEdge whole = stack.edges[edge];
        const GridPoint a = stack.points[whole.a], b = stack.points[whole.b];
        // Rounding keeps the order of points along a line, in each coordinate.
        const bool x_falls = b.x < a.x, y_falls = b.y < a.y;
        std::sort(points.begin(), points.end(), [&](GridPoint p, GridPoint q) {
            if (p.x != q.x) return (p.x < q.x) != x_falls;
            return p.y != q.y && (p.y < q.y) != y_falls;
        });
        points.erase(std::unique(points.begin(), points.end()), points.end());
        std::vector<std::uint32_t>& parts = parts_[edge];
        std::uint32_t before = whole.a;
        for (std::size_t k = 0; k <= points.size(); ++k) {
            const std::uint32_t end = k < points.size() ? point(stack, points[k]) : whole.b;
            parts.push_back(k == 0 ? edge : std::uint32_t(stack.edges.size()));
            if (k == 0) stack.edges[edge] = {before, end, whole.line};
            else stack.edges.push_back({before, end, whole.line});
            before = end;
        }
    }
}

void StackChains::append(std::uint32_t half_edge, std::vector<std::uint32_t>& half_edges) const {
    const auto at = parts_.find(half_edge / 2);
    if (at == parts_.end()) return half_edges.push_back(half_edge);
    const std::vector<std::uint32_t>& parts = at->second;
    for (std::size_t k = 0; k < parts.size(); ++k)
        half_edges.push_back(half_edge % 2 == 0 ? 2 * parts[k] : 2 * parts[parts.size() - 1 - k] + 1);
}

void StackChains::append(const Stack& stack, std::uint32_t half_edge, GridPoint from, GridPoint to,
                         std::vector<std::uint32_t>& half_edges) const {
    std::vector<std::uint32_t> all;
    append(half_edge, all);
    const std::size_t first = half_edges.size();
    bool inside = false;
    for (const std::uint32_t h : all) {
        const StackEdge& edge = stack.edges[h / 2];
        const GridPoint start = stack.points[h % 2 == 0 ? edge.a : edge.b];
        const GridPoint stop = stack.points[h % 2 == 0 ? edge.b : edge.a];
        inside |= start == from;
        if (inside) half_edges.push_back(h);
        if (stop == to) break;
    }
    ENFILADE_CHECK(half_edges.size() > first);
}

}  // namespace enfilade::modeler
