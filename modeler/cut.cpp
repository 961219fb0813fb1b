#include "modeler/cut.h"

#include <algorithm>
#include <map>

#include "modeler/plan_graph.h"

namespace enfilade::modeler {
namespace {

/// Collects pieces, and gives cuts their segment: the same from both sides, and a line each.
class PieceList {
public:
    explicit PieceList(CutPieces& pieces) : pieces_(pieces) { pieces_.first_side.assign(1, 0); }

    /// Cuts of one polygon: its points name them.
    void name_cuts(Partition& partition) {
        for (PolygonSide& side : partition.sides) {
            if (side.tag != cut_tag) continue;
            const std::array<std::uint32_t, 2> ends = {std::min(side.from, side.to), std::max(side.from, side.to)};
            const auto [at, is_new] = cut_ids_.try_emplace(ends, std::uint32_t(pieces_.segments.size()));
            if (is_new) {
                pieces_.segments.push_back(ends);
                cut_line_.push_back(pieces_.line_count++);
                first_cut_ = std::min(first_cut_, at->second);
            }
            side.tag = 2 * at->second + (side.from == ends[0] ? 0 : 1);
            side.line = cut_line_[at->second - first_cut_];
        }
    }
    void forget_cuts() { cut_ids_.clear(); }

    void add(std::uint32_t region, std::uint32_t disc, std::span<const PolygonSide> ring) {
        pieces_.region.push_back(region);
        pieces_.disc.push_back(disc);
        for (const PolygonSide& side : ring) {
            pieces_.sides.push_back(side.tag);
            pieces_.side_line.push_back(side.line);
        }
        pieces_.first_side.push_back(std::uint32_t(pieces_.sides.size()));
    }

private:
    CutPieces& pieces_;
    std::uint32_t first_cut_ = UINT32_MAX;  ///< segment
    std::vector<std::uint32_t> cut_line_;   ///< [cut]
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> cut_ids_;
};

void cut_disc(std::span<const plans::GridPoint> points, std::span<const PolygonSide> ring, std::uint32_t region,
              std::uint32_t disc, bool to_convex, PieceList& list) {
    if (!to_convex) {
        list.add(region, disc, ring);
        return;
    }
    Partition convex = partition(points, ring, PartitionGoal::Convex);
    list.name_cuts(convex);
    for (std::uint32_t c = 0; c < convex.piece_count(); ++c) list.add(region, disc, convex.piece(c));
}

void cut_region(const Stack& stack, std::uint32_t r, Cutting cutting, CutPieces& pieces, PieceList& list) {
    const Region& region = stack.regions[r];
    std::vector<PolygonSide> boundary;
    boundary.reserve(region.half_edge_count);
    for (std::uint32_t k = 0; k < region.half_edge_count; ++k) {
        const std::uint32_t h = stack.boundary[region.first_half_edge + k];
        const StackEdge& edge = stack.edges[h / 2];
        boundary.push_back(h % 2 == 0 ? PolygonSide{edge.a, edge.b, edge.line, h}
                                      : PolygonSide{edge.b, edge.a, edge.line, h});
    }
    if (boundary.empty()) return;
    list.forget_cuts();
    Partition discs = partition(stack.points, boundary, PartitionGoal::Disc);
    list.name_cuts(discs);
    for (std::uint32_t d = 0; d < discs.piece_count(); ++d) {
        pieces.disc_region.push_back(r);
        cut_disc(stack.points, discs.piece(d), r, std::uint32_t(pieces.disc_region.size() - 1),
                 cutting == Cutting::Convex && region.carries_light, list);
    }
}

}  // namespace

CutPieces cut(const Stack& stack, Cutting cutting) {
    CutPieces pieces;
    pieces.points = stack.points;
    for (const StackEdge& edge : stack.edges) pieces.segments.push_back({edge.a, edge.b});
    pieces.line_count = stack.line_count;
    PieceList list(pieces);
    for (std::uint32_t r = 0; r < stack.regions.size(); ++r) cut_region(stack, r, cutting, pieces, list);
    return pieces;
}

CutPieces cut_tangled(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, Cutting cutting) {
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
        list.add(pieces.region[graph.source[p]], pieces.disc[graph.source[p]], sides);
    }
    for (const TangledPiece& tangled : graph.tangled) {
        const std::uint32_t region = pieces.region[tangled.source], disc = pieces.disc[tangled.source];
        sides.clear();
        for (const auto& [h, line] : tangled.sides) sides.push_back(side_of(h, line));
        list.forget_cuts();
        Partition discs = partition(points, sides, PartitionGoal::Disc);
        list.name_cuts(discs);
        for (std::uint32_t d = 0; d < discs.piece_count(); ++d)
            cut_disc(points, discs.piece(d), region, disc,
                     cutting == Cutting::Convex && stack.regions[region].carries_light, list);
    }
    return again;
}

}  // namespace enfilade::modeler
