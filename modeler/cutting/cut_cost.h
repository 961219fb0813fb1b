#pragma once
// What a partition costs the rays that walk through it.

#include <cstdint>

#include "modeler/cutting/polygon.h"

namespace enfilade::modeler {

/// The surface area heuristic of a room's cells (Maria, Horna, Aveneau 2013, section 6.2.1; MacDonald and Booth 1990):
/// a ray that crosses a convex body visits each convex part of it with a probability proportional to the part's
/// surface (Crofton), and pays there for the visit, for the sections that it tests and for the faces over them. The
/// defaults are measured (README.md of this folder, "The objective").
struct CutCost {
    double visit = 1;
    double section = 0.1;
    double face = 0.02;
};

/// Sum over the pieces of surface (m2; walls over `height`, floor and ceiling) times cost, over the polygon's own
/// surface: the expected cost of a ray, in visits. `unit`: metres per grid unit.
[[nodiscard]] double sah_sum(std::span<const plans::GridPoint> points, const Partition& partition, double unit,
                             double height, const CutCost& cost);

}  // namespace enfilade::modeler
