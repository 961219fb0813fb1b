#pragma once
// How a ray meets the triangles of one mesh: a binary tree of boxes laid out as Aila and Laine's (2009), both boxes of
// a pair in their parent, and the triangle test of Woop, Benthin and Wald (2013), which lets nothing through between
// triangles that share an edge. Header-only, for host and device.

#include <cstdint>

#include "accel/scene.h"
#include "render/isa.h"
#include "render/math.h"
#include "render/object_tracer.h"
#include "render/vec.h"

namespace enfilade::render {

/// Both children of an inner node.
struct alignas(64) BvhNode {
    float low[3][2];         ///< [axis][child]
    float high[3][2];        ///< [axis][child]
    std::uint32_t child[2];  ///< a node, or with `leaf_bit` where the leaf's triangles begin in `order`
    std::uint32_t reserved[2];
};
static_assert(sizeof(BvhNode) == 64);

inline constexpr std::uint32_t leaf_bit = 0x80000000u;
inline constexpr std::uint32_t last_bit = 0x80000000u;  ///< of the last triangle of a leaf, in `order`

/// No path from the root is longer: builders keep to it, so the stack is bounded whatever the triangles are.
inline constexpr std::uint32_t largest_bvh_depth = 64;

/// A mesh and its tree. Plain pointers, safe to copy to a device.
struct BvhView {
    const BvhNode* nodes;                  ///< the root first; nullptr: nothing is ever hit
    const std::uint32_t* order;            ///< triangles, leaf by leaf
    const float* places;                   ///< x, y, z of the mesh's vertices
    const accel::MeshTriangle* triangles;  ///< of the mesh
    float low[3], high[3];                 ///< of the triangles in the tree
};

inline namespace ENFILADE_ISA {

/// What is computed once a ray: its shear (Woop et al., section 3), and slabs that are wider than those of the boxes by
/// more than the roundings of that triangle test, which are relative to the distance from the ray's origin.
struct BvhRay {
    int kx, ky, kz;  ///< kz: where the direction is longest
    float shear_x, shear_y, shear_z;
    float origin[3];
    float inverse[3];      ///< of the direction; of 2^-100 where it is less than that
    float origin_low[3];   ///< what low planes are measured from
    float origin_high[3];  ///< and high planes
};

ENFILADE_HD BvhRay bvh_ray(const BvhView& bvh, const ObjectRay& ray) {
    BvhRay r;
    r.origin[0] = ray.origin_x;
    r.origin[1] = ray.origin_y;
    r.origin[2] = ray.origin_z;
    const float d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    const float ax = magnitude(d[0]), ay = magnitude(d[1]), az = magnitude(d[2]);
    r.kz = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
    r.kx = r.kz == 2 ? 0 : r.kz + 1;
    r.ky = r.kx == 2 ? 0 : r.kx + 1;
    r.shear_z = 1.0f / d[r.kz];
    r.shear_x = d[r.kx] * r.shear_z;
    r.shear_y = d[r.ky] * r.shear_z;
    float farthest = 0;
    for (int k = 0; k < 3; ++k)
        farthest = larger(farthest, larger(magnitude(bvh.low[k] - r.origin[k]), magnitude(bvh.high[k] - r.origin[k])));
    const float slack = 0x1p-20f * farthest;
    for (int k = 0; k < 3; ++k) {
        r.inverse[k] = 1.0f / (magnitude(d[k]) >= 0x1p-100f ? d[k] : 0x1p-100f);
        r.origin_low[k] = r.origin[k] + slack;
        r.origin_high[k] = r.origin[k] - slack;
    }
    return r;
}

/// Whether the ray comes through a child's box between `near` and `far`, and where it enters. Products of zero and
/// infinity cannot arise.
ENFILADE_HD bool meets_box(const BvhNode& node, int child, const BvhRay& r, float near, float far, float& enter) {
    float leave = far;
    enter = near;
    for (int k = 0; k < 3; ++k) {
        const float a = (node.low[k][child] - r.origin_low[k]) * r.inverse[k];
        const float b = (node.high[k][child] - r.origin_high[k]) * r.inverse[k];
        const float first = a < b ? a : b, second = a < b ? b : a;
        enter = first > enter ? first : enter;
        leave = second < leave ? second : leave;
    }
    return enter <= leave;
}

/// Where the ray meets a triangle: the shares of its corners (not divided by their sum `sum`), and its parameter.
struct TriangleMeeting {
    float b, c, sum, t;
};

ENFILADE_HD const float* corner_place(const BvhView& bvh, std::uint32_t corner) {
    return bvh.places + std::size_t{3} * corner;
}

/// Both sides are seen. Neighbours compute the same numbers for the edge that they share, of opposite signs, so that
/// one of them is hit; what rounds to zero is computed again in double, where the products are exact.
ENFILADE_HD bool meets_triangle(const BvhView& bvh, const BvhRay& r, std::uint32_t triangle, TriangleMeeting& at) {
    const accel::MeshTriangle& corners = bvh.triangles[triangle];
    const float* pa = corner_place(bvh, corners.corners[0]);
    const float* pb = corner_place(bvh, corners.corners[1]);
    const float* pc = corner_place(bvh, corners.corners[2]);
    const float ox = r.origin[r.kx], oy = r.origin[r.ky], oz = r.origin[r.kz];
    const float a_along = pa[r.kz] - oz, b_along = pb[r.kz] - oz, c_along = pc[r.kz] - oz;
    const float ax = (pa[r.kx] - ox) - r.shear_x * a_along, ay = (pa[r.ky] - oy) - r.shear_y * a_along;
    const float bx = (pb[r.kx] - ox) - r.shear_x * b_along, by = (pb[r.ky] - oy) - r.shear_y * b_along;
    const float cx = (pc[r.kx] - ox) - r.shear_x * c_along, cy = (pc[r.ky] - oy) - r.shear_y * c_along;
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
ENFILADE_HD void describe_meeting(const BvhView& bvh, std::uint32_t triangle, const TriangleMeeting& at,
                                  ObjectRay& ray) {
    const accel::MeshTriangle& corners = bvh.triangles[triangle];
    const float* a = corner_place(bvh, corners.corners[0]);
    const float* b = corner_place(bvh, corners.corners[1]);
    const float* c = corner_place(bvh, corners.corners[2]);
    const Vec3f normal =
        cross(Vec3f{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, Vec3f{c[0] - a[0], c[1] - a[1], c[2] - a[2]});
    ray.normal_x = normal.x;
    ray.normal_y = normal.y;
    ray.normal_z = normal.z;
    ray.u = at.b / at.sum;
    ray.v = at.c / at.sum;
}

/// Finds the nearest triangle in [near, far] as ObjectTracer::nearest tells; of several at one distance the one that
/// comes first in the mesh. With `any` the first that is found will do.
template <bool any>
ENFILADE_HD bool bvh_walk(const BvhView& bvh, ObjectRay& ray) {
    if (bvh.nodes == nullptr || !(ray.near <= ray.far)) return false;
    const BvhRay r = bvh_ray(bvh, ray);
    TriangleMeeting best = {};
    bool is_found = false;
    std::uint32_t waiting[largest_bvh_depth];
    float waiting_enter[largest_bvh_depth];
    int waiting_count = 0;
    std::uint32_t at = 0;
    while (true) {
        if ((at & leaf_bit) == 0) {
            const BvhNode& node = bvh.nodes[at];
            float enter0, enter1;
            const bool meets0 = meets_box(node, 0, r, ray.near, ray.far, enter0);
            const bool meets1 = meets_box(node, 1, r, ray.near, ray.far, enter1);
            if (meets0 && meets1) {
                const bool second_first = enter1 < enter0;
                waiting[waiting_count] = node.child[second_first ? 0 : 1];
                waiting_enter[waiting_count++] = second_first ? enter0 : enter1;
                at = node.child[second_first ? 1 : 0];
                continue;
            }
            if (meets0 || meets1) {
                at = node.child[meets0 ? 0 : 1];
                continue;
            }
        } else {
            std::uint32_t entry;
            std::uint32_t k = at & ~leaf_bit;
            do {
                entry = bvh.order[k++];
                const std::uint32_t triangle = entry & ~last_bit;
                TriangleMeeting meeting;
                if (!meets_triangle(bvh, r, triangle, meeting) || !(meeting.t >= ray.near)) continue;
                if (!(meeting.t < ray.far || (meeting.t == ray.far && triangle < ray.triangle))) continue;
                if (any) return true;
                ray.far = meeting.t;
                ray.triangle = triangle;
                best = meeting;
                is_found = true;
            } while ((entry & last_bit) == 0);
        }
        do {
            if (waiting_count == 0) {
                if (is_found) describe_meeting(bvh, ray.triangle, best, ray);
                return is_found;
            }
            at = waiting[--waiting_count];
        } while (waiting_enter[waiting_count] > ray.far);
    }
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
