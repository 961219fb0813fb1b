#pragma once
// Octrees that a device builds itself, from triangles in its memory to the arrays that rays walk: passes over all
// nodes of a level, and sums that tell where their results go. The same arrays as the host's, to the last bit.

#include <array>
#include <cstddef>
#include <cstdint>

#include "accel/octree/octree.h"
#include "render/cuda/buffer.h"
#include "render/cuda/octree_arrays.h"

namespace enfilade::render::cuda {

struct DeviceOctreeBuild {
    std::uint32_t depth = accel::OctreeOptions::automatic;  ///< of the smallest cells; automatic: that of the leaves
    std::uint32_t leaf_size = 8;  ///< leaves with no more triangles are not split; not accel::OctreeOptions::automatic
    std::uint32_t most_jump_levels = most_device_jump_levels;
};

/// accel::Octree in a device's memory.
struct OctreeOnDevice {
    accel::OctreeFrame frame;
    accel::OctreeEntry root;
    std::array<float, 3> low = {0, 0, 0}, high = {0, 0, 0};  ///< of the triangles
    Buffer<accel::OctreeEntry> children;
    Buffer<std::uint32_t> inner_levels;  ///< [inner node]
    Buffer<accel::OctreeLeaf> leaves;
    Buffer<std::uint32_t> references;
    [[nodiscard]] accel::Octree read() const;
};

/// The tree that accel::build_octree builds with that depth and leaf size. \throws std::invalid_argument without a leaf
/// size; CudaError
[[nodiscard]] OctreeOnDevice build_octree_on(Device& device, const MeshOnDevice& mesh, const DeviceOctreeBuild& build);

/// The arrays of accel::LinkedOctree. \throws std::length_error as accel::build_jump_table
[[nodiscard]] OctreeArrays link_octree_on(Device& device, const OctreeOnDevice& tree, const MeshOnDevice& mesh,
                                          std::uint32_t most_jump_levels);

/// Both.
[[nodiscard]] inline OctreeArrays build_arrays_on(Device& device, const MeshOnDevice& mesh,
                                                  const DeviceOctreeBuild& build) {
    return link_octree_on(device, build_octree_on(device, mesh, build), mesh, build.most_jump_levels);
}

}  // namespace enfilade::render::cuda
