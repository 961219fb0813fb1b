#pragma once
// Octrees inside of objects in the layout that warps read best, for walks through furnished rooms (object_walk.h).
// Walks are header-only, for host and device.

#include "accel/octree/linked_octree.h"
#include "accel/scene.h"
#include "render/cuda/octree_travel.h"
#include "render/object_walk.h"

namespace enfilade::render {

namespace cuda {
class DeviceArrays;
/// Of a tree on the host; released with the arrays. \throws CudaError
[[nodiscard]] RecordTree copy_records(const accel::LinkedOctree& tree, DeviceArrays& arrays);
}  // namespace cuda

inline namespace ENFILADE_ISA {

/// An octree for each mesh of the scene: as OctreeTrees, with the same answers.
struct RecordTrees {
    const cuda::RecordTree* of_mesh;
};
ENFILADE_HD void ask_nearest(const RecordTrees& trees, accel::MeshId mesh, ObjectRay& ray) {
    NoOctreeEvents none;
    cuda::walk_octree<false>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], ray, none);
}
ENFILADE_HD bool ask_blocked(const RecordTrees& trees, accel::MeshId mesh, const ObjectRay& ray) {
    NoOctreeEvents none;
    ObjectRay asked = ray;
    return cuda::walk_octree<true>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], asked, none);
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
