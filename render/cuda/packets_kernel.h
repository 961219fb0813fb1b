#pragma once
// A warp's part of a picture by packets: eight tiles, the corner rays of each in four lanes.

#include <cstdint>

#include "render/cuda/launch.h"
#include "render/cuda/packets_fill.h"
#include "render/cuda/packets_pixel.h"
#include "render/cuda/packets_view.h"
#include "render/cuda/warp_memory.h"

namespace enfilade::render::cuda {

inline constexpr int warp_tiles = 8;

ENFILADE_HD int bit_count(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return __popc(bits);
#else
    return __builtin_popcount(bits);
#endif
}

/// Of eight groups of four bits, bit k: all of group k are set.
ENFILADE_HD std::uint32_t full_groups(std::uint32_t lanes) {
    std::uint32_t all = lanes & lanes >> 1;
    all = all & all >> 2 & 0x11111111u;
    all = (all | all >> 3) & 0x03030303u;
    all = (all | all >> 6) & 0x000f000fu;
    return (all | all >> 12) & 0xffu;
}

/// What the lanes of a warp tell each other.
struct PacketMemory {
    // Two tiles are taken, eight put back: each of at most six halvings leaves six more than the one before.
    static constexpr int most_waiting = 8 + 6 * 6;
    Bundle waiting[most_waiting];  ///< tiles that are to be split, the smallest last
    int log_sides[most_waiting];   ///< of these, in pixels
    Bundle parted[warp_tiles];     ///< tiles of the round whose pixels go on by themselves
    Paint paints[warp_tiles];      ///< of the tiles of the round that are filled
};

enum class TileEnd : std::uint32_t { Absent, Walking, Filled, Parted };

/// Corner rays of a tile: lane k % 4 has the corner to the right (bit 0), below (bit 1).
template <class Rooms, class Events>
class PacketWarp {
public:
    ENFILADE_HD PacketWarp(const PacketView& view, const Rooms& rooms, const Warp& warp, PacketMemory& memory,
                           Events& events)
        : view_(view), rooms_(rooms), warp_(warp), memory_(memory), events_(events) {}

    /// The w-th rectangle of 4 x 2 of the largest tiles.
    ENFILADE_HD void draw(std::uint64_t w) {
        PerLane<Bundle> bundles;
        const int left = static_cast<int>(w % view_.across) * PacketView::tiles_across;
        const int top = static_cast<int>(w / view_.across) * PacketView::tiles_down;
        int log_side = view_.log_largest;
        for (const int lane : warp_.lanes())
            bundles[lane] = bundle_at_eye(view_, (left + (lane >> 2) % PacketView::tiles_across) << log_side,
                                          (top + (lane >> 2) / PacketView::tiles_across) << log_side);
        int waiting = 0;
        std::uint32_t present = 0xffu;
        for (;;) {
            draw_round(bundles, log_side, present, waiting);
            if (waiting == 0) return;
            log_side = memory_.log_sides[waiting - 1] - 1;
            const int taken = waiting > 1 && memory_.log_sides[waiting - 2] == log_side + 1 ? 2 : 1;
            waiting -= taken;
            present = taken == 2 ? 0xffu : 0x0fu;
            for (const int lane : warp_.lanes()) {
                const int group = lane >> 2, quarter = group & 3;
                bundles[lane] = memory_.waiting[waiting + (taken == 2 ? group >> 2 : 0)];
                bundles[lane].x += (quarter & 1) << log_side;
                bundles[lane].y += (quarter >> 1) << log_side;
            }
            warp_.meet();
        }
    }

private:
    /// Traces up to eight tiles; those that must be split are put to those that wait.
    ENFILADE_HD void draw_round(PerLane<Bundle>& bundles, int log_side, std::uint32_t present, int& waiting) {
        const int side = 1 << log_side;
        const bool may_split = side > view_.smallest;
        PerLane<TileEnd> ends;
        walk_corners(bundles, side, present, ends);
        PerLane<bool> is;
        for (const int lane : warp_.lanes()) is[lane] = ends[lane] == TileEnd::Filled;
        const std::uint32_t filled = full_groups(warp_.ballot(is));
        for (const int lane : warp_.lanes()) is[lane] = ends[lane] == TileEnd::Parted;
        const std::uint32_t parted = full_groups(warp_.ballot(is));
        for (const int lane : warp_.lanes()) {
            if ((lane & 3) != 0 || (parted >> (lane >> 2) & 1u) == 0) continue;
            const int rank = bit_count(parted & ((1u << (lane >> 2)) - 1));
            if (may_split) {
                memory_.waiting[waiting + rank] = bundles[lane];
                memory_.log_sides[waiting + rank] = log_side;
            } else {
                memory_.parted[rank] = bundles[lane];
            }
        }
        warp_.meet();
        if (filled != 0) fill_tiles(bit_count(filled), log_side);
        if (parted != 0) {
            events_.split(bit_count(parted));
            if (may_split) waiting += bit_count(parted);
            else draw_pixels(bit_count(parted), log_side);
        }
        warp_.meet();
    }

