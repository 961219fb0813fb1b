#pragma once
// What of a cell's objects the rays of a tile may meet: a tile that sees none goes on as in a bare room.

#include <cstdint>

#include "render/cuda/packets_view.h"
#include "render/object_walk.h"

namespace enfilade::render::cuda {

/// One of the four planes through the eye that hold a tile's rays between them; the normal points to the rays.
struct TilePlane {
    Vec3f normal;

    /// Between corners k and the next one around the tile, along the borders of its pixels, so that no ray is nearer to
    /// it than half a pixel. corner: to the right (bit 0), below (bit 1)
    ENFILADE_HD static TilePlane of(const PacketView& view, const Bundle& tile, int right, int below, int corner) {
        const auto towards = [&](int c) {
            return view.camera.direction(static_cast<float>((c & 1) != 0 ? right : tile.x),
                                         static_cast<float>((c & 2) != 0 ? below : tile.y));
        };
        const Vec3f here = towards(corner);
        Vec3f normal = cross(here, towards(corner ^ ((corner == 0 || corner == 3) ? 1 : 2)));
        if (dot(normal, towards(corner ^ 3)) < 0) normal = -normal;
        if (tile.is_mirrored()) normal.z = -normal.z;
        return {normal};
    }

    /// Whether all of an object's box lies beyond the plane, beyond doubt of rounding. The box is its mesh's, turned as
    /// it stands: what stands askew fills half of its box along the scene's axes.
    [[nodiscard]] ENFILADE_HD bool hides(const accel::SceneView& scene, const accel::PlacedObject& object,
                                         Vec3f eye) const {
        constexpr float noise = 0x1p-19f;
        const accel::ObjectMesh& mesh = scene.meshes[static_cast<std::uint32_t>(object.mesh)];
        const auto* low = reinterpret_cast<const float*>(&mesh.low);
        const auto* high = reinterpret_cast<const float*>(&mesh.high);
        const auto* m = reinterpret_cast<const float*>(&object.scene_from_object);
        const Vec3f place = {m[3], m[7], m[11]};
        float most = dot(normal, place - eye);  // of the box's corners, towards the rays
        float size = magnitude(normal.x) * (magnitude(place.x) + magnitude(eye.x)) +
                     magnitude(normal.y) * (magnitude(place.y) + magnitude(eye.y)) +
                     magnitude(normal.z) * (magnitude(place.z) + magnitude(eye.z));
        for (int k = 0; k < 3; ++k) {
            const float along = dot(normal, Vec3f{m[k], m[4 + k], m[8 + k]});
            most += along * (along > 0 ? high[k] : low[k]);
            size += magnitude(along) * larger(magnitude(low[k]), magnitude(high[k]));
        }
        return most + noise * size < 0;
    }
};

/// Objects of a cell one by one, by bits: those of the first 32.
inline constexpr std::uint32_t most_in_bits = 32;
inline constexpr std::uint32_t all_in_view = ~0u;

ENFILADE_HD std::uint32_t object_count(const accel::SceneView& scene, std::uint32_t cell) {
    return scene.cell_object_offsets[cell + 1] - scene.cell_object_offsets[cell];
}

/// Bit i: object first + i of the cell lies beyond the plane, or there is none.
ENFILADE_HD std::uint32_t hidden_by(const accel::SceneView& scene, const TilePlane& plane, Vec3f eye,
                                    std::uint32_t cell, std::uint32_t first) {
    const std::uint32_t count = object_count(scene, cell);
    const accel::ObjectId* list = scene.cell_objects.first + scene.cell_object_offsets[cell] + first;
    std::uint32_t hidden = ~0u;
    for (std::uint32_t i = 0; i < most_in_bits && first + i < count; ++i)
        if (!plane.hides(scene, scene.objects[static_cast<std::uint32_t>(list[i])], eye)) hidden &= ~(1u << i);
    return hidden;
}

/// As meets_objects (object_walk.h) for the nearest triangle, of the objects in view: the bits of the first 32, or
/// all_in_view.
template <class Inside>
ENFILADE_HD bool meets_in_view(const accel::SceneView& scene, const Inside& inside, const Ray<float>& ray,
                               std::uint32_t cell, std::uint32_t in_view, float near, float far,
                               ObjectHit<float>& hit) {
    const SlabRay slabs = scene_slabs(ray);
    const std::uint32_t count = object_count(scene, cell);
    const accel::ObjectId* list = scene.cell_objects.first + scene.cell_object_offsets[cell];
    bool is_hit = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (in_view != all_in_view && (in_view >> i & 1u) == 0) continue;
        const auto id = static_cast<std::uint32_t>(list[i]);
        const accel::PlacedObject& object = scene.objects[id];
        ObjectRay asked;
        if (!comes_near(scene, object, ray, slabs, near, far, asked)) continue;
        ask_nearest(inside, object.mesh, asked);
        if (asked.triangle == no_triangle || (is_hit && !(asked.far < far))) continue;
        is_hit = true;
        far = asked.far;
        hit = {id, asked.triangle, asked.far, scene_normal(object, asked)};
    }
    return is_hit;
}

}  // namespace enfilade::render::cuda
