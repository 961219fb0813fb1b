#pragma once
// Inside of accel: building the point locator's boxes.

#include <vector>

#include "accel/scene.h"

namespace enfilade::accel::detail {

struct Locator {
    std::vector<LocatorNode> nodes;
    std::vector<CellId> cells;
};

inline constexpr std::uint32_t locator_leaf_cells = 4;

/// Halves the cells at the median of their boxes' centres along the longer side until four are left.
/// Deterministic; n log n. \pre cells and section_x, section_y of the view are set
[[nodiscard]] Locator build_locator(const SceneView& view);

}  // namespace enfilade::accel::detail
