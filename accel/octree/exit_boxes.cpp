#include "accel/octree/exit_boxes.h"

#include <algorithm>

namespace enfilade::accel {
namespace {

/// As fine as the leaves are, but no finer than what so many leaves deserve (256 cells a side take 68 MB).
std::uint32_t grid_levels(const Octree& tree) {
    constexpr std::uint32_t finest = 8;
    std::uint32_t levels = std::min(tree.frame.depth, 4u);
    while (levels < std::min(tree.frame.depth, finest) && (std::size_t{1} << 3 * levels) < 16 * tree.leaves.size())
        ++levels;
    return levels;
}

}  // namespace

FullCells::FullCells(const Octree& tree, const Executor& executor) {
    const std::uint32_t levels = grid_levels(tree);
    side_ = 1u << levels;
    shift_ = tree.frame.depth - levels;
    const std::size_t row = side_ + 1, slice = row * row;
    sums_.assign(slice * row, 0);
    for (const OctreeLeaf& leaf : tree.leaves) {
        if (leaf.count == 0) continue;
        Place low, high;
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = leaf.low[k] >> shift_;
            high[k] = std::max(low[k] + 1, (leaf.low[k] + tree.width(leaf)) >> shift_);
        }
        for (std::size_t z = low[2]; z < high[2]; ++z)
            for (std::size_t y = low[1]; y < high[1]; ++y)
                std::fill_n(sums_.begin() + static_cast<std::ptrdiff_t>((z + 1) * slice + (y + 1) * row + low[0] + 1),
                            high[0] - low[0], 1u);
    }
    parallel_for(executor, side_, 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t z = begin + 1; z <= end; ++z)
            for (std::size_t y = 1; y < row; ++y) {
                std::uint32_t* here = sums_.data() + z * slice + y * row;
                std::uint32_t sum = 0;
                for (std::size_t x = 1; x < row; ++x) {
                    sum += here[x];
                    here[x] = sum + here[x - row];
                }
            }
    });
    parallel_for(executor, slice, 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t z = 1; z < row; ++z)
            for (std::size_t i = begin; i < end; ++i) sums_[z * slice + i] += sums_[(z - 1) * slice + i];
    });
}

std::array<std::uint32_t, 3> exit_extent(const Octree& tree, const OctreeLeaf& leaf, const FullCells& cells,
                                         std::uint32_t octant) {
    const std::uint32_t width = tree.width(leaf);
    std::array<std::uint32_t, 3> extent = {width, width, width};
    if (width >> cells.shift() == 0) return extent;  // finer than the grid
    FullCells::Place low, high;
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = leaf.low[k] >> cells.shift();
        high[k] = low[k] + (width >> cells.shift());
    }
    // By turns along each axis, twice as far each time, until something is in the way.
    std::array<std::uint32_t, 3> stride = {1, 1, 1};
    bool is_growing = true;
    while (is_growing) {
        is_growing = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const bool is_up = (octant >> k & 1u) != 0;
            while (stride[k] != 0) {
                const std::uint32_t room = is_up ? cells.cells_a_side() - high[k] : low[k];
                const std::uint32_t by = std::min(stride[k], room);
                FullCells::Place from = low, to = high;
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
    for (std::size_t k = 0; k < 3; ++k) extent[k] = (high[k] - low[k]) << cells.shift();
    return extent;
}

}  // namespace enfilade::accel
