#pragma once
// The octree as our own tracers walk it: half a cache line a leaf, with the boxes to leave it by, a table that finds
// the leaf behind them, and its triangles laid out for registers of them.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/bricks.h"
#include "accel/octree/jump_table.h"
#include "accel/octree/large_pages.h"
#include "accel/octree/octree.h"

namespace enfilade::accel {

/// A leaf. A ray towards an octant leaves it by a box that may reach past the leaf into empty neighbours
/// (exit_boxes.h).
struct alignas(32) LinkedLeaf {
    std::uint8_t exits[8][3];  ///< [octant][axis]: extent of the box, in units of 2^exit_unit cells
    std::uint32_t first;       ///< of its triangles, into `corners`
    std::uint32_t count;       ///< of its triangles
};
static_assert(sizeof(LinkedLeaf) == 32);

/// Of the exits of a leaf 2^width cells wide: an eighth of its width, at least a cell.
[[nodiscard]] ENFILADE_HD std::uint32_t exit_unit(std::uint32_t width) { return width > 3 ? width - 3 : 0; }

/// Where the triangles lie, for a walk's start: x, y, z and nothing.
struct alignas(16) LatticeBox {
    float origin[4], cells_a_unit[4];  ///< of the lattice, as in OctreeFrame
    float low[4], high[4];             ///< of the triangles, in the mesh's own space
    float from[4], to[4];              ///< the same in the lattice, wider by octree_slack
    float size;                        ///< the longest edge of the triangles' box
    float side;                        ///< of the lattice
};

/// low, high: of the triangles, in the mesh's own space
[[nodiscard]] LatticeBox lattice_box(const OctreeFrame& frame, const float* low, const float* high);

/// Plain pointers, safe to copy to a device.
struct OctreeView {
    OctreeFrame frame;
    OctreeEntry root;
    const OctreeEntry* children;  ///< [inner node][8]
    const LinkedLeaf* leaves;     ///< nullptr: nothing is ever hit
    /// Of a leaf with n triangles, from `first`: ax of all n, ay, az, bx, by, bz, cx, cy, cz, in the mesh's own space,
    /// then the bits of their numbers, ascending. 16 more floats stand behind the last.
    const float* corners;
    float low[3], high[3];         ///< of the triangles in it
    const std::uint8_t* occupied;  ///< [inner node]: bit i where child i holds triangles: a leaf with some, or any node
    const JumpEntry* jumps;        ///< JumpTable::entries
    std::uint32_t jump_levels;     ///< JumpTable::levels
    LatticeBox box;
    const BrickMasks* brick_masks;     ///< Bricks::masks
    const std::uint32_t* brick_first;  ///< Bricks::first
    const BrickEntry* brick_entries;   ///< Bricks::entries
};

/// Owns the arrays of an OctreeView. Moving it keeps its views.
class LinkedOctree {
public:
    LinkedOctree() = default;
    LinkedOctree(const Octree& tree, const MeshPart& mesh, const Executor& executor);

    [[nodiscard]] OctreeView view() const;
    /// A view of copies of what a ray that is walked alone reads (render/octree_walk.h), for another memory; the other
    /// arrays are nullptr there. copy: T const* copy(T const* values, count)
    template <class Copy>
    [[nodiscard]] OctreeView copied(const Copy& copy) const {
        OctreeView copied = view();
        copied.leaves = leaves_.empty() ? nullptr : copy(leaves_.data(), leaves_.size());
        copied.corners = copy(corners_.data(), corners_.size());
        copied.jumps = copy(jumps_.entries.data(), jumps_.entries.size());
        copied.children = nullptr;
        copied.occupied = nullptr;
        copied.brick_masks = nullptr;
        copied.brick_first = nullptr;
        copied.brick_entries = nullptr;
        return copied;
    }
    [[nodiscard]] std::size_t bytes() const {
        return leaves_.size() * sizeof(LinkedLeaf) + children_.size() * sizeof(OctreeEntry) +
               corners_.size() * sizeof(float) + occupied_.size() + jumps_.entries.size() * sizeof(JumpEntry) +
               bricks_.bytes();
    }

private:
    OctreeFrame frame_;
    OctreeEntry root_;
    std::vector<OctreeEntry> children_;
    std::vector<LinkedLeaf, LargePages<LinkedLeaf>> leaves_;
    std::vector<float, LargePages<float>> corners_;
    JumpTable jumps_;
    Bricks bricks_;
    std::vector<std::uint8_t> occupied_;
    float low_[3] = {0, 0, 0}, high_[3] = {0, 0, 0};
};

}  // namespace enfilade::accel
