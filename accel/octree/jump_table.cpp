#include "accel/octree/jump_table.h"

#include <algorithm>
#include <stdexcept>

namespace enfilade::accel {
namespace {

class Filler {
public:
    Filler(const Octree& tree, JumpTable& table) : tree_(tree), table_(table) {}

    /// Entries from `at` on are 8^levels cells that `entry` covers.
    void fill(OctreeEntry entry, std::uint32_t levels, std::size_t at) {
        if (entry.is_leaf()) {
            const std::uint32_t width = tree_.frame.depth - tree_.leaves[entry.number()].level;
            const JumpEntry to = {JumpEntry::leaf_bit | width << JumpEntry::number_bits | entry.number()};
            std::fill_n(table_.entries.begin() + static_cast<std::ptrdiff_t>(at), std::size_t{1} << 3 * levels, to);
        } else if (levels == 0) {
            const std::size_t node = table_.entries.size();
            table_.entries.resize(node + 64);
            table_.entries[at] = {static_cast<std::uint32_t>(node)};
            fill(entry, 2, node);
        } else {
            for (std::size_t octant = 0; octant < 8; ++octant)
                fill(tree_.children[std::size_t{8} * entry.number() + octant], levels - 1,
                     at + (octant << 3 * (levels - 1)));
        }
    }

private:
    const Octree& tree_;
    JumpTable& table_;
};

}  // namespace

std::uint32_t jump_levels_for(std::uint32_t depth, std::size_t leaves, std::uint32_t most) {
    std::uint32_t levels = depth & 1u;
    while (levels + 2 <= std::min(most, depth) && (std::size_t{1} << 3 * (levels + 2)) <= 8 * leaves) levels += 2;
    return levels;
}

JumpTable build_jump_table(const Octree& tree, std::uint32_t levels) {
    if (tree.leaves.size() > JumpEntry::most_leaves) throw std::length_error("an octree of more than 2^26 leaves");
    JumpTable table;
    table.levels = levels == automatic_jump_levels ? jump_levels_for(tree.frame.depth, tree.leaves.size()) : levels;
    if (table.levels > tree.frame.depth || table.levels > 9 || (tree.frame.depth - table.levels) % 2 != 0)
        throw std::invalid_argument("a jump table's flat part is a whole number of nodes above the deepest leaves");
    table.entries.resize(std::size_t{1} << 3 * table.levels);
    Filler(tree, table).fill(tree.root, table.levels, 0);
    return table;
}

}  // namespace enfilade::accel
