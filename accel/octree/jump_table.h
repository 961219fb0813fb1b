#pragma once
// Inside of accel/octree: from a cell of the lattice to the leaf that holds it, in few dependent loads: a flat table of
// the top levels, below it nodes of two levels (4 x 4 x 4).

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// An entry: an inner one is the place of 64 more in the table; a leaf's tells its number and its width.
struct JumpEntry {
    static constexpr std::uint32_t leaf_bit = 0x80000000u, number_bits = 26;
    static constexpr std::uint32_t most_leaves = 1u << number_bits;
    std::uint32_t bits;
    [[nodiscard]] ENFILADE_HD bool is_leaf() const { return (bits & leaf_bit) != 0; }
    [[nodiscard]] ENFILADE_HD std::uint32_t number() const { return bits & (most_leaves - 1); }
    /// The leaf is 2^that cells wide.
    [[nodiscard]] ENFILADE_HD std::uint32_t width() const { return bits >> number_bits & 31u; }
};

struct JumpTable {
    std::vector<JumpEntry> entries;  ///< first of 8^levels cells in Morton order (x lowest), then 64 a node
    std::uint32_t levels = 0;        ///< at the top; the tree's depth less this is even
};

/// A table no larger than the leaves, with at most five levels at the top.
inline constexpr std::uint32_t automatic_jump_levels = 0xffffffffu;
/// Those levels. most: instead of five
[[nodiscard]] std::uint32_t jump_levels_for(std::uint32_t depth, std::size_t leaves, std::uint32_t most = 5);

/// levels: at the top. \throws std::length_error where the tree has more than JumpEntry::most_leaves leaves;
/// std::invalid_argument where the tree's depth less `levels` is not even, or negative, or `levels` above 9
[[nodiscard]] JumpTable build_jump_table(const Octree& tree, std::uint32_t levels = automatic_jump_levels);

}  // namespace enfilade::accel
