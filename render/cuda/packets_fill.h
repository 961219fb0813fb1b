#pragma once
// Tiles that one face fills: Lambert's cosine is affine over the image, over the length of the direction. A pixel costs
// two approximate roots and some ten operations; four of a row are stored at once.

#include <cstdint>

#include "render/cuda/packets_view.h"
#include "render/cuda/quick_math.h"
#include "render/framebuffer.h"

namespace enfilade::render::cuda {

/// Adding it to a number of up to 255 rounds that to an integer and leaves it in the lowest byte.
inline constexpr float rounds_to_integer = 0x1p23f;
/// The same, and leaves 255 in the byte above it.
inline constexpr float rounds_below_alpha = 0x1p23f + 65280.0f;

/// A pixel from channels to which rounds_to_integer has been added, to blue rounds_below_alpha.
ENFILADE_HD std::uint32_t packed(float r, float g, float b) {
#if defined(__CUDA_ARCH__)
    return __byte_perm(__byte_perm(bits_of(r), bits_of(g), 0x0040), bits_of(b), 0x5410);
#else
    return (bits_of(r) & 0xffu) | (bits_of(g) & 0xffu) << 8 | bits_of(b) << 16;
#endif
}

/// From 0 to 1.
ENFILADE_HD float saturated(float a) {
#if defined(__CUDA_ARCH__)
    return __saturatef(a);
#else
    return a > 0 ? (a < 1 ? a : 1.0f) : 0.0f;
#endif
}

enum class PaintKind : std::uint32_t {
    Face,    ///< one face: its root is taken, colours are roots of 255 parts
    Layers,  ///< a mirror's floor, or none, and what it shows: a face
    Sky,     ///< the same, of the sky
    Lamps    ///< one face, lit by lamps (packets_lamps.h)
};

/// What fills a tile.
struct alignas(16) Paint {
    float at_corner, by_x, by_y;  ///< of the cosine, or the rise to the sky, over the image; times the length
    PaintKind kind;
    float r, g, b;
    std::uint32_t place;  ///< x, and y << 16
    float floor_r, floor_g, floor_b;
    std::uint32_t unused;
};

/// A channel of a pixel that faces the light, of 255.
ENFILADE_HD float full_channel(float colour) { return 255.0f * (colour < 1 ? root(colour) : 1.0f); }

/// What a bundle's rays see that end by the same face.
ENFILADE_HD Paint paint_of(const PacketView& view, const Bundle& bundle, const WalkEnd<float>& end) {
    const accel::SourceFace& face = view.scene.source_faces[end.target.bits];
    const bool is_sky = face.surface == accel::Surface::Sky;
    const float turn = bundle.is_mirrored() ? -1.0f : 1.0f;
    const Vec3f toward = is_sky ? Vec3f{0, 0, 1} : -normal_of(view.scene, end);
    const Vec3f n = {toward.x, toward.y, turn * toward.z};  // against the directions as the camera has them
    const Vec3f scale = is_sky ? bundle.tint : bundle.tint * colour_of(view.scene, face);
    const bool is_plain = !is_sky && !bundle.is_mirrored();
    Paint paint;
    paint.at_corner = dot(n, view.camera.corner);
    paint.by_x = dot(n, view.camera.du);
    paint.by_y = dot(n, view.camera.dv);
    paint.kind = is_plain ? PaintKind::Face : is_sky ? PaintKind::Sky : PaintKind::Layers;
    paint.r = is_plain ? full_channel(scale.x) : scale.x;
    paint.g = is_plain ? full_channel(scale.y) : scale.y;
    paint.b = is_plain ? full_channel(scale.z) : scale.z;
    paint.place = static_cast<std::uint32_t>(bundle.x) | static_cast<std::uint32_t>(bundle.y) << 16;
    paint.floor_r = bundle.floor.x;
    paint.floor_g = bundle.floor.y;
    paint.floor_b = bundle.floor.z;
    return paint;
}

/// d . d of a pixel's direction, and its cosine times the length, over the rows of one column.
struct Column {
    float squared, squared_by_y;  ///< d . d = squared + y (squared_by_y + y by_yy)
    float facing;                 ///< at y = 0

