#pragma once
// Inside of accel/octree: who is whose neighbour, and where each leaf's record stands.

#include <array>
#include <cstdint>
#include <vector>

#include "accel/octree/octree.h"
#include "accel/octree/rope_octree.h"

namespace enfilade::accel::detail {

/// The node that holds a cell, at `level` if there is one so deep there, else the leaf above.
[[nodiscard]] OctreeEntry node_at(const Octree& tree, const std::array<std::uint32_t, 3>& cell, std::uint32_t level);

/// The neighbours of all leaves of a tree that outlives it, and the addresses of their records.
class RopeLinks {
public:
    /// Exceptions: as RopeOctree's.
    RopeLinks(const Octree& tree, bool is_balanced, std::uint32_t header, const Executor& executor);

    [[nodiscard]] RopeAddress address(OctreeEntry entry) const;
    [[nodiscard]] std::size_t leaf_words() const { return leaf_words_; }  ///< of all records of leaves
    [[nodiscard]] std::size_t neighbour_count() const;

    /// Writes the addresses of a leaf's neighbours, face after face. Returns nCount.
    std::uint32_t write_neighbours(std::size_t leaf, std::uint32_t* to) const;

    /// [face][v][u] with 2^level places along an edge.
    [[nodiscard]] std::vector<RopeAddress> cube_map(std::uint32_t level, const Executor& executor) const;

private:
    /// Of one face: what lies there. 0 nodes: the border.
    struct Side {
        std::array<OctreeEntry, 4> nodes;
        std::uint32_t count = 0;
    };
    [[nodiscard]] Side side_of(const OctreeLeaf& leaf, std::uint32_t face) const;

    const Octree& tree_;
    bool is_balanced_;
    std::uint32_t header_;
    std::vector<RopeAddress> addresses_;  ///< [leaf]
    std::size_t leaf_words_ = 0;
};

}  // namespace enfilade::accel::detail
