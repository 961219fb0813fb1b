#pragma once
// Inside of accel/octree: how far a ray may go from a leaf through empty space before it has to look again. A ray goes
// towards one octant, so what lies behind it does not matter: each leaf has eight boxes, one per octant, larger than
// one box for all could be.

#include <array>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// Counts of full cells in boxes of a grid (prefix sums). Plain pointers, safe to copy to a device.
struct FullCellSums {
    std::uint32_t side, shift;  ///< as of FullCells
    const std::uint32_t* sums;  ///< [z][y][x]: full cells below; side + 1 each

    using Place = std::array<std::uint32_t, 3>;
    [[nodiscard]] ENFILADE_HD bool are_empty(const Place& low, const Place& high) const {
        const std::uint32_t above = at(high[0], high[1], high[2]) - at(low[0], high[1], high[2]) -
                                    at(high[0], low[1], high[2]) + at(low[0], low[1], high[2]);
        const std::uint32_t below = at(high[0], high[1], low[2]) - at(low[0], high[1], low[2]) -
                                    at(high[0], low[1], low[2]) + at(low[0], low[1], low[2]);
        return above == below;
    }

private:
    [[nodiscard]] ENFILADE_HD std::uint32_t at(std::uint32_t x, std::uint32_t y, std::uint32_t z) const {
        return sums[(std::size_t{z} * (side + 1) + y) * (side + 1) + x];
    }
};

/// A grid as fine as the leaves are, but no finer than what so many leaves deserve (256 cells a side take 68 MB): its
/// levels.
[[nodiscard]] std::uint32_t exit_grid_levels(std::uint32_t depth, std::size_t leaves);

/// Counts full cells in boxes of a grid of at most 256^3 cells.
class FullCells {
public:
    FullCells(const Octree& tree, const Executor& executor);

    /// side: cells a side; shift: of lattice cells in one of the grid's, along an axis, as a power of two.
    [[nodiscard]] FullCellSums view() const { return {side_, shift_, sums_.data()}; }

private:
    using Place = FullCellSums::Place;
    std::uint32_t side_, shift_;
    std::vector<std::uint32_t> sums_;
};

/// The extent of a leaf's box towards an octant, in lattice cells along x, y and z, from the leaf's corner that is
/// farthest from the octant; at least the leaf's width. No triangle but the leaf's is in that box. low, width: of the
/// leaf
[[nodiscard]] ENFILADE_HD std::array<std::uint32_t, 3> exit_extent(const std::array<std::uint32_t, 3>& leaf_low,
                                                                   std::uint32_t width, const FullCellSums& cells,
                                                                   std::uint32_t octant) {
    std::array<std::uint32_t, 3> extent = {width, width, width};
    if (width >> cells.shift == 0) return extent;  // finer than the grid
    FullCellSums::Place low = {}, high = {};
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = leaf_low[k] >> cells.shift;
        high[k] = low[k] + (width >> cells.shift);
    }
    // By turns along each axis, twice as far each time, until something is in the way.
    std::array<std::uint32_t, 3> stride = {1, 1, 1};
    bool is_growing = true;
    while (is_growing) {
        is_growing = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_up = (octant >> k & 1u) != 0;
            while (stride[k] != 0) {
                const std::uint32_t room = is_up ? cells.side - high[k] : low[k];
                const std::uint32_t by = stride[k] < room ? stride[k] : room;
                FullCellSums::Place from = low, to = high;
                (is_up ? from[k] : to[k]) = is_up ? high[k] : low[k];
                (is_up ? to[k] : from[k]) = is_up ? high[k] + by : low[k] - by;
                if (by != 0 && cells.are_empty(from, to)) {
                    (is_up ? high[k] : low[k]) = is_up ? to[k] : from[k];
                    stride[k] *= 2;
                    is_growing = true;
                    break;
                }
                stride[k] = by == 0 || stride[k] == 1 ? 0 : 1;
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) extent[k] = (high[k] - low[k]) << cells.shift;
    return extent;
}

}  // namespace enfilade::accel