    /// The corners of a tile go on together until they part, or end.
    ENFILADE_HD void walk_corners(PerLane<Bundle>& bundles, int side, std::uint32_t present, PerLane<TileEnd>& ends) {
        PerLane<Ray<float>> rays;
        PerLane<WalkEnd<float>> exits;
        PerLane<bool> is;
        for (const int lane : warp_.lanes()) {
            const Bundle& bundle = bundles[lane];
            const bool is_present =
                (present >> (lane >> 2) & 1u) != 0 && bundle.x < view_.width && bundle.y < view_.height;
            ends[lane] = is_present ? TileEnd::Walking : TileEnd::Absent;
            is[lane] = is_present;
            const int right = bundle.x + side < view_.width ? bundle.x + side : view_.width;
            const int below = bundle.y + side < view_.height ? bundle.y + side : view_.height;
            rays[lane] =
                ray_of(view_, bundle, (lane & 1) != 0 ? right - 1 : bundle.x, (lane & 2) != 0 ? below - 1 : bundle.y);
        }
        std::uint32_t walking = warp_.ballot(is);
        events_.walked_corners(bit_count(full_groups(walking)));
        for (std::uint64_t steps = view_.scene.cells.count + 16; walking != 0 && steps > 0; --steps) {
            events_.stepped();
            const std::uint32_t agreed = leave_cells(bundles, rays, ends, exits);
            for (const int lane : warp_.lanes()) {
                if (ends[lane] == TileEnd::Walking) {
                    const bool agrees = (agreed >> (lane >> 2) & 1u) != 0;
                    take_step(agrees, exits[lane], bundles[lane], rays[lane], ends[lane]);
                }
                is[lane] = ends[lane] == TileEnd::Walking;
            }
            walking = warp_.ballot(is);
        }
        for (const int lane : warp_.lanes())
            if (ends[lane] == TileEnd::Walking) ends[lane] = TileEnd::Parted;
        for (const int lane : warp_.lanes()) is[lane] = ends[lane] == TileEnd::Filled;
        const std::uint32_t filled = full_groups(warp_.ballot(is));
        for (const int lane : warp_.lanes())
            if ((lane & 3) == 0 && ends[lane] == TileEnd::Filled)
                memory_.paints[bit_count(filled & ((1u << (lane >> 2)) - 1))] =
                    paint_of(view_, bundles[lane], exits[lane]);
    }

