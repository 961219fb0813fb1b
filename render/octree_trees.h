#pragma once
// Octrees inside of objects without function pointers: what a walk through furnished rooms asks on a device
// (object_walk.h). Header-only, for host and device.

#include "accel/octree/linked_octree.h"
#include "render/object_walk.h"
#include "render/octree_walk.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// An octree for each mesh of the scene.
struct OctreeTrees {
    const accel::OctreeView* of_mesh;
};
ENFILADE_HD void ask_nearest(const OctreeTrees& trees, accel::MeshId mesh, ObjectRay& ray) {
    NoOctreeEvents events;
    octree_walk<false>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], ray, events);
}
ENFILADE_HD bool ask_blocked(const OctreeTrees& trees, accel::MeshId mesh, const ObjectRay& ray) {
    NoOctreeEvents events;
    ObjectRay asked = ray;
    return octree_walk<true>(trees.of_mesh[static_cast<std::uint32_t>(mesh)], asked, events);
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
