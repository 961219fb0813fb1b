#pragma once
// A warp's part of a picture by packets: eight tiles, the corner rays of each in four lanes.

#include <cstdint>

#include "render/cuda/device_objects.h"
#include "render/cuda/launch.h"
#include "render/cuda/packets_counts.h"
#include "render/cuda/packets_fill.h"
#include "render/cuda/packets_lamps.h"
#include "render/cuda/packets_objects.h"
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
template <class Light>
struct PacketMemory {
    // Two tiles are taken, eight put back: each halving but the last leaves six more than the one before.
    static constexpr int most_waiting = 8 + 6 * (PacketView::most_halvings - 1);
    Bundle waiting[most_waiting];      ///< tiles that are to be split, the smallest last
    int log_sides[most_waiting];       ///< of these, in pixels
    Bundle tiles[warp_tiles];          ///< of the round
    Paint paints[warp_tiles];          ///< of those that are filled
    std::uint32_t filled[warp_tiles];  ///< which these are
    std::uint32_t parted[warp_tiles];  ///< and whose corners did not agree
    typename Light::Memory light;
};

enum class TileEnd : std::uint32_t { Absent, Walking, Filled, Parted };

/// The ray through a corner of a tile, where it is: a lane's own.
struct CornerRay {
    Ray<float> ray;
    std::uint32_t cell;
    std::uint32_t objects;  ///< of the cell, that the tile may meet
    bool is_mirrored;
    TilePlane plane;  ///< of furnished rooms
};

/// Lane k has the corner of tile k / 4 on the right (bit 0 of k), below (bit 1). What its corners share is in memory,
/// written by the first of them.
/// Light: what lights the picture (packets_lamps.h).
template <class Rooms, class Light, class Events>
class PacketWarp {
public:
    using Memory = PacketMemory<Light>;

    ENFILADE_HD PacketWarp(const PacketView& view, const Rooms& rooms, const Light& light, const Warp& warp,
                           Memory& memory, Events& events)
        : view_(view), rooms_(rooms), light_(light), warp_(warp), memory_(memory), events_(events) {}

    /// The w-th rectangle of 4 x 2 of the largest tiles.
    ENFILADE_HD void draw(std::uint64_t w) {
        const int left = static_cast<int>(w % view_.across) * PacketView::tiles_across;
        const int top = static_cast<int>(w / view_.across) * PacketView::tiles_down;
        int log_side = view_.log_largest;
        for (const int lane : warp_.lanes())
            if (lane < warp_tiles)
                memory_.tiles[lane] = bundle_at_eye(view_, (left + lane % PacketView::tiles_across) << log_side,
                                                    (top + lane / PacketView::tiles_across) << log_side);
        int tiles = warp_tiles, waiting = 0;
        for (;;) {
            warp_.meet();
            draw_round(tiles, log_side, waiting);
            if (waiting == 0) break;
            log_side = memory_.log_sides[waiting - 1] - 1;
            const int taken = waiting > 1 && memory_.log_sides[waiting - 2] == log_side + 1 ? 2 : 1;
            waiting -= taken;
            tiles = 4 * taken;
            for (const int lane : warp_.lanes()) {
                if (lane >= tiles) continue;
                Bundle& quarter = memory_.tiles[lane];
                quarter = memory_.waiting[waiting + (lane >> 2)];
                quarter.x += (lane & 1) << log_side;
                quarter.y += (lane >> 1 & 1) << log_side;
            }
        }
        if constexpr (!Light::has_lamps)
            if (are_astray_) draw_astray(left << view_.log_largest, top << view_.log_largest);
    }

private:
    static constexpr std::uint32_t astray = 0;  ///< no pixel is: their highest byte is 255

