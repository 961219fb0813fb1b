#pragma once
// Small closed complexes to build maps from: for tests, benchmarks and first steps.

#include <cstdint>

#include "gmap/cell_tuples.h"

namespace enfilade::gmap {

/// A right prism over a polygon of `corner_count` (>= 3), volume 0, in its outside, volume 1: a closed map.
/// Vertices: bottom ring 0 ... n-1, top ring n ... 2n-1. Faces: bottom 0, top 1, side k (above edge k, k+1) 2 + k.
/// Throws std::invalid_argument for fewer corners.
[[nodiscard]] CellTuples prism_tuples(std::uint32_t corner_count);

/// The prism over a square: a cube and its outside.
[[nodiscard]] CellTuples hexahedron_tuples();

/// nx * ny * nz hexahedra side by side, and their outside as the last volume: a closed map of about 48 darts per
/// hexahedron. Volume (i, j, k) is (k * ny + j) * nx + i; vertices likewise, of (nx+1) * (ny+1) * (nz+1). All counts at
/// least 1.
[[nodiscard]] CellTuples grid_tuples(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz);

/// The same grid wrapped around in all three directions, without outside: a 3-torus, or, where `flipped`, its
/// non-orientable cousin, where going around in x mirrors y. All counts at least 3, else volumes would touch
/// themselves.
[[nodiscard]] CellTuples wrapped_grid_tuples(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz,
                                             bool flipped = false);

}  // namespace enfilade::gmap
