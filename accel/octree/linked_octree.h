#pragma once
// The octree as our own tracers walk it: a cache line a leaf, with the box to leave by, links to what lies behind its
// six faces, and its triangles laid out for registers of them.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel {

/// A leaf. Its box may reach past the leaf into empty neighbours: all triangles in the box are those of the leaf.
struct alignas(64) LinkedLeaf {
    float low[3];                ///< of the box, in the lattice: whole numbers
    std::uint32_t first;         ///< of its triangles, into `corners`
    float high[3];               ///< of the box
    std::uint32_t count;         ///< of its triangles
    OctreeEntry rope[6];         ///< [2 axis + (towards higher ? 1 : 0)]: holds all that lies behind that face
    std::uint8_t rope_level[6];  ///< of the node that the rope leads to; `no_neighbour`: the ray leaves the octree
    std::uint16_t reserved;
};
static_assert(sizeof(LinkedLeaf) == 64);

inline constexpr std::uint8_t no_neighbour = 0xff;

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
};

/// Owns the arrays of an OctreeView. Moving it keeps its views.
class LinkedOctree {
public:
    LinkedOctree() = default;
    LinkedOctree(const Octree& tree, const MeshPart& mesh, const Executor& executor);

    [[nodiscard]] OctreeView view() const;
    [[nodiscard]] std::size_t bytes() const {
        return leaves_.size() * sizeof(LinkedLeaf) + children_.size() * sizeof(OctreeEntry) +
               corners_.size() * sizeof(float) + occupied_.size();
    }

private:
    OctreeFrame frame_;
    OctreeEntry root_;
    std::vector<OctreeEntry> children_;
    std::vector<LinkedLeaf> leaves_;
    std::vector<float> corners_;
    std::vector<std::uint8_t> occupied_;
    float low_[3] = {0, 0, 0}, high_[3] = {0, 0, 0};
};

}  // namespace enfilade::accel
