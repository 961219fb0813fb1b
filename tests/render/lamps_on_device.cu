// The light of lamps as device code, one thread a place, bare and furnished; lamp_pairs_test.cpp and its neighbours run
// the same functions on the host.
#include "render/lamp_light.h"
#include "render/octree_trees.h"

namespace enfilade::render {

template <class T, class Rooms>
__global__ void lamp_kernel(accel::SceneView scene, Lamps lamps, Rooms rooms, const LitPlace<T>* places, int count,
                            Vec3f* lux, RayStats* stats) {
    const int i = static_cast<int>(blockIdx.x * blockDim.x + threadIdx.x);
    if (i >= count) return;
    RayStats events;
    LampLight<Rooms, RayStats> light(scene, lamps, rooms, events);
    lux[i] = light.at(places[i]);
    stats[i] = events;
}

using OctreeRooms = RoomsWith<OctreeTrees>;
using BoxRooms = RoomsWith<MeshTrees>;

template __global__ void lamp_kernel<float>(accel::SceneView, Lamps, BareRooms, const LitPlace<float>*, int, Vec3f*,
                                            RayStats*);
template __global__ void lamp_kernel<double>(accel::SceneView, Lamps, BareRooms, const LitPlace<double>*, int, Vec3f*,
                                             RayStats*);
template __global__ void lamp_kernel<float>(accel::SceneView, Lamps, OctreeRooms, const LitPlace<float>*, int, Vec3f*,
                                            RayStats*);
template __global__ void lamp_kernel<float>(accel::SceneView, Lamps, BoxRooms, const LitPlace<float>*, int, Vec3f*,
                                            RayStats*);

}  // namespace enfilade::render
