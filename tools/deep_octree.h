#pragma once
// Octrees that are deep about a few points and coarse elsewhere: as deep as any, of few leaves. For studies and tests
// of what rounding does in small leaves.

#include <array>
#include <cstdint>
#include <span>

#include "accel/octree/octree.h"

namespace enfilade::tools {

struct DeepOctreeOptions {
    accel::OctreeFrame frame;                      ///< with the depth to reach
    std::span<const std::array<double, 3>> about;  ///< points in the lattice
    bool is_balanced = true;                       ///< neighbours differ by one level at most
};

/// Nodes that hold one of the points are split down to the smallest cells; balanced, also those that are nearer to one
/// than their own width. Leaves list the triangles of `mesh` that meet them, by build_octree's own rule.
[[nodiscard]] accel::Octree deep_octree(const accel::MeshPart& mesh, const DeepOctreeOptions& options);

}  // namespace enfilade::tools
