#include "render/cuda/packets.h"

#include "render/cuda/packets_kernel.h"

namespace enfilade::render::cuda {
namespace {

int power_of(int side) {
    int log = 0;
    while (1 << log < side) ++log;
    return log;
}

/// Rectangles of warps, from one end of the image to the other.
std::uint32_t rectangles(int pixels, int tiles, int side) {
    return static_cast<std::uint32_t>((pixels + tiles * side - 1) / (tiles * side));
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
    view.across = rectangles(job.width, PacketView::tiles_across, job.tiles.largest);
    view.stores_quads = job.width % 4 == 0;
    return view;
}

std::uint64_t warps_of(const PacketView& view) {
    return std::uint64_t{view.across} * rectangles(view.height, PacketView::tiles_down, 1 << view.log_largest);
}

}  // namespace

void draw_packets(Device& device, const PacketJob& job) {
    const PacketKernel<BareRooms> kernel = {view_of(job), {}};
    for_each_warp(device, warps_of(kernel.view), kernel);
}

PacketCounts count_packets(const PacketJob& job) {
    const PacketView view = view_of(job);
    PacketMemory memory;
    PacketCounts counts;
    for (std::uint64_t w = 0; w < warps_of(view); ++w)
        PacketWarp<BareRooms, PacketCounts>(view, BareRooms{}, Warp(), memory, counts).draw(w);
    return counts;
}

}  // namespace enfilade::render::cuda
