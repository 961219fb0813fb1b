#pragma once
// One of sixteen rays, taken out and put back: for those who answer rays one at a time.

#include "render/object_tracer.h"

namespace enfilade::render {

[[nodiscard]] inline ObjectRay ray_of(const ObjectRays& rays, int i) {
    return {rays.origin_x[i],
            rays.origin_y[i],
            rays.origin_z[i],
            rays.near[i],
            rays.direction_x[i],
            rays.direction_y[i],
            rays.direction_z[i],
            0,
            rays.far[i],
            ~0u,
            0,
            0,
            0,
            0,
            0,
            0,
            0,
            rays.triangle[i],
            0,
            0};
}

inline void write_hit(const ObjectRay& ray, int i, ObjectRays& rays) {
    rays.far[i] = ray.far;
    rays.normal_x[i] = ray.normal_x;
    rays.normal_y[i] = ray.normal_y;
    rays.normal_z[i] = ray.normal_z;
    rays.u[i] = ray.u;
    rays.v[i] = ray.v;
    rays.triangle[i] = ray.triangle;
}

/// For each of those whose `valid` is -1: nearest(ray), which returns whether it hit. valid: [16]
template <class Nearest>
void one_by_one(const std::int32_t* valid, ObjectRays& rays, const Nearest& nearest) {
    for (int i = 0; i < ObjectRays::count; ++i) {
        if (valid[i] == 0) continue;
        ObjectRay ray = ray_of(rays, i);
        if (nearest(ray)) write_hit(ray, i, rays);
    }
}

/// For each of those whose `valid` is -1: blocked(ray). Bit i is set where ray i is. valid: [16]
template <class Blocked>
[[nodiscard]] std::uint32_t blocked_one_by_one(const std::int32_t* valid, const ObjectRays& rays,
                                               const Blocked& blocked) {
    std::uint32_t bits = 0;
    for (int i = 0; i < ObjectRays::count; ++i) {
        if (valid[i] == 0) continue;
        ObjectRay ray = ray_of(rays, i);
        ray.triangle = no_triangle;
        bits |= (blocked(ray) ? 1u : 0u) << i;
    }
    return bits;
}

}  // namespace enfilade::render
