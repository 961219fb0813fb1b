#include "modeler/plan_graph.h"

#include <algorithm>
#include <unordered_map>

namespace enfilade::modeler {
namespace {

constexpr std::uint32_t no_index = UINT32_MAX;

/// Counts, then fills: lists of `count` items keyed below `keys`, as offsets.
std::vector<std::uint32_t> offsets_of(std::vector<std::uint32_t> counts) {
    std::uint32_t sum = 0;
    for (std::uint32_t& count : counts) {
        const std::uint32_t here = count;
        count = sum;
        sum += here;
    }
    counts.push_back(sum);
    return counts;
}

class GraphBuilder {
public:
    GraphBuilder(const Stack& stack, const CutPieces& pieces, std::vector<Finding>& findings)
        : stack_(stack), pieces_(pieces), findings_(findings) {}

    PlanGraph run() {
        node_segments();
        find_edge_sides();
        trace_rings();
        return std::move(result_);
    }

private:
    void node_segments() {
        std::vector<plans::Segment> segments;
        segments.reserve(pieces_.segments.size());
        for (const auto& [a, b] : pieces_.segments) segments.push_back({pieces_.points[a], pieces_.points[b]});
        result_.graph = plans::node(segments);
        result_.map = plans::planar_map(result_.graph);
    }

    /// Each side of each piece puts the piece on the left of its half-edge; on edges that several segments share,
    /// what lies on both sides cancels (winding numbers stay those of closed loops under snap rounding).
    void find_edge_sides() {
        std::vector<std::uint32_t> counts(pieces_.segments.size(), 0);
        for (const std::uint32_t h : pieces_.sides) ++counts[h / 2];
        const std::vector<std::uint32_t> first = offsets_of(std::move(counts));
        std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
        std::vector<EdgeSide> of_segment(pieces_.sides.size());
        for (std::uint32_t p = 0; p < pieces_.piece_count(); ++p)
            for (std::uint32_t k = pieces_.first_side[p]; k < pieces_.first_side[p + 1]; ++k) {
                const std::uint32_t h = pieces_.sides[k];
                of_segment[fill[h / 2]++] = {p, h % 2 == 1, pieces_.side_line[k]};
            }

        struct Turn {
            std::uint32_t piece;
            int winding;
            std::uint32_t line;
        };
        std::vector<Turn> turns;
        result_.first_edge_side.push_back(0);
        for (const plans::NodedEdge& edge : result_.graph.edges) {
            turns.clear();
            for (std::uint32_t u = 0; u < edge.use_count; ++u) {
                const plans::EdgeUse use = result_.graph.uses[edge.first_use + u];
                for (std::uint32_t k = first[use.segment]; k < first[use.segment + 1]; ++k)
                    turns.push_back(
                        {of_segment[k].piece, of_segment[k].right != use.reversed ? -1 : 1, of_segment[k].line});
            }
            std::stable_sort(turns.begin(), turns.end(),
                             [](const Turn& a, const Turn& b) { return a.piece < b.piece; });
            for (std::size_t k = 0; k < turns.size();) {
                int sum = 0;
                const std::size_t begin = k;
                for (; k < turns.size() && turns[k].piece == turns[begin].piece; ++k) sum += turns[k].winding;
                if (sum == 0) continue;
                std::size_t own = begin;
                while ((turns[own].winding < 0) != (sum < 0)) ++own;
                result_.edge_sides.push_back({turns[begin].piece, sum < 0, turns[own].line});
            }
            result_.first_edge_side.push_back(std::uint32_t(result_.edge_sides.size()));
        }
    }

    void trace_rings() {
        std::vector<std::uint32_t> counts(pieces_.piece_count(), 0);
        for (const EdgeSide& side : result_.edge_sides) ++counts[side.piece];
        const std::vector<std::uint32_t> first = offsets_of(std::move(counts));
        std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
        std::vector<std::array<std::uint32_t, 2>> half_edges(result_.edge_sides.size());  // half-edge, edge side
        for (std::uint32_t e = 0; e < result_.graph.edges.size(); ++e)
            for (std::uint32_t k = result_.first_edge_side[e]; k < result_.first_edge_side[e + 1]; ++k) {
                const EdgeSide side = result_.edge_sides[k];
                half_edges[fill[side.piece]++] = {2 * e + (side.right ? 1u : 0u), k};
            }
        stamp_.assign(2 * result_.graph.edges.size(), no_index);
        side_of_.assign(2 * result_.graph.edges.size(), no_index);
        result_.first_ring.push_back(0);
        std::vector<std::uint32_t> vanished;
        for (std::uint32_t p = 0; p < pieces_.piece_count(); ++p) {
            const auto mine = std::span(half_edges).subspan(first[p], first[p + 1] - first[p]);
            if (mine.empty()) vanished.push_back(p);
            else trace(p, mine);
        }
        report_vanished(vanished);
    }

