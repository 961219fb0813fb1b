#pragma once
// Inside of render: walks through octrees by registers of triangles and of rays, compiled for every instruction set.

#include <cstdint>

#include "accel/octree/linked_octree.h"
#include "render/object_tracer.h"

namespace enfilade::render::detail {

/// As the functions of ObjectTracer, for one mesh.
struct OctreeKernels {
    const char* name;
    bool (*nearest)(const accel::OctreeView& tree, ObjectRay& ray);  ///< whether it hit
    bool (*blocked)(const accel::OctreeView& tree, const ObjectRay& ray);
    void (*nearest16)(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays);
    void (*nearest16_apart)(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays);
    std::uint32_t (*blocked16)(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays);
};

/// Those for the machine that runs, of what Highway finds there; nullptr in a build without Highway, and where
/// registers hold one float.
[[nodiscard]] const OctreeKernels* octree_lane_kernels();

/// Those for any machine: octree_walk.h, one ray at a time.
[[nodiscard]] const OctreeKernels& octree_kernels();

}  // namespace enfilade::render::detail
