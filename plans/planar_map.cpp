#include "plans/planar_map.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>

#include "base/disjoint_sets.h"

namespace enfilade::plans {
namespace {

GridPoint origin_point(const NodedGraph& graph, std::uint32_t half_edge) {
    return graph.vertices[origin(graph, half_edge)];
}

struct Direction {
    std::int64_t x;
    std::int64_t y;
    /// Half 0: angle in [0, pi), half 1: [pi, 2 pi).
    [[nodiscard]] int half() const { return y < 0 || (y == 0 && x < 0); }
};

/// Half-edges leaving each vertex, counter-clockwise by exact angle.
struct Stars {
    std::vector<std::uint32_t> first;  ///< [vertex_count + 1]
    std::vector<std::uint32_t> out;
};

Stars sorted_stars(const NodedGraph& graph) {
    Stars stars;
    stars.first.assign(graph.vertices.size() + 1, 0);
    const auto half_edge_count = std::uint32_t(2 * graph.edges.size());
    for (std::uint32_t h = 0; h < half_edge_count; ++h) ++stars.first[origin(graph, h) + 1];
    std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
    stars.out.resize(half_edge_count);
    std::vector<std::uint32_t> slot(stars.first.begin(), stars.first.end() - 1);
    for (std::uint32_t h = 0; h < half_edge_count; ++h) stars.out[slot[origin(graph, h)]++] = h;

    const auto direction = [&](std::uint32_t h) {
        const GridPoint from = origin_point(graph, h);
        const GridPoint to = origin_point(graph, h ^ 1u);
        return Direction{std::int64_t(to.x) - from.x, std::int64_t(to.y) - from.y};
    };
    for (std::size_t v = 0; v + 1 < stars.first.size(); ++v)
        std::sort(stars.out.begin() + stars.first[v], stars.out.begin() + stars.first[v + 1],
                  [&](std::uint32_t l, std::uint32_t r) {
                      const Direction d = direction(l);
                      const Direction e = direction(r);
                      return d.half() != e.half() ? d.half() < e.half() : d.x * e.y - d.y * e.x > 0;
                  });
    return stars;
}

void link_next(const Stars& stars, PlanarMap& map) {
    map.next.resize(stars.out.size());
    for (std::size_t v = 0; v + 1 < stars.first.size(); ++v)
        for (std::uint32_t i = stars.first[v]; i < stars.first[v + 1]; ++i) {
            const std::uint32_t before = i == stars.first[v] ? stars.first[v + 1] - 1 : i - 1;
            map.next[stars.out[i] ^ 1u] = stars.out[before];
        }
}

void trace_loops(const NodedGraph& graph, PlanarMap& map) {
    map.loop.assign(map.next.size(), UINT32_MAX);
    for (std::uint32_t h = 0; h < map.next.size(); ++h) {
        if (map.loop[h] != UINT32_MAX) continue;
        const auto loop = std::uint32_t(map.loop_first.size());
        const GridPoint anchor = origin_point(graph, h);
        std::int64_t area2 = 0;
        std::uint32_t at = h;
        do {
            map.loop[at] = loop;
            area2 += orientation(anchor, origin_point(graph, at), origin_point(graph, at ^ 1u));
            at = map.next[at];
        } while (at != h);
        map.loop_first.push_back(h);
        map.loop_area2.push_back(area2);
    }
}

/// The edges that a vertical line crosses, from below to above, as it moves over the vertices in their order.
/// Edges do not cross: a vertex with edges on its left knows its place, so that only those without need a search.
class Sweep {
public:
    Sweep(const NodedGraph& graph, const Stars& stars)
        : graph_(graph), stars_(stars), active_(Below{&graph}), place_(graph.edges.size(), active_.end()) {}

    /// Calls `found(vertex, edge below or UINT32_MAX)` for each vertex without an edge on its left, when the line
    /// has passed what lies left of it and below it.
    template <class Found>
    void run(Found found) {
        for (std::uint32_t v = 0; v + 1 < stars_.first.size(); ++v) {
            std::optional<Active::iterator> above = erase_left_star(v);
            if (!above) {
                above = active_.lower_bound(graph_.vertices[v]);
                found(v, *above == active_.begin() ? UINT32_MAX : *std::prev(*above));
            }
            insert_right_star(v, *above);
        }
    }

private:
    struct Below {
        using is_transparent = void;
        const NodedGraph* graph;

