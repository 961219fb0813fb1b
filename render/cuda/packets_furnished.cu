// Packets among octrees or trees of boxes.
#include "render/cuda/packets_kernel.h"

namespace enfilade::render::cuda {

void draw_furnished_packets(Device& device, const PacketView& view, const DeviceObjects& objects) {
    among(objects, [&](const auto& rooms) { draw_all(device, view, rooms, EyeLight{}); });
}

PacketCounts count_furnished_packets(const PacketView& view, const DeviceObjects& objects) {
    return among(objects, [&](const auto& rooms) { return counts_of(view, rooms, EyeLight{}); });
}

}  // namespace enfilade::render::cuda
