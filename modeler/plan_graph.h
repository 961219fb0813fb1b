#pragma once
// All pieces of all bands on one planar graph with integer points.

#include <cstdint>
#include <span>
#include <vector>

#include "base/finding.h"
#include "modeler/cut.h"
#include "modeler/stack.h"
#include "plans/planar_map.h"

namespace enfilade::modeler {

/// A piece on one side of an edge.
struct EdgeSide {
    std::uint32_t piece = 0;
    bool right = false;
};

/// The pieces after the second snap rounding: where a cut of one band crosses an edge of another, both got a point.
struct PlanGraph {
    plans::NodedGraph graph;
    plans::PlanarMap map;
    std::vector<std::uint32_t> line;             ///< [edge] below Stack::lines.size(): of the plan; from there on: cuts
    std::vector<std::uint32_t> first_edge_side;  ///< [edge + 1]
    std::vector<EdgeSide> edge_sides;            ///< pieces beside an edge, at most one per side and band
    std::vector<std::uint32_t> source;           ///< [piece] into CutPieces
    std::vector<std::uint32_t> first_ring;       ///< [piece + 1] into `ring`
    std::vector<std::uint32_t> ring;             ///< half-edges around a piece, counter-clockwise
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(source.size()); }
    [[nodiscard]] std::span<const std::uint32_t> piece(std::uint32_t k) const {
        return std::span(ring).subspan(first_ring[k], first_ring[k + 1] - first_ring[k]);
    }
};

/// Pieces that rounding splits become several, pieces that vanish are left out: P501 and P502 in `findings`.
[[nodiscard]] PlanGraph plan_graph(const Stack& stack, const CutPieces& pieces, std::vector<Finding>& findings);

}  // namespace enfilade::modeler
