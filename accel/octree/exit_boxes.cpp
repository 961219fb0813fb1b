#include "accel/octree/exit_boxes.h"

#include <algorithm>

namespace enfilade::accel {

std::uint32_t exit_grid_levels(std::uint32_t depth, std::size_t leaves) {
    constexpr std::uint32_t finest = 8;
    std::uint32_t levels = std::min(depth, 4u);
    while (levels < std::min(depth, finest) && (std::size_t{1} << 3 * levels) < 16 * leaves) ++levels;
    return levels;
}

FullCells::FullCells(const Octree& tree, const Executor& executor) {
    const std::uint32_t levels = exit_grid_levels(tree.frame.depth, tree.leaves.size());
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

}  // namespace enfilade::accel
