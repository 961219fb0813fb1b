#pragma once
// Gluing cells together, and taking them apart.

#include <optional>

#include "gmap/changes.h"
#include "gmap/map.h"

namespace enfilade::gmap {

namespace detail {
[[nodiscard]] bool is_sewable(const Map& map, int i, DartId d, DartId e);
[[nodiscard]] std::optional<Changes> sew(Map& map, int i, DartId d, DartId e);
[[nodiscard]] std::optional<Changes> unsew(Map& map, int i, DartId d);
}  // namespace detail

/// Whether sew<I>(d, e) would do: all darts that have to be linked are I-free, and the orbits of `d` and `e` under the
/// involutions that commute with alpha<I> are two and match dart by dart. sew<3> glues two whole faces, sew<2> two
/// edges.
template <int I>
[[nodiscard]] bool is_sewable(const Map& map, DartId d, DartId e) {
    static_assert(0 <= I && I <= 3);
    return detail::is_sewable(map, I, d, e);
}

/// Links `d` and `e`, and with them their whole orbits, by alpha<I>; the cells that meet become one.
/// Without an answer, and without any change, where `is_sewable` says no. \post alpha<I>(d) == e; T1 holds if it held.
template <int I>
[[nodiscard]] std::optional<Changes> sew(Map& map, DartId d, DartId e) {
    static_assert(0 <= I && I <= 3);
    return detail::sew(map, I, d, e);
}

/// Makes the orbit that was sewn with `d` I-free again, on both sides; cells that fall apart are split.
/// Without an answer where `d` is I-free already. \post unsew then sew gives an isomorphic map.
template <int I>
[[nodiscard]] std::optional<Changes> unsew(Map& map, DartId d) {
    static_assert(0 <= I && I <= 3);
    return detail::unsew(map, I, d);
}

}  // namespace enfilade::gmap
