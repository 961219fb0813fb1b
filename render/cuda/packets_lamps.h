#pragma once
// Tiles lit by lamps: the corners of a tile tell of each beam of light that comes into its cell whether it holds all of
// the tile's part of the face, or none: beams are convex. What is lit by some lamps as a whole sums those, and nothing
// is asked a pixel.

#include <cstdint>

#include "render/cuda/packets_fill.h"
#include "render/lit_pixel.h"

namespace enfilade::render::cuda {

/// The face that a tile ends at, as its lamps see it.
struct alignas(16) LitFace {
    Vec3f normal;        ///< of length 1, on the light's side
    float away;          ///< from the eye to its plane, metres
    Vec3f scale;         ///< of lux: what the picture shows of them
    std::uint32_t cell;  ///< before it
};

/// A lamp that lights a tile, on its face: what it gives is strength / distance^3.
struct alignas(16) LitLamp {
    Vec3f position;
    std::uint32_t light;
    Vec3f strength;  ///< candela, tinted, times the lamp's height over the face
    float height;
};

/// What the lanes of a warp tell each other about lamps. More lamps than that, and a tile is split.
struct LampMemory {
    static constexpr int most = 12;
    LitFace faces[8];
    LitLamp lamps[8][most];
    int counts[8];
};

// What lights a picture.

/// A lamp at the eye.
struct EyeLight {
    static constexpr bool has_lamps = false;
    struct Memory {};
};

/// The scene's lamps, by their light trees.
struct TreeLight {
    static constexpr bool has_lamps = true;
    using Memory = LampMemory;
    Lamps lamps;
};

/// From the eye to the plane by which a walk ended, along its outward normal.
ENFILADE_HD float way_to_plane(const PacketView& view, const WalkEnd<float>& end, Vec3f outward) {
    const Vec3f eye = view.camera.origin;
    if (end.exit == Exit::Floor) return eye.z - view.scene.cells[end.cell].z_floor;
    if (end.exit == Exit::Ceiling) return view.scene.cells[end.cell].z_ceiling - eye.z;
    return outward.x * (view.scene.section_x[end.section] - eye.x) +
           outward.y * (view.scene.section_y[end.section] - eye.y);
}

/// Whether the eye is so near to the plane that places on it are noise.
ENFILADE_HD bool is_near_plane(const PacketView& view, const WalkEnd<float>& end) {
    return !(way_to_plane(view, end, -normal_of(view.scene, end)) > 0x1p-7f);
}

ENFILADE_HD LitFace lit_face(const PacketView& view, const Lamps& lamps, const Bundle& bundle,
                             const WalkEnd<float>& end) {
    constexpr float inverse_pi = 0.318309886f;
    const Vec3f normal = normal_of(view.scene, end);
    const Vec3f colour = colour_of(view.scene, view.scene.source_faces[end.target.bits]);
    return {normal, way_to_plane(view, end, -normal), inverse_pi * lamps.exposure * (bundle.tint * colour), end.cell};
}

/// The place on the face that a pixel shows. False where the ray runs along the face.
ENFILADE_HD bool place_on(const PacketView& view, const LitFace& face, float x, float y, Vec3f& place) {
    const Vec3f direction = view.camera.direction(x, y);
    const float facing = -dot(face.normal, direction);
    if (!(facing > 1e-6f)) return false;
    place = view.camera.origin + (face.away / facing) * direction;
    return true;
}

/// Where a place lies of a beam: bit 0 where it does not face the lamp, bit 1 + i beyond plane i; bit 31 beyond one
/// that has no bit. 0: the beam lights it.
ENFILADE_HD std::uint32_t beyond_planes(const accel::LightTreesView& trees, std::uint32_t beam, Vec3f way,
                                        Vec3f normal) {
    std::uint32_t beyond = dot(way, normal) < 0 ? 0u : 1u;
    std::uint32_t bit = 1;
    for (const accel::BeamPlane& plane : trees.planes_of(beam)) {
        if (!(plane.x * way.x + plane.y * way.y + plane.z * way.z >= 0)) beyond |= 1u << (bit < 31 ? bit : 31);
        ++bit;
    }
    return beyond;
}
/// Those of which one tells that a whole tile lies beyond it.
inline constexpr std::uint32_t single_planes = 0x7fffffffu;

ENFILADE_HD LitLamp lit_lamp(const PacketView& view, const accel::LightTreesView& trees, const LitFace& face,
                             Vec3f place, std::uint32_t light, std::uint32_t beam) {
    const accel::Light& lamp = view.scene.lights[light];
    const auto* candela = reinterpret_cast<const float*>(&lamp.intensity);
    const accel::Vertex& tint = trees.tints[trees.beams[beam].tint];
    const Vec3f position = position_of<float>(lamp);
    const float height = dot(position - place, face.normal);
    return {position, light, height * Vec3f{candela[0] * tint.x, candela[1] * tint.y, candela[2] * tint.z}, height};
}

/// A pixel of a face that some lamps light.
ENFILADE_HD std::uint32_t lit_face_pixel(const PacketView& view, const LitFace& face, const LitLamp* lamps, int count,
                                         float x, float y) {
    const Vec3f direction = view.camera.direction(x, y);
    const Vec3f place = view.camera.origin + (face.away / -dot(face.normal, direction)) * direction;
    Vec3f lux = {0, 0, 0};
    for (int l = 0; l < count; ++l) {
        const Vec3f way = place - lamps[l].position;
        const float inverse = quick_inverse_root(dot(way, way));
        lux = lux + (inverse * inverse * inverse) * lamps[l].strength;
    }
    return encoded(lux * face.scale);
}

/// Linear light of a pixel, as the scalar tracer has it. Out of line: the other pixels have more registers so.
template <class Rooms>
ENFILADE_HD_COLD Vec3f lit_pixel_from_eye(const PacketView& view, const Lamps& lamps, const Rooms& rooms, int x,
                                          int y) {
    const LitPicture picture = {&view.scene, &view.camera, &view.look, &lamps, view.start_cell, view.mirror_floor};
    NoEvents none;
    return lit_pixel<float>(picture, rooms, x, y, none);
}

/// Four columns of a tile that some lamps light, as fill_columns.
ENFILADE_HD void fill_lit_columns(const PacketView& view, const LampMemory& memory, std::uint32_t tile, int x, int y,
                                  int step, int end) {
    const LitFace face = memory.faces[tile];
    const float first = static_cast<float>(x) + 0.5f;
    for (; y < end; y += step) {
        FourPixels pixels;
        for (int i = 0; i < 4; ++i)
            pixels.of[i] = lit_face_pixel(view, face, memory.lamps[tile], memory.counts[tile],
                                          first + static_cast<float>(i), static_cast<float>(y) + 0.5f);
        store_four(view, x, pixel_at(view, x, y), pixels);
    }
}

/// Which lamps light tiles as a whole, to memory. places: on the tile's face, of each of its corners; asks: whether
/// there is one. undecided: tiles of which some lamp lights a part, or nobody knows.
class TileLamps {
public:
    ENFILADE_HD TileLamps(const PacketView& view, const Lamps& lamps, const Warp& warp, LampMemory& memory)
        : view_(view), trees_(lamps.trees), warp_(warp), memory_(memory) {}

