#pragma once
// Inside of accel/octree: the triangles of a mesh in the lattice of its octree, and which eighths of a node they meet.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/octree/octree.h"

namespace enfilade::accel::detail {

/// A node's place in the lattice.
struct OctreeNode {
    std::array<std::uint32_t, 3> low = {0, 0, 0};
    std::uint32_t level = 0;
    [[nodiscard]] OctreeNode octant(std::uint32_t which, std::uint32_t depth) const {
        OctreeNode child = {low, level + 1};
        for (std::uint32_t k = 0; k < 3; ++k) child.low[k] += (which >> k & 1u) << (depth - level - 1);
        return child;
    }
};

/// Corners in the lattice, rounded to float: by no more than 2^-25 of the root's side.
class LatticeTriangles {
public:
    /// \pre `mesh.used` is not empty
    LatticeTriangles(const MeshPart& mesh, const OctreeOptions& options, const Executor& executor);
    /// In the lattice of a tree that stands.
    LatticeTriangles(const MeshPart& mesh, const OctreeFrame& frame, const Executor& executor);

    [[nodiscard]] const OctreeFrame& frame() const { return frame_; }
    [[nodiscard]] std::size_t size() const { return corners_.size(); }

    /// For each of the triangles `listed`, all of which meet `node`, which of its octants they meet: bit i for octant
    /// i. What meets a box wider by octree_slack is found for certain; some that stay outside of it by less than half
    /// as much are found too. \pre node.level < frame().depth; octants: [listed.size()]
    void find_octants(const OctreeNode& node, std::span<const std::uint32_t> listed, std::uint8_t* octants) const;

private:
    using Corners = std::array<float, 9>;  ///< x, y, z of the first, of the second, of the third
    OctreeFrame frame_;
    std::vector<Corners> corners_;  ///< of used triangles
};

}  // namespace enfilade::accel::detail
