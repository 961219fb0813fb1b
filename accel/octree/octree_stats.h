#pragma once
// Counts of an octree and what a ray through it is expected to do, for reports and benchmarks.

#include <cstdint>

#include "accel/octree/octree.h"

namespace enfilade::accel {

struct OctreeStats {
    std::uint64_t leaves = 0;
    std::uint64_t empty_leaves = 0;
    std::uint64_t inner_nodes = 0;
    std::uint64_t references = 0;
    std::uint64_t triangles = 0;     ///< that are listed anywhere
    std::uint32_t deepest = 0;       ///< level of the deepest leaf
    std::uint32_t largest_leaf = 0;  ///< triangles in it
    double references_a_triangle = 0;
    double triangles_a_leaf = 0;  ///< over leaves that are not empty
    // What a straight line through the root that is stopped by nothing does on average, all lines alike: it crosses a
    // node as often as the node's area has part of the root's (Crofton).
    double crossed_leaves = 0;
    double crossed_empty_leaves = 0;  ///< of those
    double crossed_blocks = 0;        ///< registers of 16 triangles
    double expected_cost = 0;         ///< by `cost`, in its unit

    friend bool operator==(const OctreeStats&, const OctreeStats&) = default;
};

/// Cost: about 10 ns a leaf and 1 ns a reference.
[[nodiscard]] OctreeStats octree_stats(const Octree& tree, const OctreeCost& cost = {});

}  // namespace enfilade::accel
