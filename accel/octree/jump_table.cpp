#include "accel/octree/jump_table.h"

#include <algorithm>
#include <stdexcept>

namespace enfilade::accel {
namespace {

/// As many levels as a table no larger than the leaves has.
std::uint32_t top_levels(const Octree& tree) {
    constexpr std::uint32_t most = 5;
    std::uint32_t levels = tree.frame.depth & 1u;
    while (levels + 2 <= std::min(most, tree.frame.depth) &&
           (std::size_t{1} << 3 * (levels + 2)) <= 8 * tree.leaves.size())
        levels += 2;
    return levels;
}

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

JumpTable build_jump_table(const Octree& tree, std::uint32_t levels) {
    if (tree.leaves.size() > JumpEntry::most_leaves) throw std::length_error("an octree of more than 2^26 leaves");
    JumpTable table;
    table.levels = levels == automatic_jump_levels ? top_levels(tree) : levels;
    if (table.levels > tree.frame.depth || table.levels > 9 || (tree.frame.depth - table.levels) % 2 != 0)
        throw std::invalid_argument("a jump table's flat part is a whole number of nodes above the deepest leaves");
    table.entries.resize(std::size_t{1} << 3 * table.levels);
    Filler(tree, table).fill(tree.root, table.levels, 0);
    return table;
}

}  // namespace enfilade::accel
