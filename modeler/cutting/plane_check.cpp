#include "modeler/cutting/plane_check.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace enfilade::modeler {

using plans::GridPoint;

namespace {

struct Edge {
    GridPoint a, b;  ///< a < b
    bool is_new;
    [[nodiscard]] std::int32_t low() const { return std::min(a.y, b.y); }
    [[nodiscard]] std::int32_t high() const { return std::max(a.y, b.y); }
};

int sign(std::int64_t value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// Whether two edges have more in common than one end of both.
bool meet(const Edge& e, const Edge& f) {
    const int fa = sign(orientation(e.a, e.b, f.a)), fb = sign(orientation(e.a, e.b, f.b));
    if (fa * fb > 0) return false;
    const int ea = sign(orientation(f.a, f.b, e.a)), eb = sign(orientation(f.a, f.b, e.b));
    if (ea * eb > 0) return false;
    if (fa == 0 && fb == 0) return e.a < f.b && f.a < e.b;  // on one line: ends in order
    if (e.a == f.a || e.a == f.b || e.b == f.a || e.b == f.b) return false;
    return true;
}

}  // namespace

bool is_plane(std::span<const GridPoint> points, std::uint32_t given, const Partition& partition) {
    std::vector<Edge> edges;
    bool has_new = false;
    std::vector<std::uint32_t> visited(points.size(), UINT32_MAX);
    for (std::uint32_t k = 0; k < partition.piece_count(); ++k) {
        for (const PolygonSide& side : partition.piece(k))
            if (std::exchange(visited[side.from], k) == k) return false;
        if (area2(points, partition.piece(k)) <= 0) return false;
        for (const PolygonSide& side : partition.piece(k)) {
            if (side.tag == cut_tag && side.from > side.to) continue;  // known from its other side
            const bool is_new = side.tag == cut_tag || side.from >= given || side.to >= given;
            const GridPoint a = points[side.from], b = points[side.to];
            edges.push_back({std::min(a, b), std::max(a, b), is_new});
            has_new |= is_new;
        }
    }
    if (!has_new) return true;
    std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.a < f.a; });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& e = edges[i];
        const std::int32_t low = e.low(), high = e.high();
        for (std::size_t j = i + 1; j < edges.size() && edges[j].a.x <= e.b.x; ++j) {
            const Edge& f = edges[j];
            if (!(e.is_new || f.is_new) || f.low() > high || f.high() < low) continue;
            if (meet(e, f)) return false;
        }
    }
    return true;
}

}  // namespace enfilade::modeler
