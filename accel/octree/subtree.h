#pragma once
// Inside of accel/octree: the part of an octree below one node, built by one thread.

#include <cstdint>
#include <span>
#include <vector>

#include "accel/octree/lattice_triangles.h"
#include "accel/octree/octree_split.h"

namespace enfilade::accel::detail {

/// Its leaves stand in Morton order; numbers count from its own first; references are places in MeshPart::used.
struct Subtree {
    OctreeEntry root;
    std::vector<OctreeEntry> children;
    std::vector<OctreeLeaf> leaves;
    std::vector<std::uint32_t> references;
};

/// Which triangles meet which octants of a node.
struct OctantTriangles {
    std::vector<std::uint8_t> octants;  ///< of each triangle that meets the node
    OctantCounts counts;

    void find(const LatticeTriangles& triangles, const OctreeNode& node, std::span<const std::uint32_t> listed);
    /// The list of each octant.
    void write(std::span<const std::uint32_t> listed, std::array<std::uint32_t*, 8> to) const;
};

/// \pre all `listed` meet `node`, ascending. A large node becomes a leaf.
[[nodiscard]] Subtree build_subtree(const LatticeTriangles& triangles, const SplitRule& rule, const OctreeNode& node,
                                    std::vector<std::uint32_t> listed, std::uint64_t budget);

}  // namespace enfilade::accel::detail
