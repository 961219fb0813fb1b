#pragma once
// Flat rings cut into triangles, exactly.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace enfilade::modeler {

using GridPoint2 = std::array<std::int64_t, 2>;

/// Triangles of a simple ring that runs counter-clockwise, as indices into it: ring.size() - 2 of them, each
/// counter-clockwise and of positive area, using every corner (also those on a straight side). Where the ring is not
/// simple, corners that cannot be cut off properly are cut off all the same, so that the count holds.
/// \pre |coordinates| <= 2^30. Cost: corners times reflex corners.
[[nodiscard]] std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const GridPoint2> ring);

}  // namespace enfilade::modeler