    /// Traces so many tiles; those that must be split are put to those that wait.
    ENFILADE_HD void draw_round(int tiles, int log_side, int& waiting) {
        std::uint32_t filled = 0, parted = 0;
        walk_corners(tiles, 1 << log_side, filled, parted);
        const bool may_split = 1 << log_side > view_.smallest;
        for (const int lane : warp_.lanes()) {
            if (lane >= warp_tiles) continue;
            const auto tile = static_cast<std::uint32_t>(lane);
            const std::uint32_t before = (1u << tile) - 1;
            if ((filled >> tile & 1u) != 0) memory_.filled[bit_count(filled & before)] = tile;
            if ((parted >> tile & 1u) == 0) continue;
            const int rank = bit_count(parted & before);
            memory_.parted[rank] = tile;
            if (!may_split) continue;
            memory_.waiting[waiting + rank] = memory_.tiles[tile];
            memory_.log_sides[waiting + rank] = log_side;
        }
        warp_.meet();
        fill_tiles(bit_count(filled), log_side);
        if (parted != 0) {
            events_.split(bit_count(parted));
            if (may_split) waiting += bit_count(parted);
            else draw_pixels(bit_count(parted), log_side);
        }
        warp_.meet();
    }

    /// The corners of a tile go on together until they part, or end. Bit k of the results: of tile k.
    ENFILADE_HD void walk_corners(int tiles, int side, std::uint32_t& filled, std::uint32_t& parted) {
        PerLane<CornerRay> corners;
        PerLane<TileEnd> ends;
        PerLane<bool> is;
        for (const int lane : warp_.lanes()) {
            const Bundle& tile = memory_.tiles[lane >> 2];
            is[lane] = lane >> 2 < tiles && tile.x < view_.width && tile.y < view_.height;
            ends[lane] = is[lane] ? TileEnd::Walking : TileEnd::Absent;
            if (is[lane]) corners[lane] = corner_of(tile, side, lane & 3);
        }
        std::uint32_t walking = warp_.ballot(is);
        events_.walked_corners(bit_count(full_groups(walking)));
        for (std::uint64_t steps = view_.scene.cells.count + 16; walking != 0 && steps > 0; --steps) {
            events_.stepped();
            take_step(corners, ends);
            for (const int lane : warp_.lanes()) is[lane] = ends[lane] == TileEnd::Walking;
            walking = warp_.ballot(is);
        }
        if constexpr (Light::has_lamps) ask_lamps(tiles, side, ends);
        for (const int lane : warp_.lanes()) is[lane] = ends[lane] == TileEnd::Filled;
        filled = full_groups(warp_.ballot(is));
        for (const int lane : warp_.lanes()) {
            is[lane] = ends[lane] == TileEnd::Parted || ends[lane] == TileEnd::Walking;
            if (!is[lane] || (lane & 3) != 0) continue;
            memory_.tiles[lane >> 2].cell = corners[lane].cell;
            memory_.tiles[lane >> 2].objects = corners[lane].objects;
        }
        parted = full_groups(warp_.ballot(is));
        warp_.meet();
    }

    /// Which lamps light the tiles that end at faces; where that is not told by their corners, they part.
    ENFILADE_HD void ask_lamps(int tiles, int side, PerLane<TileEnd>& ends) {
        PerLane<bool> asks, undecided;
        PerLane<Vec3f> places;
        warp_.meet();
        for (const int lane : warp_.lanes()) {
            const auto number = static_cast<std::uint32_t>(lane >> 2);
            asks[lane] =
                lane >> 2 < tiles && ends[lane] == TileEnd::Filled && memory_.paints[number].kind == PaintKind::Lamps;
            places[lane] = {0, 0, 0};
            if (!asks[lane]) continue;
            const Pixel corner = corner_pixel(memory_.tiles[number], side, lane & 3);
            // Where a ray runs along its face no number is sound: not even one corner may decide then.
            if (!place_on(view_, memory_.light.faces[number], static_cast<float>(corner.x) + 0.5f,
                          static_cast<float>(corner.y) + 0.5f, places[lane]))
                ends[lane] = TileEnd::Parted;
        }
        part_together(asks, ends);
        for (const int lane : warp_.lanes()) asks[lane] = asks[lane] && ends[lane] == TileEnd::Filled;
        TileLamps(view_, light_.lamps, warp_, memory_.light).decide(asks, places, undecided);
        for (const int lane : warp_.lanes())
            if (asks[lane] && undecided[lane]) ends[lane] = TileEnd::Parted;
    }

    /// Tiles of which a corner has parted part.
    ENFILADE_HD void part_together(const PerLane<bool>& asked, PerLane<TileEnd>& ends) {
        PerLane<bool> stays;
        for (const int lane : warp_.lanes()) stays[lane] = asked[lane] && ends[lane] == TileEnd::Filled;
        const std::uint32_t whole = full_groups(warp_.ballot(stays));
        for (const int lane : warp_.lanes())
            if (asked[lane] && (whole >> (lane >> 2) & 1u) == 0) ends[lane] = TileEnd::Parted;
    }

