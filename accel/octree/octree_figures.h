#pragma once
// What is told of octrees: how many leaves, how deep, how often triangles are listed.

#include <cstddef>
#include <cstdint>
#include <span>

#include "accel/octree/linked_octree.h"
#include "accel/octree/octree_stats.h"

namespace enfilade::accel {

/// Of one octree, or summed over several.
struct OctreeFigures {
    std::size_t trees = 0;  ///< that hold a triangle
    std::size_t leaves = 0;
    std::size_t empty_leaves = 0;  ///< of them: without triangles
    std::size_t references = 0;    ///< triangles of all leaves, each as often as it is listed
    std::uint32_t depth = 0;       ///< of the deepest leaf; a root that is a leaf has 0

    void add(const OctreeFigures& other);
    void add(const OctreeStats& tree);
};

/// Cost: linear in the nodes.
[[nodiscard]] OctreeFigures octree_figures(std::span<const OctreeView> trees);

}  // namespace enfilade::accel
