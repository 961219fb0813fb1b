#pragma once
// Inside of accel/octree: how far a ray may go from a leaf through empty space before it has to look again. A ray goes
// towards one octant, so what lies behind it does not matter: each leaf has eight boxes, one per octant, larger than
// one box for all could be.

#include <array>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// Counts full cells in boxes of a grid of at most 256^3 cells (prefix sums).
class FullCells {
public:
    using Place = std::array<std::uint32_t, 3>;
    FullCells(const Octree& tree, const Executor& executor);

    [[nodiscard]] std::uint32_t cells_a_side() const { return side_; }
    /// Of lattice cells in one of the grid's, along an axis, as a power of two.
    [[nodiscard]] std::uint32_t shift() const { return shift_; }
    [[nodiscard]] bool are_empty(const Place& low, const Place& high) const {
        const std::uint32_t above = at(high[0], high[1], high[2]) - at(low[0], high[1], high[2]) -
                                    at(high[0], low[1], high[2]) + at(low[0], low[1], high[2]);
        const std::uint32_t below = at(high[0], high[1], low[2]) - at(low[0], high[1], low[2]) -
                                    at(high[0], low[1], low[2]) + at(low[0], low[1], low[2]);
        return above == below;
    }

private:
    [[nodiscard]] std::uint32_t at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        return sums_[(std::size_t{z} * (side_ + 1) + y) * (side_ + 1) + x];
    }
    std::uint32_t side_, shift_;
    std::vector<std::uint32_t> sums_;  ///< [z][y][x]: full cells below
};

/// The extent of a leaf's box towards an octant, in lattice cells along x, y and z, from the leaf's corner that is
/// farthest from the octant; at least the leaf's width. No triangle but the leaf's is in that box.
[[nodiscard]] std::array<std::uint32_t, 3> exit_extent(const Octree& tree, const OctreeLeaf& leaf,
                                                       const FullCells& cells, std::uint32_t octant);

}  // namespace enfilade::accel