    struct Pixel {
        int x, y;
    };
    [[nodiscard]] ENFILADE_HD Pixel corner_pixel(const Bundle& tile, int side, int corner) const {
        const int right = tile.x + side < view_.width ? tile.x + side : view_.width;
        const int below = tile.y + side < view_.height ? tile.y + side : view_.height;
        return {(corner & 1) != 0 ? right - 1 : tile.x, (corner & 2) != 0 ? below - 1 : tile.y};
    }

    [[nodiscard]] ENFILADE_HD CornerRay corner_of(const Bundle& tile, int side, int corner) const {
        const Pixel pixel = corner_pixel(tile, side, corner);
        CornerRay result = {ray_of(view_, tile, pixel.x, pixel.y), tile.cell, 0, tile.is_mirrored(), {}};
        if constexpr (Rooms::are_furnished) {
            const Pixel last = corner_pixel(tile, side, 3);
            result.plane = TilePlane::of(view_, tile, last.x + 1, last.y + 1, corner);
        }
        return result;
    }

    /// Which objects of their cells the tiles may meet.
    ENFILADE_HD void look_around(PerLane<CornerRay>& corners, const PerLane<TileEnd>& ends) {
        PerLane<std::uint32_t> hidden;
        PerLane<int> beside, below;
        PerLane<bool> has_more;
        for (std::uint32_t first = 0;; first += most_in_bits) {
            for (const int lane : warp_.lanes()) {
                CornerRay& c = corners[lane];
                beside[lane] = lane ^ 1;
                below[lane] = lane ^ 2;
                hidden[lane] = ~0u;
                has_more[lane] = false;
                if (ends[lane] != TileEnd::Walking) continue;
                if (first == 0) c.objects = 0;
                hidden[lane] = hidden_by(view_.scene, c.plane, c.ray.origin, c.cell, first);
                has_more[lane] = object_count(view_.scene, c.cell) > first + most_in_bits;
            }
            PerLane<std::uint32_t> others = warp_.gathered(hidden, beside);
            for (const int lane : warp_.lanes()) hidden[lane] |= others[lane];
            others = warp_.gathered(hidden, below);
            for (const int lane : warp_.lanes()) {
                const std::uint32_t seen = ~(hidden[lane] | others[lane]);
                if (ends[lane] != TileEnd::Walking || seen == 0) continue;
                corners[lane].objects = first == 0 && !has_more[lane] ? seen : all_in_view;
            }
            if (warp_.ballot(has_more) == 0) return;
        }
    }

    /// All that walk leave their cells; tiles whose corners do so by one face go on through it, or end there.
    ENFILADE_HD void take_step(PerLane<CornerRay>& corners, PerLane<TileEnd>& ends) {
        if constexpr (Rooms::are_furnished) look_around(corners, ends);
        constexpr std::uint32_t by_floor = 0xfffffffeu, by_ceiling = 0xfffffffdu, by_none = 0xffffffffu;
        PerLane<WalkEnd<float>> exits;
        PerLane<std::uint32_t> keys;
        PerLane<int> beside, below;
        for (const int lane : warp_.lanes()) {
            keys[lane] = by_none;
            beside[lane] = lane ^ 1;
            below[lane] = lane ^ 2;
            const CornerRay& c = corners[lane];
            if (ends[lane] != TileEnd::Walking || c.objects != 0) continue;
            events_.entered_cell(view_.scene.cells[c.cell].section_count);
            WalkEnd<float>& end = exits[lane];
            if (leave_plainly(view_.scene, c.ray, c.cell, NoLimit{}, end) && !ends_behind(c.ray, end))
                keys[lane] = end.exit == Exit::Side ? end.face : end.exit == Exit::Floor ? by_floor : by_ceiling;
        }
        const PerLane<std::uint32_t> keys_beside = warp_.gathered(keys, beside),
                                     keys_below = warp_.gathered(keys, below);
        PerLane<bool> agrees;
        for (const int lane : warp_.lanes())
            agrees[lane] = keys[lane] != by_none && keys[lane] == keys_beside[lane] && keys[lane] == keys_below[lane];
        const std::uint32_t agreed = full_groups(warp_.ballot(agrees));
        for (const int lane : warp_.lanes()) {
            if (ends[lane] != TileEnd::Walking) continue;
            if ((agreed >> (lane >> 2) & 1u) != 0) follow(exits[lane], lane, corners[lane], ends[lane]);
            else ends[lane] = TileEnd::Parted;
        }
    }

