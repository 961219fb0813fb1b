#pragma once
// The same map in CGAL's kernel, for the benchmark: its translation unit is the only one of tools that sees CGAL.

#include "gmap/map.h"

namespace enfilade::tools {

struct CgalFigures {
    double validate_seconds = 0;
    double bytes_per_dart = 0;
    bool is_valid = false;
};

/// Converts `map` to a Linear_cell_complex_for_generalized_map<3, 3> and measures its is_valid().
[[nodiscard]] CgalFigures measure_cgal(const gmap::Map& map, int runs);

}  // namespace enfilade::tools
