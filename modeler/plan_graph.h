#pragma once
// All pieces of all bands on one planar graph with integer points.

#include <cstdint>
#include <span>
#include <vector>

#include "base/finding.h"
#include "modeler/cutting/cut.h"
#include "modeler/stack.h"
#include "plans/planar_map.h"

namespace enfilade::modeler {

/// A piece on one side of an edge.
struct EdgeSide {
    std::uint32_t piece = 0;
    bool right = false;
    std::uint32_t line = 0;  ///< of the piece's own side: segments that rounding lays onto each other keep their lines
};

/// A piece that is no disc after rounding: its half-edges with their lines, in no order.
struct TangledPiece {
    std::uint32_t source = 0;  ///< into CutPieces
    std::vector<std::array<std::uint32_t, 2>> sides;
};

/// The pieces after the second snap rounding: where a cut of one band crosses an edge of another, both got a point.
struct PlanGraph {
    plans::NodedGraph graph;
    plans::PlanarMap map;
    std::vector<std::uint32_t> first_edge_side;  ///< [edge + 1]
    std::vector<EdgeSide> edge_sides;            ///< pieces beside an edge, at most one per side and band
    std::vector<std::uint32_t> source;           ///< [piece] into CutPieces
    std::vector<std::uint32_t> first_ring;       ///< [piece + 1] into `ring`
    std::vector<std::uint32_t> ring;             ///< half-edges around a piece, counter-clockwise
    std::vector<std::uint32_t> ring_line;        ///< [ring] below Stack::line_count: of the plan; from there on: cuts
    std::vector<TangledPiece> tangled;           ///< not among the pieces
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(source.size()); }
    [[nodiscard]] std::span<const std::uint32_t> piece(std::uint32_t k) const {
        return std::span(ring).subspan(first_ring[k], first_ring[k + 1] - first_ring[k]);
    }
};

/// Pieces that rounding splits become several, pieces that vanish are left out: P501 and P502 in `findings`.
[[nodiscard]] PlanGraph plan_graph(const Stack& stack, const CutPieces& pieces, std::vector<Finding>& findings);

}  // namespace enfilade::modeler
