#include "plans/floorspace/edge_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "plans/box_index.h"
#include "plans/segment_tree.h"
#include "plans/vector2.h"

namespace enfilade::plans {
namespace {

/// Places by the cells of a grid, so that near ones are found.
class NodeFinder {
public:
    explicit NodeFinder(std::vector<Point>& nodes) : nodes_(nodes) {}

    std::uint32_t find_or_add(Point p) {
        const std::int64_t x = cell(p.x);
        const std::int64_t y = cell(p.y);
        for (std::int64_t dy = -1; dy <= 1; ++dy)
            for (std::int64_t dx = -1; dx <= 1; ++dx) {
                const auto at = cells_.find(key(x + dx, y + dy));
                if (at == cells_.end()) continue;
                for (const std::uint32_t node : at->second)
                    if (distance(nodes_[node], p) <= floor_tolerance) return node;
            }
        cells_[key(x, y)].push_back(std::uint32_t(nodes_.size()));
        nodes_.push_back(p);
        return std::uint32_t(nodes_.size() - 1);
    }

private:
    static std::int64_t cell(double v) { return std::int64_t(std::floor(v / (2 * floor_tolerance))); }
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return std::uint64_t(x) * 0x9E3779B97F4A7C15u ^ std::uint64_t(y);
    }

    std::vector<Point>& nodes_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

/// What a file of crossing or overlapping edges may come to: many more than any building has, few enough for memory.
constexpr std::size_t most_meetings = 200000;

/// An edge with length, and the nodes on it besides its ends.
struct Line {
    std::uint32_t edge;
    std::uint32_t a;
    std::uint32_t b;
    std::vector<std::uint32_t> on;
};

class GraphMaker {
public:
    GraphMaker(const FloorStory& story, const std::vector<bool>& used) : story_(story), finder_(graph_.nodes) {
        for (const FloorVertex& vertex : story.vertices)
            graph_.node_of_vertex.push_back(finder_.find_or_add(vertex.at));
        for (std::uint32_t e = 0; e < story.edges.size(); ++e) {
            if (!used[e]) continue;
            const auto& ends = story.edges[e].ends;
            const std::uint32_t a = graph_.node_of_vertex[ends[0]];
            const std::uint32_t b = graph_.node_of_vertex[ends[1]];
            if (a == b) ++graph_.short_edges;
            else lines_.push_back({e, a, b, {}});
        }
    }

    FloorGraph make() {
        find_meetings();
        for (const auto& [l, m, at] : crossings_) {
            const std::uint32_t node = finder_.find_or_add(at);
            lines_[l].on.push_back(node);
            lines_[m].on.push_back(node);
        }
        graph_.of_edge.resize(story_.edges.size());
        for (Line& line : lines_) cut(line);
        graph_.at_node.resize(graph_.nodes.size());
        for (std::uint32_t p = 0; p < graph_.pieces.size(); ++p) {
            graph_.at_node[graph_.pieces[p].a].push_back(p);
            graph_.at_node[graph_.pieces[p].b].push_back(p);
        }
        return std::move(graph_);
    }

private:
    struct Crossing {
        std::uint32_t line;
        std::uint32_t other;
        Point at;
    };

    [[nodiscard]] Point start(const Line& line) const { return graph_.nodes[line.a]; }
    [[nodiscard]] Point end(const Line& line) const { return graph_.nodes[line.b]; }

    /// Past that, edges stay uncut: whoever lays out the walls finds their crossings again.
    [[nodiscard]] bool full() const { return meetings_ >= std::max(most_meetings, 16 * lines_.size()); }

