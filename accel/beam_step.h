#pragma once
// A beam where it enters a cell, and its place in the tree of all of them.

#include <cstdint>

#include "accel/beam_height.h"
#include "accel/beam_plan.h"
#include "accel/scene.h"

namespace enfilade::accel {

/// A beam behind the portals that it has crossed.
struct Beam {
    PlanBeam plan;
    HeightBeam height;
    bool has_gate = false;  ///< false: straight above or below its source, or widened at a floor or ceiling; then the
                            ///< heights are those at the source, and the next three mean nothing
    Gate gate;              ///< the last portal in a side: where it ends in the plan,
    Interval opening;       ///< how high it opens, with the margin (grid units),
    RealSegment lit;        ///< and what the beam lights of it
};

/// One cell that a beam gets to. Steps form a tree: the same cell comes once for each way that beams get there.
struct BeamStep {
    CellId cell = {};
    CellId from = none<CellId>;        ///< where the beam comes from
    PortalId portal = none<PortalId>;  ///< through which; none at the source
    bool is_level = false;             ///< the portal is a floor or a ceiling
    bool is_widened = false;           ///< stands for several beams, and perhaps for more than they are
    std::uint32_t depth = 0;           ///< portals crossed
    std::uint32_t number = 0;          ///< steps are counted from 0, parents before children
    std::uint32_t parent = 0;          ///< number of the step it continues; its own at the source
    Beam beam;
};

}  // namespace enfilade::accel
