#pragma once
// Cuts of regions that an edit leaves as they are.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/parallel_for.h"
#include "modeler/cutting/cut.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

struct ReusedCuts {
    std::vector<RegionCut> cuts;           ///< [after.regions.size()]
    std::vector<std::uint32_t> cut_again;  ///< regions of `after`, ascending
};

/// The cuts of `after`: a region that looks to the cutter as some region of `before` does (same points, sides, lines in
/// the same order, same neighbours) gets that one's, in new numbers; the others are cut, on the cores of `executor`.
/// The result is what `cut_regions(after, ...)` gives. \pre cuts: of `before`, by the same options. Cost: linear, and
/// the new cuts.
[[nodiscard]] ReusedCuts reuse_cuts(const Stack& before, std::span<const RegionCut> cuts, const Stack& after,
                                    const CutOptions& options, const accel::Executor& executor);

}  // namespace enfilade::modeler
