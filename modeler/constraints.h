#pragma once
// The constraints of 2-model, a function each; `check` calls them in order.

#include <cstdint>
#include <vector>

#include "modeler/building.h"
#include "modeler/check.h"

namespace enfilade::modeler {

/// Cells of the map that a finding blames already: later checks skip them, so that one fault is one finding.
struct Blame {
    std::vector<bool> volume;  ///< [volume]
    std::vector<bool> face;    ///< [face]
    bool whole_map = false;    ///< the topology is broken where no single cell can be blamed
    [[nodiscard]] bool any() const;
};

/// T1-T7: closed, oriented quasi-manifold of balls; by `gmap::validate` and the defects of the map's builder.
void check_topology(const Building& building, Blame& blame, CheckReport& report);

/// G5: every volume positive, the hull the site box, and the volumes sum to it exactly: no overlap, no gap.
void check_partition(const Building& building, Blame& blame, CheckReport& report);

/// G8: no cell has a reflex corner between different lines, none strays from a line by more than one grid unit, and
/// pieces sum to the volume that they are cut from.
void check_convexity(const Building& building, Blame& blame, CheckReport& report);

/// D2: portals and map agree: each face between two cells is a portal or a leaf, each portal joins the cells it names.
void check_portals(const Building& building, Blame& blame, CheckReport& report);

}  // namespace enfilade::modeler