    /// By which faces the corners leave their cells. Bit k: those of group k by the same one.
    ENFILADE_HD std::uint32_t leave_cells(const PerLane<Bundle>& bundles, const PerLane<Ray<float>>& rays,
                                          const PerLane<TileEnd>& ends, PerLane<WalkEnd<float>>& exits) {
        constexpr std::uint32_t by_floor = 0xfffffffeu, by_ceiling = 0xfffffffdu, by_none = 0xffffffffu;
        PerLane<std::uint32_t> keys;
        PerLane<int> beside, below;
        for (const int lane : warp_.lanes()) {
            keys[lane] = by_none;
            beside[lane] = lane ^ 1;
            below[lane] = lane ^ 2;
            if (ends[lane] != TileEnd::Walking) continue;
            const Bundle& b = bundles[lane];
            events_.entered_cell(view_.scene.cells[b.cell].section_count);
            WalkEnd<float>& end = exits[lane];
            leave_cell(view_.scene, rays[lane], b.cell, b.entry, b.entry_next, true, NoLimit{}, events_, end);
            if (!ends_behind(rays[lane], end))
                keys[lane] = end.exit == Exit::Side ? end.face : end.exit == Exit::Floor ? by_floor : by_ceiling;
        }
        const PerLane<std::uint32_t> keys_beside = warp_.gathered(keys, beside),
                                     keys_below = warp_.gathered(keys, below);
        PerLane<bool> agrees;
        for (const int lane : warp_.lanes())
            agrees[lane] = keys[lane] != by_none && keys[lane] == keys_beside[lane] && keys[lane] == keys_below[lane];
        return full_groups(warp_.ballot(agrees));
    }

    ENFILADE_HD void take_step(bool agrees, const WalkEnd<float>& exit, Bundle& bundle, Ray<float>& ray, TileEnd& end) {
        if (!agrees) {
            end = TileEnd::Parted;
        } else if (exit.target.is_portal()) {
            go_on(view_, exit, bundle, events_);
        } else if (meets_mirror(view_, exit, bundle)) {
            reflect(view_, exit, bundle);
            ray = mirrored(ray, view_.scene.cells[bundle.cell].z_floor);
        } else {
            end = TileEnd::Filled;
        }
    }

    /// All lanes fill all tiles, one after the other.
    ENFILADE_HD void fill_tiles(int tiles, int log_side) {
        const int log_quads = 2 * log_side - 2, log_across = log_side - 2;
        for (int first = 0; first < tiles << log_quads; first += warp_size) {
            events_.filled_round();
            for (const int lane : warp_.lanes()) {
                const int quad = first + lane;
                if (quad >= tiles << log_quads) continue;
                const Paint& paint = memory_.paints[quad >> log_quads];
                const int x = static_cast<int>(paint.place & 0xffffu) + ((quad & ((1 << log_across) - 1)) << 2);
                const int y = static_cast<int>(paint.place >> 16) + (quad >> log_across & ((1 << log_side) - 1));
                if (x >= view_.width || y >= view_.height) continue;
                fill_four(view_, paint, x, y);
                events_.filled(static_cast<std::uint64_t>(view_.width - x < 4 ? view_.width - x : 4));
            }
        }
    }

    /// Pixels of tiles that have parted, so many a lane.
    ENFILADE_HD void draw_pixels(int tiles, int log_side) {
        for (int first = 0; first < tiles << (2 * log_side); first += warp_size) {
            int drawn = 0;
            for (const int lane : warp_.lanes()) {
                const int pixel = first + lane;
                if (pixel >= tiles << (2 * log_side)) continue;
                const Bundle& bundle = memory_.parted[pixel >> (2 * log_side)];
                const int x = bundle.x + (pixel & ((1 << log_side) - 1));
                const int y = bundle.y + (pixel >> log_side & ((1 << log_side) - 1));
                if (x >= view_.width || y >= view_.height) continue;
                ++drawn;
                view_.rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                           static_cast<std::size_t>(x)] = encoded(pixel_from(view_, rooms_, bundle, x, y, events_));
            }
            events_.walked_pixels(drawn);
        }
    }

    const PacketView& view_;
    const Rooms& rooms_;
    const Warp& warp_;
    PacketMemory& memory_;
    Events& events_;
};

/// A warp's rectangle.
template <class Rooms>
struct PacketKernel {
    static constexpr LaunchShape shape = {128, 4};
    PacketView view;
    Rooms rooms;

    ENFILADE_HD void operator()(Warp warp, std::uint64_t w) const {
        WarpMemory<PacketMemory, shape.block> memory;
        NoPacketEvents none;
        PacketWarp<Rooms, NoPacketEvents>(view, rooms, warp, memory.get(), none).draw(w);
    }
};

}  // namespace enfilade::render::cuda
