#pragma once
// Rays that start far from a mesh are brought near it before it is asked: what a walk rounds is then relative to the
// mesh's size, not to the distance. Header-only, for host and device.

#include "render/isa.h"
#include "render/math.h"
#include "render/object_tracer.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Farther than that many sizes of the box rays are brought near.
inline constexpr float near_enough = 4;

/// Moves the origin along the ray to where it passes nearest to the box's middle, computed in double; near and far
/// follow. Returns the parameter by which it moved (0: it was near): add it to what is found.
ENFILADE_HD float bring_near(const float* low, const float* high, ObjectRay& ray) {
    float size = 0, away = 0;
    const float o[3] = {ray.origin_x, ray.origin_y, ray.origin_z};
    for (int k = 0; k < 3; ++k) {
        size = larger(size, high[k] - low[k]);
        away = larger(away, larger(low[k] - o[k], o[k] - high[k]));
    }
    if (!(away > near_enough * size)) return 0;
    const double d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    double along = 0, square = 0;
    for (int k = 0; k < 3; ++k) {
        along += (0.5 * (double{low[k]} + double{high[k]}) - double{o[k]}) * d[k];
        square += d[k] * d[k];
    }
    const auto moved = static_cast<float>(along / square);
    ray.origin_x = static_cast<float>(double{o[0]} + double{moved} * d[0]);
    ray.origin_y = static_cast<float>(double{o[1]} + double{moved} * d[1]);
    ray.origin_z = static_cast<float>(double{o[2]} + double{moved} * d[2]);
    ray.near -= moved;
    ray.far -= moved;
    return moved;
}

/// Writes what `asked` met into the ray that it was before it was moved.
ENFILADE_HD void bring_back(const ObjectRay& asked, float moved, ObjectRay& ray) {
    ray.far = asked.far + moved;
    ray.triangle = asked.triangle;
    ray.normal_x = asked.normal_x;
    ray.normal_y = asked.normal_y;
    ray.normal_z = asked.normal_z;
    ray.u = asked.u;
    ray.v = asked.v;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
