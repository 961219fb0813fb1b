#include "modeler/cut.h"

#include <map>

namespace enfilade::modeler {
namespace {

class Cutter {
public:
    Cutter(const Stack& stack, Cutting cutting) : stack_(stack), cutting_(cutting) { pieces_.first_side.push_back(0); }

    CutPieces run() {
        for (std::uint32_t r = 0; r < stack_.regions.size(); ++r) cut_region(r);
        return std::move(pieces_);
    }

private:
    void cut_region(std::uint32_t r) {
        const Region& region = stack_.regions[r];
        std::vector<PolygonSide> boundary;
        boundary.reserve(region.half_edge_count);
        for (std::uint32_t k = 0; k < region.half_edge_count; ++k) {
            const std::uint32_t h = stack_.boundary[region.first_half_edge + k];
            const StackEdge& edge = stack_.edges[h / 2];
            boundary.push_back(h % 2 == 0 ? PolygonSide{edge.a, edge.b, edge.line, h}
                                          : PolygonSide{edge.b, edge.a, edge.line, h});
        }
        if (boundary.empty()) return;
        cut_ids_.clear();
        Partition discs = partition(stack_.points, boundary, PartitionGoal::Disc);
        name_cuts(discs);
        for (std::uint32_t d = 0; d < discs.piece_count(); ++d) {
            pieces_.disc_region.push_back(r);
            if (cutting_ == Cutting::Convex && region.carries_light) {
                Partition convex = partition(stack_.points, discs.piece(d), PartitionGoal::Convex);
                name_cuts(convex);
                for (std::uint32_t c = 0; c < convex.piece_count(); ++c) add_piece(r, convex.piece(c));
            } else {
                add_piece(r, discs.piece(d));
            }
        }
    }

    /// Gives new cuts their segment, the same from both sides, and a line each.
    void name_cuts(Partition& partition) {
        for (PolygonSide& side : partition.sides) {
            if (side.tag != cut_tag) continue;
            const std::array<std::uint32_t, 2> ends = {std::min(side.from, side.to), std::max(side.from, side.to)};
            const auto [at, is_new] = cut_ids_.try_emplace(ends, std::uint32_t(pieces_.cuts.size()));
            if (is_new) pieces_.cuts.push_back(ends);
            const std::uint32_t segment = std::uint32_t(stack_.edges.size()) + at->second;
            side.tag = 2 * segment + (side.from == ends[0] ? 0 : 1);
            side.line = std::uint32_t(stack_.lines.size()) + at->second;
        }
    }

    void add_piece(std::uint32_t region, std::span<const PolygonSide> ring) {
        pieces_.region.push_back(region);
        pieces_.disc.push_back(std::uint32_t(pieces_.disc_region.size() - 1));
        for (const PolygonSide& side : ring) pieces_.sides.push_back(side.tag);
        pieces_.first_side.push_back(std::uint32_t(pieces_.sides.size()));
    }

    const Stack& stack_;
    Cutting cutting_;
    CutPieces pieces_;
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> cut_ids_;  ///< of the region at hand
};

}  // namespace

CutPieces cut(const Stack& stack, Cutting cutting) { return Cutter(stack, cutting).run(); }

}  // namespace enfilade::modeler
