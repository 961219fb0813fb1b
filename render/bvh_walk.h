#pragma once
// How a ray meets the triangles of one mesh: a binary tree of boxes laid out as Aila and Laine's (2009), both boxes of
// a pair in their parent. Header-only, for host and device.

#include <cstdint>

#include "accel/scene.h"
#include "render/isa.h"
#include "render/math.h"
#include "render/object_tracer.h"
#include "render/triangle_test.h"

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

/// What is computed once a ray: slabs that are wider than those of the boxes by more than the roundings of the triangle
/// test, which are relative to the distance from the ray's origin.
struct BvhRay {
    ShearedRay sheared;
    float inverse[3];      ///< of the direction; of 2^-100 where it is less than that
    float origin_low[3];   ///< what low planes are measured from
    float origin_high[3];  ///< and high planes
};

ENFILADE_HD BvhRay bvh_ray(const BvhView& bvh, const ObjectRay& ray) {
    BvhRay r;
    r.sheared = sheared_ray(ray);
    const float* origin = r.sheared.origin;
    const float d[3] = {ray.direction_x, ray.direction_y, ray.direction_z};
    float farthest = 0;
    for (int k = 0; k < 3; ++k)
        farthest = larger(farthest, larger(magnitude(bvh.low[k] - origin[k]), magnitude(bvh.high[k] - origin[k])));
    const float slack = 0x1p-20f * farthest;
    for (int k = 0; k < 3; ++k) {
        r.inverse[k] = 1.0f / (magnitude(d[k]) >= 0x1p-100f ? d[k] : 0x1p-100f);
        r.origin_low[k] = origin[k] + slack;
        r.origin_high[k] = origin[k] - slack;
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

/// The triangle by its number in the mesh.
ENFILADE_HD TriangleAt triangle_at(const BvhView& bvh, std::uint32_t triangle) {
    const accel::MeshTriangle& corners = bvh.triangles[triangle];
    return {bvh.places + std::size_t{3} * corners.corners[0], bvh.places + std::size_t{3} * corners.corners[1],
            bvh.places + std::size_t{3} * corners.corners[2]};
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
                if (!meets_triangle(r.sheared, triangle_at(bvh, triangle), meeting) || !(meeting.t >= ray.near))
                    continue;
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
                if (is_found) describe_meeting(triangle_at(bvh, ray.triangle), best, ray);
                return is_found;
            }
            at = waiting[--waiting_count];
        } while (waiting_enter[waiting_count] > ray.far);
    }
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
