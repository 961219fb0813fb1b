#include "render/cuda/packets.h"

#include "render/cuda/packets_kernel.h"

namespace enfilade::render::cuda {
namespace {

int power_of(int side) {
    int log = 0;
    while (1 << log < side) ++log;
    return log;
}

PacketView view_of(const PacketJob& job) {
    PacketView view = {};
    view.scene = *job.scene;
    view.camera = job.camera;
    view.lengths = SquaredLengths::of(job.camera);
    view.look = job.look;
    view.start_cell = static_cast<std::uint32_t>(job.start);
    view.mirror_floor = job.mirror_floor;
    view.width = job.width;
    view.height = job.height;
    view.rgba = job.rgba;
    view.smallest = job.tiles.smallest;
    view.log_largest = power_of(job.tiles.largest);
    const int pixels_across = PacketView::tiles_across * job.tiles.largest;
    view.across = static_cast<std::uint32_t>((job.width + pixels_across - 1) / pixels_across);
    view.stores_quads = job.width % 4 == 0;
    return view;
}

}  // namespace

PacketTiles tiles_for(int multiprocessors, int width, int height, bool is_furnished) {
    constexpr std::int64_t warps = 8;
    const std::int64_t pixels = std::int64_t{width} * height;
    int side = 64;
    while (side > 8 &&
           pixels < warps * multiprocessors * PacketView::tiles_across * PacketView::tiles_down * side * side)
        side /= 2;
    return {side, is_furnished ? 8 : 4};
}

void draw_packets(Device& device, const PacketJob& job) {
    const PacketView view = view_of(job);
    const DeviceObjects* objects = view.scene.has_objects() ? job.objects : nullptr;
    if (job.lamps != nullptr) return draw_lit_packets(device, view, *job.lamps);
    if (objects != nullptr) return draw_furnished_packets(device, view, *objects);
    draw_all(device, view, BareRooms{}, EyeLight{});
}

PacketCounts count_packets(const PacketJob& job) {
    const PacketView view = view_of(job);
    const DeviceObjects* objects = view.scene.has_objects() ? job.objects : nullptr;
    if (job.lamps != nullptr) return count_lit_packets(view, *job.lamps);
    if (objects != nullptr) return count_furnished_packets(view, *objects);
    return counts_of(view, BareRooms{}, EyeLight{});
}

}  // namespace enfilade::render::cuda
