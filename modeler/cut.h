#pragma once
// Every region cut into the pieces over which volumes stand.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/partition.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

enum class Cutting {
    Discs,   ///< only as far as every volume is a ball
    Convex,  ///< volumes that carry light are convex as well
};

/// Pieces of regions. Segments are the edges of the plan, then the cuts; a half-edge is 2 * segment, + 1 where it is
/// run backwards.
struct CutPieces {
    std::vector<plans::GridPoint> points;
    std::vector<std::array<std::uint32_t, 2>> segments;  ///< into `points`
    std::uint32_t line_count = 0;            ///< lines below Stack::line_count are the plan's, the others cuts
    std::vector<std::uint32_t> region;       ///< [piece]
    std::vector<std::uint32_t> disc;         ///< [piece] the disc that it is cut from; discs ascend
    std::vector<std::uint32_t> disc_region;  ///< [disc]
    std::vector<std::uint32_t> first_side;   ///< [piece + 1] into `sides`
    std::vector<std::uint32_t> sides;        ///< half-edges around a piece, counter-clockwise
    std::vector<std::uint32_t> side_line;    ///< [side] the line it lies on
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(region.size()); }
    [[nodiscard]] std::span<const std::uint32_t> piece(std::uint32_t k) const {
        return std::span(sides).subspan(first_side[k], first_side[k + 1] - first_side[k]);
    }
};

/// First into discs, then each disc of a region that carries light into convex pieces: so pieces sum to the volume
/// that they were before.
[[nodiscard]] CutPieces cut(const Stack& stack, Cutting cutting);

struct PlanGraph;

/// Where rounding closed a strip, what is left around it may be no disc any more (`PlanGraph::tangled`): the pieces of
/// `graph` with those cut once more.
[[nodiscard]] CutPieces cut_tangled(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph,
                                    Cutting cutting);

}  // namespace enfilade::modeler
