#pragma once
// Pieces with their columns -> volumes and faces.

#include <cstdint>
#include <vector>

#include "gmap/cell_tuples.h"
#include "modeler/building.h"
#include "modeler/cutting/cut.h"
#include "modeler/plan_graph.h"
#include "modeler/stack.h"

namespace enfilade::modeler {

struct Extrusion {
    std::vector<Volume> volumes;  ///< `Outside` last
    std::vector<Face> faces;
    std::vector<std::array<std::int32_t, 3>> vertices;
    gmap::CellTuples tuples;  ///< by the ids of `faces`, `volumes` and `vertices`
};

/// Raises the pieces over their bands. Volumes in the order of pieces, then upward; air and ground that go on through
/// several bands are one volume there. Cost: linear in what comes out, times the log of the levels at one point.
[[nodiscard]] Extrusion extrude(const Stack& stack, const CutPieces& pieces, const PlanGraph& graph);

}  // namespace enfilade::modeler
