#pragma once
// For `validate` only: telling what dangles from what is glued to itself.

#include <cstdint>
#include <span>
#include <vector>

#include "gmap/map.h"

namespace enfilade::gmap::detail {

/// A cell that has the same cell on both sides.
struct SelfNeighbour {
    std::uint32_t cell;
    std::uint32_t dart;
    bool is_dangling;
};

/// The faces of the given darts, ascending. One dangles if, once those that dangle from it are gone, it is alone at an
/// edge.
[[nodiscard]] std::vector<SelfNeighbour> judge_faces(const Map& map, std::span<const std::uint32_t> one_volume_darts);

/// The edges of the given darts, ascending. One dangles if, once those that dangle from it are gone, it is alone at an
/// end.
[[nodiscard]] std::vector<SelfNeighbour> judge_edges(const Map& map, std::span<const std::uint32_t> one_face_darts);

}  // namespace enfilade::gmap::detail
