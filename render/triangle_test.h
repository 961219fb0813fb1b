#pragma once
// The triangle test of Woop, Benthin and Wald (Watertight Ray/Triangle Intersection, 2013), which lets nothing through
// between triangles that share an edge. Whatever finds the triangles, this says what of them a ray meets. Header-only,
// for host and device.

#include <cstdint>

#include "render/isa.h"
#include "render/math.h"
#include "render/object_tracer.h"
#include "render/vec.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// The ray's shear (section 3 there).
struct ShearedRay {
    int kx, ky, kz;  ///< kz: where the direction is longest
    float shear_x, shear_y, shear_z;
    float origin[3];
};

ENFILADE_HD ShearedRay sheared_ray(const ObjectRay& ray) {
    ShearedRay r;
    r.origin[0] = ray.origin_x;
    r.origin[1] = ray.origin_y;
    r.origin[2] = ray.origin_z;
    const float d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    const float ax = magnitude(d[0]), ay = magnitude(d[1]), az = magnitude(d[2]);
    r.kz = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
    r.kx = r.kz == 2 ? 0 : r.kz + 1;
    r.ky = r.kx == 2 ? 0 : r.kx + 1;
    r.shear_z = 1.0f / component(d, r.kz);
    r.shear_x = component(d, r.kx) * r.shear_z;
    r.shear_y = component(d, r.ky) * r.shear_z;
    return r;
}

/// x, y, z of three corners.
struct TriangleAt {
    const float *a, *b, *c;
};

/// Where the ray meets a triangle: the shares of its corners (not divided by their sum `sum`), and its parameter.
struct TriangleMeeting {
    float b, c, sum, t;
};

/// Both sides are seen. Neighbours compute the same numbers for the edge that they share, of opposite signs, so that
/// one of them is hit; what rounds to zero is computed again in double, where the products are exact.
ENFILADE_HD bool meets_triangle(const ShearedRay& r, const TriangleAt& p, TriangleMeeting& at) {
    const float ox = component(r.origin, r.kx), oy = component(r.origin, r.ky), oz = component(r.origin, r.kz);
    const float a_along = component(p.a, r.kz) - oz, b_along = component(p.b, r.kz) - oz,
                c_along = component(p.c, r.kz) - oz;
    const float ax = (component(p.a, r.kx) - ox) - r.shear_x * a_along,
                ay = (component(p.a, r.ky) - oy) - r.shear_y * a_along;
    const float bx = (component(p.b, r.kx) - ox) - r.shear_x * b_along,
                by = (component(p.b, r.ky) - oy) - r.shear_y * b_along;
    const float cx = (component(p.c, r.kx) - ox) - r.shear_x * c_along,
                cy = (component(p.c, r.ky) - oy) - r.shear_y * c_along;
    float u = cx * by - cy * bx, v = ax * cy - ay * cx, w = bx * ay - by * ax;
    if (u == 0.0f || v == 0.0f || w == 0.0f) {
        u = static_cast<float>(double{cx} * double{by} - double{cy} * double{bx});
        v = static_cast<float>(double{ax} * double{cy} - double{ay} * double{cx});
        w = static_cast<float>(double{bx} * double{ay} - double{by} * double{ax});
    }
    if ((u < 0.0f || v < 0.0f || w < 0.0f) && (u > 0.0f || v > 0.0f || w > 0.0f)) return false;
    const float sum = u + v + w;
    if (!(sum < 0.0f || sum > 0.0f)) return false;
    at = {v, w, sum, r.shear_z * (u * a_along + v * b_along + w * c_along) / sum};
    return true;
}

/// The shares and the normal of the triangle that was met.
ENFILADE_HD void describe_meeting(const TriangleAt& p, const TriangleMeeting& at, ObjectRay& ray) {
    const Vec3f normal = cross(Vec3f{p.b[0] - p.a[0], p.b[1] - p.a[1], p.b[2] - p.a[2]},
                               Vec3f{p.c[0] - p.a[0], p.c[1] - p.a[1], p.c[2] - p.a[2]});
    ray.normal_x = normal.x;
    ray.normal_y = normal.y;
    ray.normal_z = normal.z;
    ray.u = at.b / at.sum;
    ray.v = at.c / at.sum;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
