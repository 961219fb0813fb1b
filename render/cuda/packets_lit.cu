// Packets lit by the scene's lamps, in bare rooms.
#include "render/cuda/packets_kernel.h"

namespace enfilade::render::cuda {

void draw_lit_packets(Device& device, const PacketView& view, const Lamps& lamps) {
    draw_all(device, view, LeanRooms{}, TreeLight{lamps});
}

PacketCounts count_lit_packets(const PacketView& view, const Lamps& lamps) {
    return counts_of(view, LeanRooms{}, TreeLight{lamps});
}

}  // namespace enfilade::render::cuda
