#pragma once
// Whether a map is sound: T1 to T7 (README.md of this folder has the table).

#include <cstdint>
#include <vector>

#include "gmap/defect.h"
#include "gmap/map.h"

namespace enfilade::gmap {

/// What is wrong with a map. No defects: it is sound.
struct Validation {
    std::vector<Defect> defects;   ///< by code, then dimension and id of the blamed cell
    std::uint64_t suppressed = 0;  ///< findings left out because they show at a cell that is blamed already

    [[nodiscard]] bool is_sound() const noexcept { return defects.empty(); }
};

/// Checks T1 to T7, and that cell ids and orbits agree: one id per orbit, one orbit per id. Levels go in order; a
/// defect blames its cell and all cells incident to it (all cells of its connected piece where the piece is not
/// orientable), and what later levels find there is counted, not reported. A code is reported once per blamed cell.
///   T1  alpha_i, alpha_0 alpha_2, alpha_0 alpha_3, alpha_1 alpha_3 are involutions
///   T2  no dart is free
///   T3  each shell is orientable, and so is each connected piece
///   T4  a face bounds two volumes; on a shell an edge has two faces; a face or edge id has one orbit
///   T5  a volume has one shell; on a shell a vertex has one umbrella; a vertex id has one orbit
///   T6  no dangling edge or face, three or more edges a face, four or more faces a volume
///   T7  V - E + F = 2 on each shell; V - E + F - C = 0: where it is not, the vertices whose link is no sphere are
///   named
/// Reads the map only. Cost: linear, about 50 ns a dart on one core (README.md); sound maps allocate about 1 byte a
/// dart.
[[nodiscard]] Validation validate(const Map& map);

}  // namespace enfilade::gmap
