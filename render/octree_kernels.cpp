#include "render/octree_kernels.h"

#include "render/object_rays.h"
#include "render/octree_walk.h"

namespace enfilade::render::detail {
namespace {

bool nearest(const accel::OctreeView& tree, ObjectRay& ray) {
    NoOctreeEvents events;
    return octree_walk<false>(tree, ray, events);
}

bool blocked(const accel::OctreeView& tree, const ObjectRay& ray) {
    NoOctreeEvents events;
    ObjectRay asked = ray;
    return octree_walk<true>(tree, asked, events);
}

void nearest16(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    one_by_one(valid, rays, [&](ObjectRay& ray) { return nearest(tree, ray); });
}

std::uint32_t blocked16(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    return blocked_one_by_one(valid, rays, [&](ObjectRay& ray) { return blocked(tree, ray); });
}

}  // namespace

const OctreeKernels& octree_kernels() {
    static constexpr OctreeKernels kernels = {"any", nearest, blocked, nearest16, nearest16, blocked16};
    return kernels;
}

#if !defined(ENFILADE_HAS_LANES)
const OctreeKernels* octree_lane_kernels() { return nullptr; }
#endif

}  // namespace enfilade::render::detail
