#pragma once
// Every region cut into the pieces over which volumes stand.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "modeler/cutting/cut_options.h"
#include "modeler/cutting/polygon.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

/// A region cut, by itself: first into discs, then each disc of a region that carries light into convex pieces, so that
/// pieces sum to the volume that they were before. Points count the region's own, then the new ones.
struct RegionCut {
    std::vector<std::uint32_t> points;         ///< into Stack::points
    std::vector<plans::GridPoint> new_points;  ///< on edges of the stack, on cuts
    std::vector<PolygonSide> sides;            ///< tag: a half-edge of the stack; `first_disc_cut` + half-edge of one
    std::vector<std::uint32_t> first_side = {0};          ///< [piece + 1] into `sides`
    std::vector<std::uint32_t> disc;                      ///< [piece] ascending
    std::vector<std::array<std::uint32_t, 2>> disc_cuts;  ///< the cuts between discs
    std::uint32_t disc_count = 0;
    std::uint32_t moved = 0;        ///< as in Partition
    std::uint32_t fallen_back = 0;  ///< as in Partition
};
inline constexpr std::uint32_t first_disc_cut = 1u << 31;
inline constexpr std::uint32_t first_disc_line = 1u << 30;  ///< lines of RegionCut: plan, discs, `first_cut_line`

/// Pieces of regions. Segments are the edges of the plan (in several parts where cuts end on them), then the cuts; a
/// half-edge is 2 * segment, + 1 where it is run backwards.
struct CutPieces {
    std::vector<plans::GridPoint> points;
    std::vector<std::array<std::uint32_t, 2>> segments;  ///< into `points`
    std::uint32_t line_count = 0;                 ///< lines below Stack::line_count are the plan's, the others cuts
    std::vector<std::uint32_t> region;            ///< [piece]
    std::vector<std::uint32_t> disc;              ///< [piece] the disc that it is cut from; discs ascend
    std::vector<std::uint32_t> disc_region;       ///< [disc]
    std::vector<std::uint32_t> first_side = {0};  ///< [piece + 1] into `sides`
    std::vector<std::uint32_t> sides;             ///< half-edges around a piece, counter-clockwise
    std::vector<std::uint32_t> side_line;         ///< [side] the line it lies on
    [[nodiscard]] std::uint32_t piece_count() const { return std::uint32_t(region.size()); }
    [[nodiscard]] std::span<const std::uint32_t> piece(std::uint32_t k) const {
        return std::span(sides).subspan(first_side[k], first_side[k + 1] - first_side[k]);
    }
};

/// All that the cut of a region depends on, besides the options.
struct RegionPolygon {
    std::vector<std::uint32_t> points;  ///< into Stack::points, ascending
    std::vector<PolygonSide> sides;     ///< in the order of Stack::boundary; from, to: into `points`; tag: a half-edge
    std::int32_t height = 0;            ///< grid units, over all bands
    bool carries_light = false;
};

/// Cuts single regions of a stack, each alike wherever and whenever it is cut.
class RegionCutter {
public:
    RegionCutter(const Stack& stack, const CutOptions& options);
    [[nodiscard]] RegionCut cut(std::uint32_t region) const { return cut(polygon(region)); }
    [[nodiscard]] RegionPolygon polygon(std::uint32_t region) const;
    [[nodiscard]] RegionCut cut(RegionPolygon polygon) const;
    /// Whether the region is the same in the other's stack, number by number, and so is its cut by the same options.
    [[nodiscard]] bool same_in(const RegionCutter& other, std::uint32_t region) const;

private:
    const Stack& stack_;
    CutOptions options_;
    std::vector<std::uint32_t> look_;   ///< [Stack::boundary]
    std::vector<std::uint32_t> faces_;  ///< [Stack::boundary]
};

/// All regions, on the cores of `executor`.
[[nodiscard]] std::vector<RegionCut> cut_regions(const Stack& stack, const CutOptions& options,
                                                 const accel::Executor& executor);

/// The cuts of all regions put together: an edge on which cuts of both its sides end is one chain for both.
[[nodiscard]] CutPieces join_cuts(const Stack& stack, std::span<const RegionCut> cuts);

struct PlanGraph;

/// Whether rounding left pieces in knots (`PlanGraph::tangled`) or, where they were to be convex, dented.
[[nodiscard]] bool needs_recut(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, bool convex);

/// Where rounding closed a strip, what is left around it may be no disc any more, and where the cuts of another band
/// end on a side, it may bend too much to be convex: the pieces of `graph` with those cut once more, along diagonals.
[[nodiscard]] CutPieces cut_tangled(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph, bool convex);

}  // namespace enfilade::modeler
