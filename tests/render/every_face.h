#pragma once
// What a ray meets, by brute force over all source faces from both sides: nothing of cells, portals or boxes.

#include <algorithm>
#include <cmath>
#include <vector>

#include "accel/scene.h"
#include "render/vec.h"

namespace enfilade::test {

struct FaceMet {
    double distance;
    std::uint32_t face;
    bool ends_light;  ///< met from its light side; else light begins behind it
};

/// All of them beyond 0 and before `limit`, in order. Zero-thick pairs: light ends before it begins.
inline std::vector<FaceMet> faces_met(const accel::SceneView& scene, render::Vec3d origin, render::Vec3d direction,
                                      double limit) {
    using render::Vec3d;
    const Vec3d unit = render::normalized(direction);
    std::vector<FaceMet> met;
    for (std::uint32_t f = 0; f < scene.source_face_count(); ++f) {
        const std::uint32_t first = scene.source_faces[f].first_vertex;
        const std::uint32_t count = scene.source_faces[f + 1].first_vertex - first;
        const auto at = [&](std::uint32_t i) {
            const accel::Vertex& v = scene.vertices[first + i % count];
            return Vec3d{v.x, v.y, v.z};
        };
        Vec3d normal = {0, 0, 0};
        for (std::uint32_t i = 0; i < count; ++i) normal = normal + render::cross(at(i) - at(0), at(i + 1) - at(0));
        const double facing = render::dot(normal, unit);
        if (facing == 0) continue;
        const double t = render::dot(normal, at(0) - origin) / facing;
        if (!(t > 0) || !(t < limit)) continue;
        // Winding angle about the point where the line meets the plane.
        const Vec3d p = origin + t * unit;
        double angle = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec3d a = at(i) - p, b = at(i + 1) - p;
            angle += std::atan2(render::dot(normal, render::cross(a, b)) / render::length(normal), render::dot(a, b));
        }
        if (std::abs(angle) > 3) met.push_back({t, f, facing < 0});
    }
    std::sort(met.begin(), met.end(), [](const FaceMet& a, const FaceMet& b) {
        if (std::abs(a.distance - b.distance) > 1e-9) return a.distance < b.distance;
        return a.ends_light && !b.ends_light;
    });
    return met;
}

}  // namespace enfilade::test
