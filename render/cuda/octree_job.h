#pragma once
// What a kernel asks of an octree and what it keeps of the answers: rays from memory or of a camera's pixels; the
// nearest triangles, their normals, or a picture. Which of them is the same for all threads. Header-only, for host and
// device.

#include <cstdint>

#include "render/camera.h"
#include "render/cuda/octree_travel.h"
#include "render/framebuffer.h"
#include "render/path_sampler.h"

namespace enfilade::render::cuda {

struct OctreeAnswer {
    float t;                 ///< as the ray's direction counts; of a ray that meets nothing its `far`
    std::uint32_t triangle;  ///< of the mesh, or no_triangle
    friend bool operator==(const OctreeAnswer&, const OctreeAnswer&) = default;
};

/// A picture's pixels in the order of threads: eight by four pixels a warp, so that its rays are neighbours in both
/// directions. Numbers beyond the picture's edges have no pixel.
struct TiledPixels {
    int width, height;

    struct Pixel {
        int x, y;
    };
    [[nodiscard]] ENFILADE_HD std::uint64_t tiles_across() const { return (static_cast<std::uint64_t>(width) + 7) / 8; }
    [[nodiscard]] ENFILADE_HD std::uint64_t count() const {
        return tiles_across() * ((static_cast<std::uint64_t>(height) + 3) / 4) * 32;
    }
    [[nodiscard]] ENFILADE_HD Pixel pixel(std::uint64_t i) const {
        const auto tile = static_cast<std::uint32_t>(i / 32), lane = static_cast<std::uint32_t>(i % 32);
        const auto across = static_cast<std::uint32_t>(tiles_across());
        return {static_cast<int>(tile % across * 8 + lane % 8), static_cast<int>(tile / across * 4 + lane / 8)};
    }
    [[nodiscard]] ENFILADE_HD bool has(Pixel at) const { return at.x < width && at.y < height; }
};

/// A ray that asks for nothing.
[[nodiscard]] ENFILADE_HD OctreeRay no_ray() { return {{0, 0, 0}, 1, {0, 0, 1}, 0}; }

[[nodiscard]] ENFILADE_HD OctreeRay primary_ray(const CameraFrame& camera, TiledPixels::Pixel at) {
    const Vec3f d = camera.direction(static_cast<float>(at.x) + 0.5f, static_cast<float>(at.y) + 0.5f);
    return {{camera.origin.x, camera.origin.y, camera.origin.z}, 0, {d.x, d.y, d.z}, 0x1p120f};
}

/// A direction of length 1 about `normal` (of length 1), likelier the steeper it is (by its cosine): the normal and a
/// place on the unit sphere, drawn by rejection from hashes, so that every machine computes the same numbers.
[[nodiscard]] ENFILADE_HD Vec3f diffuse_direction(Vec3f normal, std::uint32_t key) {
    Vec3f place = {0, 0, 0};
    float square = 0;
    for (std::uint32_t i = 0; i < 32 && !(square > 0x1p-20f && square <= 1); ++i) {
        const std::uint32_t a = mixed(key + i * 0x9e3779b9u), b = mixed(a ^ 0x5bd1e995u), c = mixed(b ^ 0xc2b2ae35u);
        place = {static_cast<float>(a >> 8) * 0x1p-23f - 1, static_cast<float>(b >> 8) * 0x1p-23f - 1,
                 static_cast<float>(c >> 8) * 0x1p-23f - 1};
        square = dot(place, place);
    }
    const Vec3f d = normal + (1 / root(square)) * place;
    const float length = dot(d, d);
    return length > 0x1p-20f ? (1 / root(length)) * d : normal;
}

/// The ray that a matt surface sends on from where `ray` met it, on the side that it came from. size: of the mesh; key:
/// draws the direction
[[nodiscard]] ENFILADE_HD OctreeRay diffuse_ray(const OctreeRay& ray, float t, Vec3f normal, float size,
                                                std::uint32_t key) {
    const Vec3f along = {ray.direction[0], ray.direction[1], ray.direction[2]};
    const float length = root(dot(normal, normal));
    if (!(length > 0)) return no_ray();
    const float turn = (dot(normal, along) > 0 ? -1 : 1) / length;
    const Vec3f d = diffuse_direction(turn * normal, key);
    return {{ray.origin[0] + t * along.x, ray.origin[1] + t * along.y, ray.origin[2] + t * along.z},
            0x1p-14f * size,
            {d.x, d.y, d.z},
            0x1p120f};
}

/// What a lamp at the eye shows of a matt white surface.
[[nodiscard]] ENFILADE_HD std::uint32_t flat_shade(const OctreeRay& ray, Vec3f normal) {
    const Vec3f along = {ray.direction[0], ray.direction[1], ray.direction[2]};
    const float both = dot(normal, normal) * dot(along, along);
    const float cosine = both > 0 ? magnitude(dot(normal, along)) / root(both) : 0;
    return encoded({cosine, cosine, cosine});
}

/// The same number, as one that a compiler knows nothing of: what is computed from it is computed anew.
[[nodiscard]] ENFILADE_HD std::uint64_t made_new(std::uint64_t i) {
#if defined(__CUDA_ARCH__)
    asm volatile("" : "+l"(i));
#endif
    return i;
}

/// Rays in, answers out. Pointers are nullptr where that is not asked for.
struct OctreeJob {
    const OctreeRay* rays;  ///< nullptr: those of the camera's pixels, tile by tile
    CameraFrame camera;
    TiledPixels pixels;
    OctreeAnswer* answers;
    Quad* normals;        ///< of any length; not written for rays that meet nothing
    std::uint32_t* rgba;  ///< [pixel]
    std::uint32_t background;

    [[nodiscard]] ENFILADE_HD OctreeRay ray(std::uint64_t i) const {
        if (rays != nullptr) return rays[i];
        const TiledPixels::Pixel at = pixels.pixel(i);
        return pixels.has(at) ? primary_ray(camera, at) : no_ray();
    }

    /// The ray is made again, so that no thread keeps it.
    template <class Tree, class Place>
    ENFILADE_HD void put(std::uint64_t i, const Tree& tree, const OctreeFound<Place>& found) const {
        i = made_new(i);
        const OctreeRay ray = this->ray(i);
        const bool is_hit = found.triangle != no_triangle;
        if (answers != nullptr) answers[i] = {is_hit ? found.t + moved_by(tree, ray) : ray.far, found.triangle};
        if (normals == nullptr && rgba == nullptr) return;
        Vec3f normal = {0, 0, 0};
        if (is_hit) normal = normal_of(tree, found.place);
        if (normals != nullptr && is_hit) normals[i] = {normal.x, normal.y, normal.z, 0};
        if (rgba == nullptr) return;
        const TiledPixels::Pixel at = pixels.pixel(i);
        if (!pixels.has(at)) return;
        rgba[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(pixels.width) + static_cast<std::size_t>(at.x)] =
            is_hit ? flat_shade(ray, normal) : background;
    }
};

}  // namespace enfilade::render::cuda
