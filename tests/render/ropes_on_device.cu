// Walks through the paper's octree as device code, one thread a ray.
#include "render/rope_walk.h"

namespace enfilade::render {

template <class T>
__global__ void rope_kernel(accel::RopeView tree, ObjectRay* rays, int count, int* blocked) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= count) return;
    NoRopeEvents events;
    ObjectRay any = rays[i];
    blocked[i] = rope_walk<T, true>(tree, any, events) ? 1 : 0;
    rope_walk<T, false>(tree, rays[i], events);
}

template __global__ void rope_kernel<float>(accel::RopeView, ObjectRay*, int, int*);
template __global__ void rope_kernel<double>(accel::RopeView, ObjectRay*, int, int*);

}  // namespace enfilade::render
