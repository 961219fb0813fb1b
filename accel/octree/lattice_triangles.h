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

/// The cube about a mesh's box, wider by a little: so planes of symmetry, where many meshes have faces and whole fans
/// of triangles meet, are not planes between cells. Of boxes too small for it in float the lattice is coarser.
[[nodiscard]] OctreeFrame cube_about(const std::array<float, 3>& low, const std::array<float, 3>& high,
                                     std::uint32_t depth);

/// A coordinate in the lattice.
[[nodiscard]] ENFILADE_HD float in_lattice(float p, float low, float cells_a_unit) {
    return static_cast<float>((double{p} - double{low}) * double{cells_a_unit});
}

/// By how much an octant is wider to each side than its half, for LatticeTriangles::find_octants. side: of the lattice
[[nodiscard]] ENFILADE_HD float octant_slack(float side) { return static_cast<float>(octree_slack * 1.5) * side; }

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
