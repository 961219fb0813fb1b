#pragma once
// Vertices that lie at one place, as one.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace enfilade::modeler {

/// [vertex count]: the lowest vertex with the same coordinates (-0 is 0). \pre no coordinate is NaN
/// Cost: n log n. The same whatever the order of equal vertices.
[[nodiscard]] std::vector<std::uint32_t> vertex_places(std::span<const std::array<float, 3>> vertices);

}  // namespace enfilade::modeler
