// The walk as device code, one thread a ray.
#include "render/camera.h"
#include "render/shade.h"
#include "render/walk.h"

namespace enfilade::render {

template <class T>
__global__ void walk_kernel(accel::SceneView scene, CameraFrame camera, std::uint32_t start, int width, int height,
                            std::uint32_t* faces, float* distances, RayStats* stats) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= width * height) return;
    const Vec3f direction =
        camera.direction(static_cast<float>(i % width) + 0.5f, static_cast<float>(i / width) + 0.5f);
    Ray<T> ray;
    if (!make_ray(vec_cast<T>(camera.origin), vec_cast<T>(direction), ray)) return;
    Vec3f throughput = {1, 1, 1};
    RayStats events;
    const WalkEnd<T> end = walk(scene, ray, start, NoLimit{}, throughput, events);
    faces[i] = end.target.bits;
    distances[i] = static_cast<float>(parameter(scene, ray, end));
    stats[i] = events;
}

template __global__ void walk_kernel<float>(accel::SceneView, CameraFrame, std::uint32_t, int, int, std::uint32_t*,
                                            float*, RayStats*);
template __global__ void walk_kernel<double>(accel::SceneView, CameraFrame, std::uint32_t, int, int, std::uint32_t*,
                                             float*, RayStats*);

}  // namespace enfilade::render