    ENFILADE_HD Column(const PacketView& view, const Paint& paint, float x)
        : squared(fused(x, fused(x, view.lengths.by_xx, view.lengths.by_x), view.lengths.of_corner)),
          squared_by_y(fused(x, view.lengths.by_xy, view.lengths.by_y)),
          facing(fused(x, paint.by_x, paint.at_corner)) {}
    [[nodiscard]] ENFILADE_HD float squared_at(const PacketView& view, float y) const {
        return fused(y, fused(y, view.lengths.by_yy, squared_by_y), squared);
    }
};

/// A pixel of one face.
ENFILADE_HD std::uint32_t face_pixel(const PacketView& view, const Paint& paint, const Column& column, float y) {
    const float facing = fused(y, paint.by_y, column.facing);
    const float bright = quick_root(saturated(facing * quick_inverse_root(column.squared_at(view, y))));
    return packed(fused(bright, paint.r, rounds_to_integer), fused(bright, paint.g, rounds_to_integer),
                  fused(bright, paint.b, rounds_below_alpha));
}

/// A pixel of a floor that mirrors, if any, and of what is seen in it.
ENFILADE_HD std::uint32_t layered_pixel(const PacketView& view, const Paint& paint, float x, float y) {
    const Column column(view, paint, x);
    const float inverse = 1.0f / root(column.squared_at(view, y));
    const float down = -fused(x, view.camera.du.z, fused(y, view.camera.dv.z, view.camera.corner.z)) * inverse;
    const float along = fused(y, paint.by_y, column.facing) * inverse;
    const float clipped = along > 0 ? along : 0.0f;
    const Vec3f scale = {paint.r, paint.g, paint.b};
    Vec3f seen = clipped * scale;
    if (paint.kind == PaintKind::Sky) {
        const float blend = root(clipped);
        seen = scale * ((1 - blend) * view.look.sky_horizon + blend * view.look.sky_zenith);
    }
    const Vec3f floor = {paint.floor_r, paint.floor_g, paint.floor_b};
    return encoded((down > 0 ? down : 0.0f) * floor + seen);
}

struct alignas(16) FourPixels {
    std::uint32_t of[4];
};

/// Four pixels of a row from x on, as far as they lie on the image.
ENFILADE_HD void store_four(const PacketView& view, int x, std::uint32_t* out, const FourPixels& pixels) {
    if (view.stores_quads) {
        *reinterpret_cast<FourPixels*>(out) = pixels;
        return;
    }
    for (int i = 0; i < 4; ++i)
        if (x + i < view.width) out[i] = pixels.of[i];
}

/// Columns x to x + 3 of a tile: every `step`-th row from y on, up to `end`.
ENFILADE_HD void fill_columns(const PacketView& view, const Paint& paint, int x, int y, int step, int end) {
    std::uint32_t* out = pixel_at(view, x, y);
    const std::size_t rows = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(step);
    const float first = static_cast<float>(x) + 0.5f;
    if (paint.kind == PaintKind::Face) {
        const Column columns[4] = {
            {view, paint, first}, {view, paint, first + 1}, {view, paint, first + 2}, {view, paint, first + 3}};
        float middle = static_cast<float>(y) + 0.5f;
        const auto down = static_cast<float>(step), last = static_cast<float>(end);
        for (; middle < last; middle += down, out += rows) {
            FourPixels pixels;
            for (int i = 0; i < 4; ++i) pixels.of[i] = face_pixel(view, paint, columns[i], middle);
            store_four(view, x, out, pixels);
        }
    } else {
        for (; y < end; y += step, out += rows) {
            FourPixels pixels;
            for (int i = 0; i < 4; ++i)
                pixels.of[i] = layered_pixel(view, paint, first + static_cast<float>(i), static_cast<float>(y) + 0.5f);
            store_four(view, x, out, pixels);
        }
    }
}

}  // namespace enfilade::render::cuda