        /// \pre one vertical line meets both edges
        bool operator()(std::uint32_t l, std::uint32_t r) const {
            if (l == r) return false;
            const GridPoint la = graph->vertices[graph->edges[l].a];
            const GridPoint ra = graph->vertices[graph->edges[r].a];
            if (la == ra) return (*this)(l, graph->vertices[graph->edges[r].b]);
            return la < ra ? (*this)(l, ra) : !(*this)(r, la);
        }
        bool operator()(std::uint32_t edge, GridPoint point) const {
            return orientation(graph->vertices[graph->edges[edge].a], graph->vertices[graph->edges[edge].b], point) > 0;
        }
    };
    using Active = std::set<std::uint32_t, Below>;

    /// The place above all edges that ended in v, where any did. Those edges leave v between straight up and
    /// straight down, the highest first.
    std::optional<Active::iterator> erase_left_star(std::uint32_t v) {
        std::optional<Active::iterator> above;
        for (std::uint32_t i = stars_.first[v]; i < stars_.first[v + 1]; ++i) {
            const std::uint32_t h = stars_.out[i];
            if (h % 2 == 0) continue;
            const auto next = active_.erase(place_[h / 2]);
            if (!above) above = next;
        }
        return above;
    }

    void insert_right_star(std::uint32_t v, Active::iterator above) {
        const auto insert = [&](std::uint32_t from, std::uint32_t to) {
            for (std::uint32_t i = from; i < to; ++i)
                if (stars_.out[i] % 2 == 0) place_[stars_.out[i] / 2] = active_.emplace_hint(above, stars_.out[i] / 2);
        };
        // Lowest first: from straight down to the right, then from the right to straight up.
        std::uint32_t upper = stars_.first[v];
        const GridPoint from = graph_.vertices[v];
        while (upper < stars_.first[v + 1] && origin_point(graph_, stars_.out[upper] ^ 1u).y >= from.y) ++upper;
        insert(upper, stars_.first[v + 1]);
        insert(stars_.first[v], upper);
    }

    const NodedGraph& graph_;
    const Stars& stars_;
    Active active_;
    std::vector<Active::iterator> place_;
};

/// Component of each vertex, named by its least vertex.
std::vector<std::uint32_t> least_connected(const NodedGraph& graph) {
    DisjointSets components(graph.vertices.size());
    for (const NodedEdge& edge : graph.edges) components.join(edge.a, edge.b);
    return components.lowest();
}

/// Each component has one loop without area or of negative area, its outside. What lies below its least vertex
/// is a component that begins further left, so that ascending vertices find their surroundings named.
void assign_faces(const NodedGraph& graph, const Stars& stars, PlanarMap& map) {
    map.face_of_loop.assign(map.loop_first.size(), UINT32_MAX);
    map.face_count = 1;
    for (std::size_t l = 0; l < map.loop_first.size(); ++l)
        if (map.loop_area2[l] > 0) map.face_of_loop[l] = map.face_count++;

    const std::vector<std::uint32_t> component = least_connected(graph);
    std::vector<std::uint32_t> outside(graph.vertices.size(), UINT32_MAX);
    std::size_t component_count = 0;
    for (std::uint32_t l = 0; l < map.loop_first.size(); ++l)
        if (map.loop_area2[l] <= 0) {
            outside[component[origin(graph, map.loop_first[l])]] = l;
            ++component_count;
        }
    if (component_count == 1) {
        for (std::uint32_t& face : map.face_of_loop)
            if (face == UINT32_MAX) face = 0;
        return;
    }
    Sweep(graph, stars).run([&](std::uint32_t v, std::uint32_t below) {
        if (component[v] == v) map.face_of_loop[outside[v]] = below == UINT32_MAX ? 0 : map.face(2 * below);
    });
}

}  // namespace

PlanarMap planar_map(const NodedGraph& graph) {
    PlanarMap map;
    map.face_count = 1;
    if (graph.edges.empty()) return map;
    const Stars stars = sorted_stars(graph);
    link_next(stars, map);
    trace_loops(graph, map);
    assign_faces(graph, stars, map);
    return map;
}

}  // namespace enfilade::plans