    /// Pairs of lines that come close, by a tree over their places on a grid that is no finer than the tolerance.
    void find_meetings() {
        if (lines_.empty()) return;
        PlanBox box;
        for (const Line& line : lines_) {
            box.add(start(line));
            box.add(end(line));
        }
        const double size = std::max(box.max.x - box.min.x, box.max.y - box.min.y);
        const double unit = std::max(2 * floor_tolerance, size / double(1 << 29));
        const auto on_grid = [&](Point p) {
            return GridPoint{std::int32_t(std::lround((p.x - box.min.x) / unit)),
                             std::int32_t(std::lround((p.y - box.min.y) / unit))};
        };
        std::vector<Segment> segments;
        for (const Line& line : lines_) segments.push_back({on_grid(start(line)), on_grid(end(line))});
        visit_close_segments(segments, [&](std::span<const std::uint32_t> close) {
            for (std::size_t i = 0; i < close.size() && !full(); ++i)
                for (std::size_t k = i + 1; k < close.size(); ++k)
                    meet(std::min(close[i], close[k]), std::max(close[i], close[k]));
        });
        // A pair may be visited in several places.
        std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& l, const Crossing& r) {
            return l.line != r.line ? l.line < r.line : l.other < r.other;
        });
        const auto twice = [](const Crossing& l, const Crossing& r) { return l.line == r.line && l.other == r.other; };
        crossings_.erase(std::unique(crossings_.begin(), crossings_.end(), twice), crossings_.end());
        graph_.crossed_edges = crossings_.size();
        if (!crossings_.empty()) graph_.crossing = crossings_.front().at;
    }

    void meet(std::uint32_t l, std::uint32_t m) {
        Line& line = lines_[l];
        Line& other = lines_[m];
        // Each is to take note of its own: no short cut.
        const std::array touches_it = {touches(line, other.a), touches(line, other.b), touches(other, line.a),
                                       touches(other, line.b)};
        const bool touch = std::find(touches_it.begin(), touches_it.end(), true) != touches_it.end();
        if (touch || line.a == other.a || line.a == other.b || line.b == other.a || line.b == other.b) return;
        const Point d = end(line) - start(line);
        const Point e = end(other) - start(other);
        const double turn = cross(d, e);
        const Point between = start(other) - start(line);
        if (turn == 0) return;
        const double along = cross(between, e) / turn;
        const double across = cross(between, d) / turn;
        if (!(along > 0 && along < 1 && across > 0 && across < 1)) return;
        crossings_.push_back({l, m, start(line) + d * along});
        ++meetings_;
    }

    /// Takes note of the node where it lies on the line between its ends.
    bool touches(Line& line, std::uint32_t node) {
        if (node == line.a || node == line.b) return false;
        if (distance(graph_.nodes[node], start(line), end(line)) > floor_tolerance) return false;
        line.on.push_back(node);
        ++meetings_;
        return true;
    }

    void cut(Line& line) {
        const Point from = start(line);
        const Point d = (end(line) - from) * (1 / distance(from, end(line)));
        const auto along = [&](std::uint32_t node) { return dot(graph_.nodes[node] - from, d); };
        std::sort(line.on.begin(), line.on.end(), [&](std::uint32_t l, std::uint32_t r) {
            const double at = along(l), bt = along(r);
            return at != bt ? at < bt : l < r;
        });
        line.on.erase(std::unique(line.on.begin(), line.on.end()), line.on.end());
        std::erase_if(line.on, [&](std::uint32_t node) { return node == line.a || node == line.b; });
        if (!line.on.empty()) ++graph_.touched_edges;
        line.on.push_back(line.b);
        std::uint32_t before = line.a;
        bool all_known = true;
        for (const std::uint32_t node : line.on) {
            const std::uint64_t ends = std::uint64_t(std::min(before, node)) << 32 | std::max(before, node);
            const auto [at, fresh] = piece_of_.try_emplace(ends, std::uint32_t(graph_.pieces.size()));
            if (fresh) graph_.pieces.push_back({std::min(before, node), std::max(before, node), line.edge});
            all_known = all_known && !fresh;
            graph_.of_edge[line.edge].push_back({at->second, before < node, along(before), along(node)});
            before = node;
        }
        if (all_known) ++graph_.doubled_edges;
    }

    const FloorStory& story_;
    FloorGraph graph_;
    NodeFinder finder_;
    std::vector<Line> lines_;
    std::vector<Crossing> crossings_;
    std::size_t meetings_ = 0;
    std::unordered_map<std::uint64_t, std::uint32_t> piece_of_;
};

}  // namespace

double FloorGraph::length(std::uint32_t piece) const {
    return distance(nodes[pieces[piece].a], nodes[pieces[piece].b]);
}

FloorGraph make_floor_graph(const FloorStory& story, const std::vector<bool>& used) {
    return GraphMaker(story, used).make();
}

}  // namespace enfilade::plans