    ENFILADE_HD void decide(const PerLane<bool>& asks, const PerLane<Vec3f>& places, PerLane<bool>& undecided) {
        PerLane<bool> goes;
        for (const int lane : warp_.lanes()) {
            beside_[lane] = lane ^ 1;
            below_[lane] = lane ^ 2;
            count_[lane] = 0;
            next_[lane] = past_[lane] = 0;
            last_lit_[lane] = ~0u;
            undecided[lane] = false;
            if (asks[lane]) {
                const std::uint32_t cell = memory_.faces[lane >> 2].cell;
                next_[lane] = trees_.cell_offsets[cell];
                past_[lane] = trees_.cell_offsets[cell + 1];
            }
            goes[lane] = next_[lane] < past_[lane];
        }
        while (warp_.ballot(goes) != 0) ask_next(goes, places, undecided);
        for (const int lane : warp_.lanes())
            if (asks[lane] && (lane & 3) == 0) memory_.counts[lane >> 2] = count_[lane];
    }

private:
    /// Each tile asks the next beam of its cell.
    ENFILADE_HD void ask_next(PerLane<bool>& goes, const PerLane<Vec3f>& places, PerLane<bool>& undecided) {
        PerLane<std::uint32_t> any, all;
        for (const int lane : warp_.lanes()) {
            any[lane] = goes[lane] ? beyond(lane, places[lane]) : 0;
            all[lane] = any[lane];
        }
        for (const PerLane<int>* from : {&beside_, &below_}) {
            const PerLane<std::uint32_t> other_any = warp_.gathered(any, *from), other_all = warp_.gathered(all, *from);
            for (const int lane : warp_.lanes()) {
                any[lane] |= other_any[lane];
                all[lane] &= other_all[lane];
            }
        }
        for (const int lane : warp_.lanes()) {
            if (!goes[lane]) continue;
            const bool is_dark = (all[lane] & single_planes) != 0, is_lit = any[lane] == 0;
            if (is_lit && count_[lane] < LampMemory::most) light(lane, places[lane]);
            else undecided[lane] = !is_dark;
            ++next_[lane];
            goes[lane] = !undecided[lane] && next_[lane] < past_[lane];
        }
    }

    [[nodiscard]] ENFILADE_HD std::uint32_t beyond(int lane, Vec3f place) const {
        const accel::CellLight& entry = trees_.cell_lights[next_[lane]];
        const auto number = static_cast<std::uint32_t>(entry.light);
        if (number == last_lit_[lane]) return 1;  // by another of its beams
        const Vec3f way = place - position_of<float>(view_.scene.lights[number]);
        const Vec3f normal = memory_.faces[lane >> 2].normal;
        if (entry.beam == accel::no_beam) return (dot(way, normal) < 0 ? 0u : 1u) | ~single_planes;
        return beyond_planes(trees_, entry.beam, way, normal);
    }

    ENFILADE_HD void light(int lane, Vec3f place) {
        const accel::CellLight& entry = trees_.cell_lights[next_[lane]];
        last_lit_[lane] = static_cast<std::uint32_t>(entry.light);
        const int tile = lane >> 2, number = count_[lane]++;
        if ((lane & 3) == 0)
            memory_.lamps[tile][number] =
                lit_lamp(view_, trees_, memory_.faces[tile], place, last_lit_[lane], entry.beam);
    }

    const PacketView& view_;
    const accel::LightTreesView& trees_;
    const Warp& warp_;
    LampMemory& memory_;
    PerLane<int> beside_, below_, count_;
    PerLane<std::uint32_t> next_, past_, last_lit_;
};

}  // namespace enfilade::render::cuda
