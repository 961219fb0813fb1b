#pragma once
// What all warps of a picture by packets read, and what the rays of a tile have in common.

#include <cstdint>

#include "render/camera.h"
#include "render/cuda/warp.h"
#include "render/lambert.h"
#include "render/lean_walk.h"

namespace enfilade::render::cuda {

/// d . d of the camera's directions: a polynomial over the image, and in a row a + x (b + x c).
struct SquaredLengths {
    float of_corner, by_x, by_y, by_xx, by_xy, by_yy;

    static SquaredLengths of(const CameraFrame& camera) {
        return {dot(camera.corner, camera.corner), 2 * dot(camera.corner, camera.du), 2 * dot(camera.corner, camera.dv),
                dot(camera.du, camera.du),         2 * dot(camera.du, camera.dv),     dot(camera.dv, camera.dv)};
    }
};

/// A picture's numbers, in the constant memory of its launch.
struct PacketView {
    accel::SceneView scene;
    CameraFrame camera;
    SquaredLengths lengths;
    Look look;
    std::uint32_t start_cell;
    float mirror_floor;
    int width, height;
    std::uint32_t* rgba;
    int largest, smallest;  ///< sides of tiles, powers of two
    int log_largest;        ///< its power
    std::uint32_t across;   ///< warps beside each other
    bool stores_quads;      ///< four pixels of a row may be stored at once: its width is a multiple of four
    static constexpr int tiles_across = 4, tiles_down = 2;  ///< of a warp
    static constexpr int most_halvings = 4;                 ///< from the largest tiles to the smallest
};

ENFILADE_HD std::uint32_t* pixel_at(const PacketView& view, int x, int y) {
    return view.rgba + static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) + static_cast<std::size_t>(x);
}

/// What the rays of a tile have in common where they are: the numbers of any one of them.
struct alignas(16) Bundle {
    int x, y;  ///< of the tile's first pixel
    std::uint32_t cell;
    std::uint32_t floor_cell;  ///< whose floor has mirrored them, or no_cell
    std::uint32_t objects;     ///< of their cell, that they may meet (packets_objects.h)
    Vec3f tint;                ///< what is left of light on its way to the eye
    Vec3f floor;               ///< light of the floor that has mirrored them, times its cosine

    [[nodiscard]] ENFILADE_HD bool is_mirrored() const { return floor_cell != no_cell; }
};

ENFILADE_HD Bundle bundle_at_eye(const PacketView& view, int x, int y) {
    return {x, y, view.start_cell, no_cell, ~0u, {1, 1, 1}, {0, 0, 0}};
}

/// The camera's ray through a pixel, as a bundle's rays are where it is.
ENFILADE_HD Ray<float> ray_of(const PacketView& view, const Bundle& bundle, int x, int y) {
    const Vec3f direction = view.camera.direction(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
    const Ray<float> ray = make_ray_unchecked(view.camera.origin, direction);
    return bundle.is_mirrored() ? mirrored(ray, view.scene.cells[bundle.floor_cell].z_floor) : ray;
}

/// Through a portal of glass.
template <class Events>
ENFILADE_HD void pass_glass(const PacketView& view, const WalkEnd<float>& end, Bundle& bundle, Events& events) {
    bundle.tint = bundle.tint * tint_of(view.scene, end.cell, end.exit, end.face);
    events.crossed_glass();
}

ENFILADE_HD bool meets_mirror(const PacketView& view, const WalkEnd<float>& end, bool is_mirrored) {
    return view.mirror_floor > 0 && end.exit == Exit::Floor && !is_mirrored &&
           is_mirror(view.scene.source_faces[end.target.bits], end.exit);
}

/// From the floor of the cell where the rays are.
ENFILADE_HD void reflect(const PacketView& view, const WalkEnd<float>& end, Bundle& bundle) {
    const Vec3f light = bundle.tint * colour_of(view.scene, view.scene.source_faces[end.target.bits]);
    bundle.floor = (1 - view.mirror_floor) * light;
    bundle.tint = view.mirror_floor * bundle.tint;
    bundle.floor_cell = end.cell;
}

}  // namespace enfilade::render::cuda
