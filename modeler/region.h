#pragma once
// Connected places of the plan with the same columns.

#include <cstdint>
#include <vector>

#include "modeler/stack.h"
#include "plans/layout.h"

namespace enfilade::modeler {

/// Fills the regions, their boundaries and the planar graph of `stack` from the column over each face of the layout.
/// `band_columns`: [band][face], `UINT32_MAX` for face 0; a column belongs to one band. Points where a boundary
/// runs straight on (exactly, along one line, in all bands) are dissolved.
void find_regions(const plans::Layout& layout, const std::vector<std::vector<std::uint32_t>>& band_columns,
                  Stack& stack);

}  // namespace enfilade::modeler
