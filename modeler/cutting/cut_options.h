#pragma once
// How regions are cut, and what that is measured by.

#include <cstdint>

namespace enfilade::modeler {

enum class Convexifier : std::uint8_t {
    Sah,             ///< few cells, small portals (sah_partition.h)
    HertelMehlhorn,  ///< constrained Delaunay triangulation, diagonals taken out while pieces stay convex
    Diagonals,       ///< one convex piece after the other along the boundary (diagonal_partition.h)
};

/// The surface area heuristic of a room's cells (Maria, Horna, Aveneau 2013, section 6.2.1; MacDonald and Booth 1990):
/// a ray that crosses a convex body visits each convex part of it with a probability proportional to the part's
/// surface (Crofton), and pays there for the visit, for the sections that it tests and for the faces over them. The
/// defaults are measured (README.md of this folder, "The objective").
struct CutCost {
    double visit = 1;
    double section = 0.002;
    double face = 0;
};

struct CutOptions {
    bool convex = false;  ///< volumes that carry light are convex; else they are cut only as far as each is a ball
    Convexifier convexifier = Convexifier::Sah;
    CutCost cost = {};
};

}  // namespace enfilade::modeler