    /// A corner leaves its cell by a face, as the three others do.
    ENFILADE_HD void follow(const WalkEnd<float>& exit, int lane, CornerRay& corner, TileEnd& end) {
        Bundle& tile = memory_.tiles[lane >> 2];
        const bool is_first = (lane & 3) == 0;
        if (exit.target.is_portal()) {
            if (is_first && exit.target.is_glass()) pass_glass(view_, exit, tile, events_);
            corner.cell = static_cast<std::uint32_t>(exit.target.neighbour());
        } else if (meets_mirror(view_, exit, corner.is_mirrored)) {
            if constexpr (Light::has_lamps) {
                end = TileEnd::Parted;  // two faces, each with its own lamps: pixel by pixel
                return;
            }
            if (is_first) reflect(view_, exit, tile);
            corner.ray = mirrored(corner.ray, view_.scene.cells[corner.cell].z_floor);
            corner.is_mirrored = true;
            corner.plane.normal.z = -corner.plane.normal.z;
        } else {
            end = TileEnd::Filled;
            if (is_first) memory_.paints[lane >> 2] = paint_of(view_, tile, exit);
            if constexpr (Light::has_lamps) {
                if (view_.scene.source_faces[exit.target.bits].surface == accel::Surface::Sky) return;
                if (is_near_plane(view_, exit)) end = TileEnd::Parted;
                if (!is_first) return;
                memory_.light.faces[lane >> 2] = lit_face(view_, light_.lamps, tile, exit);
                memory_.paints[lane >> 2].kind = PaintKind::Lamps;
            }
        }
    }

    /// All lanes fill all tiles: four columns each, of as many tiles at once as they have lanes for.
    ENFILADE_HD void fill_tiles(int tiles, int log_side) {
        const int log_across = log_side - 2;
        const int log_lanes = log_across + log_side < 5 ? log_across + log_side : 5;  // of a tile
        const int step = 1 << (log_lanes - log_across);                               // of rows
        for (int first = 0; first < tiles; first += warp_size >> log_lanes) {
            events_.filled_tiles(1 << (log_side - log_lanes + log_across));
            for (const int lane : warp_.lanes()) {
                const int number = first + (lane >> log_lanes), within = lane & ((1 << log_lanes) - 1);
                if (number >= tiles) continue;
                const Paint paint = memory_.paints[memory_.filled[number]];
                const int left = static_cast<int>(paint.place & 0xffffu), top = static_cast<int>(paint.place >> 16);
                const int x = left + ((within & ((1 << log_across) - 1)) << 2);
                if (x >= view_.width) continue;
                const int end = top + (1 << log_side) < view_.height ? top + (1 << log_side) : view_.height;
                const int y = top + (within >> log_across);
                bool has_lamps = false;
                if constexpr (Light::has_lamps) {
                    has_lamps = paint.kind == PaintKind::Lamps;
                    if (has_lamps) fill_lit_columns(view_, memory_.light, memory_.filled[number], x, y, step, end);
                }
                if (!has_lamps) fill_columns(view_, paint, x, y, step, end);
                const int columns = view_.width - x < 4 ? view_.width - x : 4;
                if (y < end) events_.filled(static_cast<std::uint64_t>(columns * ((end - y + step - 1) / step)));
            }
        }
    }

