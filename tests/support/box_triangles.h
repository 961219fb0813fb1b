#pragma once
// A box as triangles.

#include <array>
#include <cstdint>
#include <vector>

namespace enfilade::test {

/// Outward, of a box whose corner k has its greater x, y, z where bit 0, 1, 2 of k is set.
[[nodiscard]] inline std::vector<std::array<std::uint32_t, 3>> box_triangles() {
    return {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
}

}  // namespace enfilade::test
