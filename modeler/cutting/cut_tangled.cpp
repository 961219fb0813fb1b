// Pieces that rounding left in knots, cut once more.

#include <algorithm>
#include <map>

#include "modeler/cutting/cut.h"
#include "modeler/cutting/delaunay_partition.h"
#include "modeler/plan_graph.h"

namespace enfilade::modeler {
namespace {

/// Pieces over the edges of a graph: cuts get a segment and a line each, the same from both sides.
class PieceList {
public:
    explicit PieceList(CutPieces& pieces) : pieces_(pieces) {}

    void add(std::uint32_t region, std::uint32_t disc, std::span<const PolygonSide> ring) {
        pieces_.region.push_back(region);
        pieces_.disc.push_back(disc);
        for (const PolygonSide& side : ring) {
            pieces_.sides.push_back(side.tag);
            pieces_.side_line.push_back(side.line);
        }
        pieces_.first_side.push_back(std::uint32_t(pieces_.sides.size()));
    }

    void add_convex(std::uint32_t region, std::uint32_t disc, std::span<const plans::GridPoint> points,
                    std::span<const PolygonSide> ring) {
        Partition cells = delaunay_partition(points, ring, PartitionGoal::Convex);
        name_cuts(cells);
        for (std::uint32_t c = 0; c < cells.piece_count(); ++c) add(region, disc, cells.piece(c));
    }

    /// Tags and lines for the cuts of a partition along diagonals.
    void name_cuts(Partition& partition) {
        std::map<std::array<std::uint32_t, 2>, std::array<std::uint32_t, 2>> cuts;  // ends -> segment, line
        for (PolygonSide& side : partition.sides) {
            if (side.tag != cut_tag) continue;
            const std::array<std::uint32_t, 2> ends = {std::min(side.from, side.to), std::max(side.from, side.to)};
            const auto [at, is_new] = cuts.try_emplace(
                ends, std::array<std::uint32_t, 2>{std::uint32_t(pieces_.segments.size()), pieces_.line_count});
            if (is_new) {
                pieces_.segments.push_back(ends);
                ++pieces_.line_count;
            }
            side.tag = 2 * at->second[0] + (side.from == ends[0] ? 0 : 1);
            side.line = at->second[1];
        }
    }

private:
    CutPieces& pieces_;
};

bool is_dented(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, std::uint32_t p) {
    if (!stack.regions[pieces.region[graph.source[p]]].carries_light) return false;
    std::vector<RingCorner> corners;
    for (std::uint32_t k = graph.first_ring[p]; k < graph.first_ring[p + 1]; ++k)
        corners.push_back({graph.graph.vertices[plans::origin(graph.graph, graph.ring[k])], graph.ring_line[k]});
    return !is_convex(corners);
}

}  // namespace

bool needs_recut(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, bool convex) {
    if (!graph.tangled.empty()) return true;
    if (!convex) return false;
    for (std::uint32_t p = 0; p < graph.piece_count(); ++p)
        if (is_dented(stack, pieces, graph, p)) return true;
    return false;
}

CutPieces cut_tangled(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, bool convex) {
    const std::vector<plans::GridPoint>& points = graph.graph.vertices;
    CutPieces again;
    again.points = points;
    for (const plans::NodedEdge& edge : graph.graph.edges) again.segments.push_back({edge.a, edge.b});
    again.line_count = pieces.line_count;
    again.disc_region = pieces.disc_region;
    PieceList list(again);
    std::vector<PolygonSide> sides;
    const auto side_of = [&](std::uint32_t h, std::uint32_t line) {
        return PolygonSide{plans::origin(graph.graph, h), plans::origin(graph.graph, h ^ 1), line, h};
    };
    for (std::uint32_t p = 0; p < graph.piece_count(); ++p) {
        sides.clear();
        for (std::uint32_t k = graph.first_ring[p]; k < graph.first_ring[p + 1]; ++k)
            sides.push_back(side_of(graph.ring[k], graph.ring_line[k]));
        const std::uint32_t region = pieces.region[graph.source[p]], disc = pieces.disc[graph.source[p]];
        if (convex && is_dented(stack, pieces, graph, p)) list.add_convex(region, disc, points, sides);
        else list.add(region, disc, sides);
    }
    for (const TangledPiece& tangled : graph.tangled) {
        const std::uint32_t region = pieces.region[tangled.source], disc = pieces.disc[tangled.source];
        sides.clear();
        for (const auto& [h, line] : tangled.sides) sides.push_back(side_of(h, line));
        Partition discs = delaunay_partition(points, sides, PartitionGoal::Disc);
        list.name_cuts(discs);
        for (std::uint32_t d = 0; d < discs.piece_count(); ++d) {
            if (!convex || !stack.regions[region].carries_light) {
                list.add(region, disc, discs.piece(d));
                continue;
            }
            list.add_convex(region, disc, points, discs.piece(d));
        }
    }
    return again;
}

}  // namespace enfilade::modeler
