#pragma once
// What is inside of objects, where kernels walk it: a tree for each mesh, built by the host and uploaded once.

#include <cstddef>

#include "accel/octree/octree.h"
#include "accel/parallel_for.h"
#include "render/cuda/device_scene.h"
#include "render/octree_trees.h"

namespace enfilade::render::cuda {

enum class InsideKind {
    Octree,  ///< accel::LinkedOctree, walked leaf by leaf (octree_walk.h)
    Bvh      ///< PlainBvh (bvh_walk.h)
};

/// Trees of all meshes that rays may ask for. Their memory is that of the arrays.
class DeviceObjects {
public:
    /// Builds and uploads them. scene: on the host; copy: what copy_scene made of it. options: of octrees; their layout
    /// is always ours. \throws CudaError
    DeviceObjects(DeviceArrays& arrays, const accel::SceneView& scene, const accel::SceneView& copy, InsideKind kind,
                  const accel::OctreeOptions& options, const accel::Executor& executor);

    [[nodiscard]] InsideKind kind() const { return kind_; }
    /// For RoomsWith. \pre kind() is Octree
    [[nodiscard]] OctreeTrees octrees() const { return {octrees_}; }
    /// For RoomsWith. \pre kind() is Bvh
    [[nodiscard]] MeshTrees bvhs() const { return {bvhs_}; }
    /// Of the trees on the device, without the scene's own arrays.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

private:
    InsideKind kind_;
    const accel::OctreeView* octrees_ = nullptr;
    const BvhView* bvhs_ = nullptr;
    std::size_t bytes_ = 0;
};

}  // namespace enfilade::render::cuda
