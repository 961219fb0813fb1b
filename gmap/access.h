#pragma once
// For the operations of this folder only: unchecked writing. Whoever uses it restores the invariants of `Map`.

#include <array>

#include "gmap/map.h"

namespace enfilade::gmap::detail {

struct MapAccess {
    static MapArrays& arrays(Map& map) { return map.arrays_; }
    static std::uint32_t& alpha(Map& map, int i, DartId d) {
        return map.arrays_.alpha[static_cast<std::size_t>(i)][index(d)];
    }
    static std::uint32_t& cell(Map& map, int i, DartId d) {
        return map.arrays_.cell_id[static_cast<std::size_t>(i)][index(d)];
    }
    /// Makes alpha_i swap `a` and `b`; equal darts become i-free.
    static void link(Map& map, int i, DartId a, DartId b) {
        alpha(map, i, a) = static_cast<std::uint32_t>(b);
        alpha(map, i, b) = static_cast<std::uint32_t>(a);
    }
    /// A free dart with the cells of `like`, or with none.
    static DartId new_dart(Map& map, DartId like = none<DartId>);
    static void erase_dart(Map& map, DartId d);
    static std::uint32_t new_cell(Map& map, int i);
    static void drop_cell(Map& map, int i) { --map.cell_count_[static_cast<std::size_t>(i)]; }
    /// A map of arrays known to be in range and without gaps, with the numbers of cells in use.
    static Map adopt(MapArrays arrays, const std::array<std::size_t, 4>& cell_count);
};

}  // namespace enfilade::gmap::detail
