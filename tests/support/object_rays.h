#pragma once
// Single rays in a mesh's own space, and answers compared with brute force.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "render/object_tracer.h"
#include "tests/support/object_scenes.h"

namespace enfilade::test {

/// A ray that has hit nothing yet.
inline render::ObjectRay object_ray(render::Vec3d o, render::Vec3d d, float near, float far) {
    render::ObjectRay ray = {};
    ray.origin_x = static_cast<float>(o.x);
    ray.origin_y = static_cast<float>(o.y);
    ray.origin_z = static_cast<float>(o.z);
    ray.direction_x = static_cast<float>(d.x);
    ray.direction_y = static_cast<float>(d.y);
    ray.direction_z = static_cast<float>(d.z);
    ray.near = near;
    ray.far = far;
    ray.mask = ~0u;
    ray.triangle = ray.geometry = ray.instance = render::no_triangle;
    return ray;
}

/// Numbers in [-1, 1) that float32 holds.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : random_(seed) {}
    double next() { return static_cast<float>(random_() >> 40) * 0x1p-23f - 1; }
    render::Vec3d point(double size) {
        const double x = next(), y = next(), z = next();
        return {size * x, size * y, size * z};
    }

private:
    std::mt19937_64 random_;
};

enum class Verdict {
    Hit,     ///< both hit at the same distance
    Miss,    ///< both miss
    AtEdge,  ///< they differ, and the ray passes an edge of what it should have hit within rounding
    Wrong
};

/// asked: the ray before, answered: the same ray after.
inline Verdict judge(const accel::SceneView& scene, accel::MeshId mesh, const render::ObjectRay& asked,
                     const render::ObjectRay& answered, double edge = 1e-5) {
    const auto expected =
        brute_nearest(scene, mesh, {asked.origin_x, asked.origin_y, asked.origin_z},
                      {asked.direction_x, asked.direction_y, asked.direction_z}, asked.near, asked.far);
    const bool is_hit = answered.triangle != render::no_triangle;
    if (!expected && !is_hit) return Verdict::Miss;
    if (expected && is_hit && std::abs(expected->t - double{answered.far}) <= 2e-5 * std::max(1.0, expected->t))
        return Verdict::Hit;
    if (expected && (!is_hit || answered.far > expected->t))
        return expected->margin < edge ? Verdict::AtEdge : Verdict::Wrong;
    // Found something nearer than brute force did: at the rim of its triangle.
    const double rim = std::min({answered.u, answered.v, 1 - answered.u - answered.v});
    return std::abs(rim) < edge ? Verdict::AtEdge : Verdict::Wrong;
}

}  // namespace enfilade::test
