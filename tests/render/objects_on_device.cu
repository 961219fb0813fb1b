// The walk through furnished rooms as device code, one thread a ray, with our own trees of boxes or
// octrees inside of objects.
#include "render/camera.h"
#include "render/object_walk.h"
#include "render/octree_trees.h"
#include "render/shade.h"

namespace enfilade::render {

template <class T, class Trees>
__global__ void furnished_kernel(accel::SceneView scene, Trees trees, CameraFrame camera, std::uint32_t start,
                                 int width, int height, std::uint32_t* objects, float* distances) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= width * height) return;
    const Vec3f direction =
        camera.direction(static_cast<float>(i % width) + 0.5f, static_cast<float>(i / width) + 0.5f);
    Ray<T> ray;
    if (!make_ray(vec_cast<T>(camera.origin), vec_cast<T>(direction), ray)) return;
    Vec3f throughput = {1, 1, 1};
    NoEvents events;
    ObjectHit<T> hit;
    const WalkEnd<T> end = walk_furnished(scene, trees, ray, start, NoLimit{}, throughput, events, hit);
    const bool is_object = end.status == WalkStatus::Object;
    objects[i] = is_object ? hit.object : no_object;
    distances[i] = static_cast<float>(is_object ? hit.t : parameter(scene, ray, end));
}

template __global__ void furnished_kernel<float>(accel::SceneView, MeshTrees, CameraFrame, std::uint32_t, int, int,
                                                 std::uint32_t*, float*);
template __global__ void furnished_kernel<float>(accel::SceneView, OctreeTrees, CameraFrame, std::uint32_t, int, int,
                                                 std::uint32_t*, float*);
template __global__ void furnished_kernel<double>(accel::SceneView, MeshTrees, CameraFrame, std::uint32_t, int, int,
                                                  std::uint32_t*, float*);
template __global__ void furnished_kernel<double>(accel::SceneView, OctreeTrees, CameraFrame, std::uint32_t, int, int,
                                                  std::uint32_t*, float*);

}  // namespace enfilade::render
