#pragma once
// The triangles of a flat polygon.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modeler/catalogue/own/vec.h"

namespace enfilade::modeler::own {

/// Triangles over a simple, nearly flat polygon, in its direction of rotation: corners by their number in `ring`.
/// Ears of the best shape first, so that lids of many corners have no needles that others could avoid. Cubic time.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> lid(std::span<const Vec> ring);

}  // namespace enfilade::modeler::own