    /// Pixels of tiles that have parted, one a lane.
    ENFILADE_HD void draw_pixels(int tiles, int log_side) {
        for (int first = 0; first < tiles << (2 * log_side); first += warp_size) {
            int drawn = 0;
            PerLane<bool> is_astray;
            for (const int lane : warp_.lanes()) {
                const int pixel = first + lane;
                is_astray[lane] = false;
                if (pixel >= tiles << (2 * log_side)) continue;
                const Bundle& tile = memory_.tiles[memory_.parted[pixel >> (2 * log_side)]];
                const int x = tile.x + (pixel & ((1 << log_side) - 1));
                const int y = tile.y + (pixel >> log_side & ((1 << log_side) - 1));
                if (x >= view_.width || y >= view_.height) continue;
                ++drawn;
                Vec3f light;
                if constexpr (Light::has_lamps) light = lit_pixel_from_eye(view_, light_.lamps, rooms_, x, y);
                else is_astray[lane] = !PixelWay<Rooms, Events>(view_, rooms_, tile, x, y, events_).follow(light);
                *pixel_at(view_, x, y) = is_astray[lane] ? astray : encoded(light);
            }
            are_astray_ |= warp_.ballot(is_astray) != 0;
            events_.walked_pixels(drawn);
        }
    }

    /// Pixels that the lean walk left, as the scalar tracer has them. Looked for when all else is done: that costs the
    /// other pixels no registers.
    ENFILADE_HD void draw_astray(int left, int top) {
        warp_.meet();
        const int log_across = view_.log_largest + 2, pixels = 1 << (2 * view_.log_largest + 3);
        for (int first = 0; first < pixels; first += warp_size)
            for (const int lane : warp_.lanes()) {
                const int x = left + ((first + lane) & ((1 << log_across) - 1)),
                          y = top + ((first + lane) >> log_across);
                if (x >= view_.width || y >= view_.height || *pixel_at(view_, x, y) != astray) continue;
                events_.walked_from_start();
                *pixel_at(view_, x, y) = encoded(pixel_from_eye(view_, rooms_, x, y));
            }
    }

    const PacketView& view_;
    const Rooms& rooms_;
    const Light& light_;
    const Warp& warp_;
    Memory& memory_;
    Events& events_;
    bool are_astray_ = false;
};

/// A warp's rectangle.
template <class Rooms, class Light>
struct PacketKernel {
    static constexpr LaunchShape shape = {128, Rooms::are_furnished || Light::has_lamps ? 4 : 6};
    PacketView view;
    Rooms rooms;
    Light light;

    ENFILADE_HD void operator()(Warp warp, std::uint64_t w) const {
        WarpMemory<PacketMemory<Light>, shape.block> memory;
        NoPacketEvents none;
        PacketWarp<Rooms, Light, NoPacketEvents>(view, rooms, light, warp, memory.get(), none).draw(w);
    }
};

/// Warps of a picture.
inline std::uint64_t warps_of(const PacketView& view) {
    const int pixels_down = PacketView::tiles_down << view.log_largest;
    return std::uint64_t{view.across} * static_cast<std::uint64_t>((view.height + pixels_down - 1) / pixels_down);
}

template <class Rooms, class Light>
void draw_all(Device& device, const PacketView& view, const Rooms& rooms, const Light& light) {
    for_each_warp(device, warps_of(view), PacketKernel<Rooms, Light>{view, rooms, light});
}

/// One warp after the other, counted.
template <class Rooms, class Light>
PacketCounts counts_of(const PacketView& view, const Rooms& rooms, const Light& light) {
    PacketMemory<Light> memory;
    PacketCounts counts;
    const Warp warp;
    for (std::uint64_t w = 0; w < warps_of(view); ++w)
        PacketWarp<Rooms, Light, PacketCounts>(view, rooms, light, warp, memory, counts).draw(w);
    return counts;
}

/// Calls body(rooms) for what knows the inside of objects.
template <class Body>
auto among(const DeviceObjects& objects, const Body& body) {
    if (objects.kind() == InsideKind::Octree) return body(RoomsWith<decltype(objects.octrees())>{objects.octrees()});
    return body(RoomsWith<decltype(objects.bvhs())>{objects.bvhs()});
}

// Files of their own, for kernels take long to compile: furnished rooms; lamps.
void draw_furnished_packets(Device& device, const PacketView& view, const DeviceObjects& objects);
[[nodiscard]] PacketCounts count_furnished_packets(const PacketView& view, const DeviceObjects& objects);
void draw_lit_packets(Device& device, const PacketView& view, const Lamps& lamps);
[[nodiscard]] PacketCounts count_lit_packets(const PacketView& view, const Lamps& lamps);

}  // namespace enfilade::render::cuda