    void trace(std::uint32_t p, std::span<const std::array<std::uint32_t, 2>> half_edges) {
        for (const auto& [h, k] : half_edges) stamp_[h] = p, side_of_[h] = k;
        std::vector<std::vector<std::uint32_t>> rings;
        for (const auto& [start, unused] : half_edges) {
            if (stamp_[start] != p) continue;
            std::vector<std::uint32_t> loop;
            for (std::uint32_t h = start; stamp_[h] == p; h = next_along(h, p)) {
                stamp_[h] = no_index - 1;
                loop.push_back(h);
            }
            for (std::vector<std::uint32_t>& ring : split_at_pinches(loop)) rings.push_back(std::move(ring));
        }
        if (std::all_of(rings.begin(), rings.end(), [&](const auto& ring) { return area2(ring) > 0; })) {
            for (const std::vector<std::uint32_t>& ring : rings) add_ring(p, ring);
        } else {
            TangledPiece tangled{p, {}};
            for (const auto& [h, k] : half_edges) tangled.sides.push_back({h, result_.edge_sides[k].line});
            result_.tangled.push_back(std::move(tangled));
        }
        for (const auto& [h, unused] : half_edges) stamp_[h] = no_index;
        if (rings.size() > 1) {
            const Space& space = space_of(p);
            findings_.push_back({.code = "P501",
                                 .severity = Severity::Warning,
                                 .sentence = "Rounding to the grid splits a piece of \"" + space.name + "\" in " +
                                             std::to_string(rings.size()) +
                                             " parts: it is narrower than the grid there.",
                                 .hint = "Use a finer grid (--snap-mm) or widen the place.",
                                 .elements = {{"space", space.id, space.name}}});
        }
    }

    void add_ring(std::uint32_t p, const std::vector<std::uint32_t>& ring) {
        for (const std::uint32_t h : ring) {
            EdgeSide& side = result_.edge_sides[side_of_[h]];
            side.piece = std::uint32_t(result_.source.size());
            result_.ring.push_back(h);
            result_.ring_line.push_back(side.line);
        }
        result_.source.push_back(p);
        result_.first_ring.push_back(std::uint32_t(result_.ring.size()));
    }

    /// Where rounding closed a neck, the boundary visits a point twice: the parts on both sides of it are loops of
    /// their own, negative where they close around a pocket.
    [[nodiscard]] std::vector<std::vector<std::uint32_t>> split_at_pinches(
        const std::vector<std::uint32_t>& loop) const {
        std::unordered_map<std::uint32_t, std::size_t> position;  // of a point in `path`
        std::vector<std::uint32_t> path;
        std::vector<std::vector<std::uint32_t>> rings;
        for (const std::uint32_t h : loop) {
            const auto [at, is_new] = position.try_emplace(plans::origin(result_.graph, h), path.size());
            if (!is_new) {
                rings.emplace_back(path.begin() + std::ptrdiff_t(at->second), path.end());
                for (std::size_t k = at->second + 1; k < path.size(); ++k)
                    position.erase(plans::origin(result_.graph, path[k]));
                path.resize(at->second);
            }
            path.push_back(h);
        }
        rings.push_back(std::move(path));
        return rings;
    }

    [[nodiscard]] std::int64_t area2(const std::vector<std::uint32_t>& ring) const {
        std::int64_t sum = 0;
        for (const std::uint32_t h : ring) {
            const plans::GridPoint a = result_.graph.vertices[plans::origin(result_.graph, h)];
            const plans::GridPoint b = result_.graph.vertices[plans::origin(result_.graph, h ^ 1)];
            sum += std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
        }
        return sum;
    }

    /// The next half-edge of the piece's boundary: turn around the end point over edges that are none of it.
    [[nodiscard]] std::uint32_t next_along(std::uint32_t h, std::uint32_t p) const {
        std::uint32_t g = result_.map.next[h];
        while (stamp_[g] != p && stamp_[g] != no_index - 1) g = result_.map.next[g ^ 1];
        return g;
    }

    [[nodiscard]] const Space& space_of(std::uint32_t p) const {
        const Region& region = stack_.regions[pieces_.region[p]];
        const Column& column = stack_.columns[stack_.region_columns[region.first_column]];
        return stack_.spaces[stack_.slices[column.first_slice].space];
    }

    void report_vanished(const std::vector<std::uint32_t>& vanished) {
        for (const std::uint32_t p : vanished) {
            const Space& space = space_of(p);
            findings_.push_back({.code = "P502",
                                 .severity = Severity::Warning,
                                 .sentence = "A piece of \"" + (space.name.empty() ? space.id : space.name) +
                                             "\" is thinner than the grid and vanishes.",
                                 .hint = "Use a finer grid (--snap-mm).",
                                 .elements = {{"space", space.id, space.name}}});
        }
    }

    const Stack& stack_;
    const CutPieces& pieces_;
    std::vector<Finding>& findings_;
    PlanGraph result_;
    std::vector<std::uint32_t> stamp_;    ///< [half-edge] the piece being traced
    std::vector<std::uint32_t> side_of_;  ///< [half-edge] its entry in edge_sides
};

}  // namespace

PlanGraph plan_graph(const Stack& stack, const CutPieces& pieces, std::vector<Finding>& findings) {
    return GraphBuilder(stack, pieces, findings).run();
}

}  // namespace enfilade::modeler
