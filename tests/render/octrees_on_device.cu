// Walks through the octree of one mesh as device code, one thread a ray.
#include "render/octree_walk.h"

namespace enfilade::render {

__global__ void octree_kernel(accel::OctreeView tree, ObjectRay* rays, int count, int* blocked) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= count) return;
    NoOctreeEvents events;
    ObjectRay any = rays[i];
    blocked[i] = octree_walk<true>(tree, any, events) ? 1 : 0;
    octree_walk<false>(tree, rays[i], events);
}

}  // namespace enfilade::render
