#pragma once
// An octree two levels at a time: bricks of 4 x 4 x 4 cells, each with one word that tells in which of them there are
// triangles. What is empty takes a bit, and a ray is tested against all cells of a brick at once (README.md, "Bricks").

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// In which cells there are triangles, as rays towards each octant count them. A ray is mirrored so that it goes
/// upwards along all axes; mirrored cell (x, y, z) of the brick is bit x + 4 y + 16 z. Along such a ray bits only grow.
struct alignas(64) BrickMasks {
    std::uint64_t mirrored[8];  ///< [which axes are mirrored: bit 0 for x, 1 for y, 2 for z]
};
static_assert(sizeof(BrickMasks) == 64);

/// Of the mirrored bit b of a brick, the bit in its cells as they lie is b ^ brick_mirror(axes).
[[nodiscard]] ENFILADE_HD std::uint32_t brick_mirror(std::uint32_t axes) {
    return (axes & 1u) * 3u | (axes >> 1 & 1u) * 12u | (axes >> 2 & 1u) * 48u;
}

/// What is in a cell that is not empty: a brick, or a leaf's triangles. Cells of one leaf have equal entries.
struct BrickEntry {
    static constexpr std::uint64_t leaf_bit = std::uint64_t{1} << 63;
    std::uint64_t bits;
    [[nodiscard]] ENFILADE_HD bool is_leaf() const { return (bits & leaf_bit) != 0; }
    [[nodiscard]] ENFILADE_HD std::uint32_t brick() const { return static_cast<std::uint32_t>(bits); }
    /// Where its triangles begin among the corners (OctreeView::corners), and how many there are.
    [[nodiscard]] ENFILADE_HD std::uint32_t first() const { return static_cast<std::uint32_t>(bits); }
    [[nodiscard]] ENFILADE_HD std::uint32_t count() const {
        return static_cast<std::uint32_t>(bits >> 32) & 0x7fffffffu;
    }
    static constexpr BrickEntry to_brick(std::uint32_t number) { return {number}; }
    static constexpr BrickEntry leaf(std::uint32_t first, std::uint32_t count) {
        return {leaf_bit | std::uint64_t{count} << 32 | first};
    }
    friend constexpr bool operator==(BrickEntry, BrickEntry) = default;
};

/// The root is brick 0 and as wide as the tree; a brick in a cell is as wide as the cell.
struct Bricks {
    std::vector<BrickMasks> masks;     ///< [brick]
    std::vector<std::uint32_t> first;  ///< [brick], into `entries`
    std::vector<BrickEntry> entries;   ///< of a brick's cells that are not empty, by ascending bit of mirrored[0]
    [[nodiscard]] std::size_t bytes() const {
        return masks.size() * sizeof(BrickMasks) + first.size() * sizeof(std::uint32_t) +
               entries.size() * sizeof(BrickEntry);
    }
};

/// Leaves may be wider than a cell of their brick: of their cells those are full that their triangles meet.
/// floats_a_reference: a leaf's triangles begin so many times its OctreeLeaf::first among the corners. \pre the tree is
/// not empty
[[nodiscard]] Bricks build_bricks(const Octree& tree, const MeshPart& mesh, std::uint32_t floats_a_reference,
                                  const Executor& executor);

}  // namespace enfilade::accel
