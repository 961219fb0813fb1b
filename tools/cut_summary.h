#pragma once
// Into what the spaces of a scene are cut, and what that costs the rays.

#include <cstddef>
#include <vector>

#include "accel/scene.h"
#include "modeler/cutting/cut_cost.h"

namespace enfilade::tools {

/// The cells of a space together.
struct SpaceCuts {
    std::size_t cells = 0;
    std::size_t sections = 0;  ///< of all its cells
    std::size_t faces = 0;     ///< of all those sections
    double cut_area_m2 = 0;    ///< of the virtual portals between two of its cells
    double sah_sum = 0;        ///< modeler::sah_sum over its cells, in visits; 0 for spaces that are no rooms
};

/// [space_count] \pre rooms are prisms (they come from `modeler::export_scene`).
[[nodiscard]] std::vector<SpaceCuts> cuts_per_space(const accel::SceneView& scene, const modeler::CutCost& cost = {});

/// m2 of all virtual portals: cuts, and borders between rooms that no wall parts.
[[nodiscard]] double virtual_area(const accel::SceneView& scene);

}  // namespace enfilade::tools
