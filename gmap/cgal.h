#pragma once
// To and from CGAL's Linear_cell_complex_for_generalized_map<3, 3>, for those who use both. This header names no CGAL
// type: it works on any cell complex with CGAL's interface, which the caller has included. Link enfilade::gmap_cgal
// (CMake option ENFILADE_CGAL_MAPS).

#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

#include "gmap/access.h"
#include "gmap/map.h"
#include "gmap/update.h"

namespace enfilade::gmap {

namespace detail {

template <unsigned int I, class Complex, class Handles>
void link_cgal_darts(const Map& map, const Handles& handles, Complex& complex) {
    for (const DartId d : map.darts())
        if (const DartId e = map.alpha<static_cast<int>(I)>(d); index(d) < index(e))
            complex.template basic_link_alpha<I>(handles[index(d)], handles[index(e)]);
}

template <unsigned int I, class Complex, class Numbers>
void read_cgal_links(const Complex& complex, const Numbers& numbers, MapArrays& arrays) {
    std::uint32_t d = 0;
    for (auto it = complex.darts().begin(); it != complex.darts().end(); ++it, ++d)
        arrays.alpha[I][d] = complex.template is_free<I>(it) ? d : numbers.at(&*complex.template alpha<I>(it));
}

}  // namespace detail

/// Adds a copy of the map to `complex`. `points`: [at least cell_bound<0>()] by vertex id.
/// Returns the handle of each dart: [dart_bound()], default handles for gaps. Other attributes do not travel.
/// \post complex.is_valid() if the map has T1 and one orbit per vertex id.
template <class Complex>
std::vector<typename Complex::Dart_handle> to_cgal(const Map& map, std::span<const std::array<double, 3>> points,
                                                   Complex& complex) {
    if (points.size() < map.cell_bound<0>()) throw std::invalid_argument("Each vertex of the map needs a point.");
    std::vector<typename Complex::Dart_handle> handles(map.dart_bound());
    for (const DartId d : map.darts()) handles[index(d)] = complex.create_dart();
    detail::link_cgal_darts<0>(map, handles, complex);
    detail::link_cgal_darts<1>(map, handles, complex);
    detail::link_cgal_darts<2>(map, handles, complex);
    detail::link_cgal_darts<3>(map, handles, complex);
    const std::vector<DartId> at_vertex = map.representatives<0>();
    for (std::size_t v = 0; v < at_vertex.size(); ++v) {
        if (at_vertex[v] == none<DartId>) continue;
        const typename Complex::Point point(points[v][0], points[v][1], points[v][2]);
        complex.set_vertex_attribute(handles[index(at_vertex[v])], complex.create_vertex_attribute(point));
    }
    return handles;
}

/// The map of a complex: dart k is the k-th in the order of complex.darts(). Cell ids follow from the orbits, in the
/// order of their first darts. `points`, if given, receives the point of each vertex, by id; every vertex needs one
/// then.
template <class Complex>
[[nodiscard]] Map from_cgal(const Complex& complex, std::vector<std::array<double, 3>>* points = nullptr) {
    std::unordered_map<const void*, std::uint32_t> numbers;
    std::uint32_t count = 0;
    for (auto it = complex.darts().begin(); it != complex.darts().end(); ++it) numbers.emplace(&*it, count++);
    MapArrays arrays;
    for (std::size_t i = 0; i < 4; ++i) {
        arrays.alpha[i].resize(count);
        arrays.cell_id[i].assign(count, detail::none_u32);
    }
    detail::read_cgal_links<0>(complex, numbers, arrays);
    detail::read_cgal_links<1>(complex, numbers, arrays);
    detail::read_cgal_links<2>(complex, numbers, arrays);
    detail::read_cgal_links<3>(complex, numbers, arrays);
    Map map = detail::MapAccess::adopt(std::move(arrays), {});
    detail::number_cells(map);
    if (points != nullptr) {
        points->assign(map.cell_bound<0>(), {});
        std::uint32_t d = 0;
        for (auto it = complex.darts().begin(); it != complex.darts().end(); ++it, ++d) {
            const auto& point = complex.point(it);
            for (int axis = 0; axis < 3; ++axis)
                (*points)[index(map.vertex(DartId{d}))][static_cast<std::size_t>(axis)] = point[axis];
        }
    }
    return map;
}

}  // namespace enfilade::gmap
