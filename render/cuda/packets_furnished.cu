// Packets among octrees or trees of boxes, apart from those of bare rooms: kernels take long to compile.
#include "render/cuda/packets_kernel.h"

namespace enfilade::render::cuda {
namespace {

template <class Body>
auto among(const DeviceObjects& objects, const Body& body) {
    if (objects.kind() == InsideKind::Octree) return body(RoomsWith<OctreeTrees>{objects.octrees()});
    return body(RoomsWith<MeshTrees>{objects.bvhs()});
}

}  // namespace

void draw_furnished_packets(Device& device, const PacketView& view, const DeviceObjects& objects) {
    among(objects, [&](const auto& rooms) {
        for_each_warp(device, warps_of(view), PacketKernel<std::decay_t<decltype(rooms)>>{view, rooms});
    });
}

PacketCounts count_furnished_packets(const PacketView& view, const DeviceObjects& objects) {
    return among(objects, [&](const auto& rooms) { return counts_of(view, rooms); });
}

}  // namespace enfilade::render::cuda
