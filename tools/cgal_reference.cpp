#include "tools/cgal_reference.h"

#include <CGAL/Linear_cell_complex_for_generalized_map.h>

#include "gmap/cgal.h"
#include "tools/bench.h"

namespace enfilade::tools {

CgalFigures measure_cgal(const gmap::Map& map, int runs) {
    CGAL::Linear_cell_complex_for_generalized_map<3, 3> complex;
    const std::vector<std::array<double, 3>> points(map.cell_bound<0>());
    (void)gmap::to_cgal(map, std::span<const std::array<double, 3>>(points), complex);
    CgalFigures figures;
    figures.bytes_per_dart = double(complex.bytes()) / double(map.dart_count());
    figures.validate_seconds = median_seconds(runs, [&] { figures.is_valid = complex.is_valid(); });
    return figures;
}

}  // namespace enfilade::tools
