#pragma once
// The lamps of each cell for tracers that have no cells: Embree, and the trees that cards are compared with.

#include <cstdint>
#include <vector>

#include "accel/lights/light_trees.h"
#include "accel/scene.h"

namespace enfilade::render {

/// Which lamps are asked for at a place of each cell: those that the cell may see, each once.
struct LampLists {
    std::vector<std::uint32_t> offsets;  ///< [cell_count + 1]
    std::vector<std::uint32_t> lamps;    ///< LightIds, ascending in each cell
};
/// Those of the light trees.
[[nodiscard]] LampLists lamp_lists(const accel::LightTreesView& trees);
/// Every lamp that stands in a cell, for every cell: what a tracer without lists asks for.
[[nodiscard]] LampLists all_lamps(const accel::SceneView& scene);

}  // namespace enfilade::render
