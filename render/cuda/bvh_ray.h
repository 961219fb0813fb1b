#pragma once
// Rays and triangles as walks through trees of boxes want them, for host and device.

#include <cstdint>

#include "render/cuda/bvh_lane.h"
#include "render/cuda/quick_math.h"
#include "render/cuda/triangle_record.h"
#include "render/object_walk.h"

namespace enfilade::render::cuda {

/// How triangles are tested. Fast: what experts use on cards. Watertight: triangle_test.h, with boxes widened by what
/// it rounds; of equally near triangles the first, so that answers do not depend on the tree.
enum class TriangleTest { Fast, Watertight };

/// What is asked. Finite numbers; parameters count in the direction.
struct BvhQuery {
    Vec3f origin, direction;
    float near, far;
    std::uint32_t skipped;  ///< an object that does not count, or no_object
};

inline constexpr std::uint32_t no_record = 0xffffffffu;

struct BvhHit {
    float t;
    std::uint32_t record;    ///< no_record: nothing was hit
    std::uint32_t instance;  ///< no_object: a face
};

/// Of triangles at one distance those of the object with the lowest number count, faces last; then the one with the
/// lowest number. record, instance: met now; hit: before
template <class Records>
ENFILADE_HD bool comes_first(const Records& records, const RecordAt& record, std::uint32_t instance,
                             const BvhHit& hit) {
    if (hit.record == no_record) return true;
    if (instance != hit.instance) return instance < hit.instance;
    return (record.item & item_mask) < (records[hit.record].item & item_mask);
}

/// Where things lie that a space's rays may meet: what Watertight widens boxes by depends on it.
struct BvhExtent {
    float low[3], high[3];
};

/// What of a walk is counted. NoBvhEvents costs nothing.
struct NoBvhEvents {
    ENFILADE_HD void visited_node() {}
    ENFILADE_HD void tested_triangle() {}
    ENFILADE_HD void entered_instance() {}
    ENFILADE_HD void stack_holds(int) {}
};

/// Directions are no nearer to an axis than this, so that no product is 0 times infinity.
inline constexpr float least_direction = 0x1p-60f;

ENFILADE_HD float slab_inverse(float d) {
    return quick_inverse(magnitude(d) >= least_direction ? d : (d < 0 ? -least_direction : least_direction));
}

/// A ray in the space of a tree.
template <TriangleTest test>
class SpaceRay;

template <>
class SpaceRay<TriangleTest::Fast> {
public:
    Vec3f origin, direction, inverse;

    ENFILADE_HD void aim(Vec3f o, Vec3f d, const BvhExtent*) {
        origin = o;
        direction = d;
        inverse = {slab_inverse(d.x), slab_inverse(d.y), slab_inverse(d.z)};
    }
    /// What planes are measured from: those of low corners, and of high ones.
    ENFILADE_HD Vec3f origin_low() const { return origin; }
    ENFILADE_HD Vec3f origin_high() const { return origin; }

    /// Möller and Trumbore's test (1997) in the order in which nothing is divided before a hit is certain.
    ENFILADE_HD bool meets(const RecordAt& r, float near, float far, float& t) const {
        const Vec3f normal = quick_cross(r.c, r.b);
        const Vec3f way = r.a - origin;
        const Vec3f turn = quick_cross(way, direction);
        const float along = quick_dot(normal, direction);
        const std::uint32_t sign = bits_of(along) & 0x80000000u;
        const auto signed_as = [&](float a) { return float_of(bits_of(a) ^ sign); };
        const float u = signed_as(quick_dot(turn, r.c)), v = signed_as(quick_dot(turn, r.b));
        const float steep = magnitude(along), at = signed_as(quick_dot(normal, way));
        if (!(u >= 0) || !(v >= 0) || !(u + v <= steep) || !(at >= near * steep) || !(at < far * steep)) return false;
        t = at * quick_inverse(steep);
        return t < far;
    }
    /// Whether a hit as near as the nearest one may count more.
    static ENFILADE_HD bool breaks_ties() { return false; }

private:
    static ENFILADE_HD float quick_dot(Vec3f a, Vec3f b) { return fused(a.x, b.x, fused(a.y, b.y, a.z * b.z)); }
    static ENFILADE_HD Vec3f quick_cross(Vec3f a, Vec3f b) {
        return {fused(a.y, b.z, -(a.z * b.y)), fused(a.z, b.x, -(a.x * b.z)), fused(a.x, b.y, -(a.y * b.x))};
    }
};

template <>
class SpaceRay<TriangleTest::Watertight> {
public:
    Vec3f origin, direction, inverse;

    ENFILADE_HD void aim(Vec3f o, Vec3f d, const BvhExtent* extent) {
        origin = o;
        direction = d;
        inverse = {slab_inverse(d.x), slab_inverse(d.y), slab_inverse(d.z)};
        ObjectRay ray = {};
        ray.origin_x = o.x;
        ray.origin_y = o.y;
        ray.origin_z = o.z;
        ray.direction_x = d.x;
        ray.direction_y = d.y;
        ray.direction_z = d.z;
        sheared_ = sheared_ray(ray);
        const float at[3] = {o.x, o.y, o.z};
        float farthest = 0;
        for (int k = 0; k < 3; ++k)
            farthest = most(farthest, most(magnitude(extent->low[k] - at[k]), magnitude(extent->high[k] - at[k])));
        slack_ = 0x1p-20f * farthest;
    }
    ENFILADE_HD Vec3f origin_low() const { return {origin.x + slack_, origin.y + slack_, origin.z + slack_}; }
    ENFILADE_HD Vec3f origin_high() const { return {origin.x - slack_, origin.y - slack_, origin.z - slack_}; }

    ENFILADE_HD bool meets(const RecordAt& r, float near, float far, float& t) const {
        const float a[3] = {r.a.x, r.a.y, r.a.z}, b[3] = {r.b.x, r.b.y, r.b.z}, c[3] = {r.c.x, r.c.y, r.c.z};
        TriangleMeeting at;
        if (!meets_triangle(sheared_, {a, b, c}, at) || !(at.t >= near) || !(at.t <= far)) return false;
        t = at.t;
        return true;
    }
    static ENFILADE_HD bool breaks_ties() { return true; }

private:
    ShearedRay sheared_;
    float slack_;
};

}  // namespace enfilade::render::cuda
