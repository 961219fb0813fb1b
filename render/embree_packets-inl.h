// Packets of rays for Embree. Compiled once for every instruction set of Highway's.
// No pragma once: the include guard is turned over for each of them.

#if defined(ENFILADE_RENDER_EMBREE_PACKETS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ENFILADE_RENDER_EMBREE_PACKETS_INL_H
#undef ENFILADE_RENDER_EMBREE_PACKETS_INL_H
#else
#define ENFILADE_RENDER_EMBREE_PACKETS_INL_H
#endif

#include <hwy/highway.h>

#include <limits>

#include "render/embree_loops.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One ray a call, for blocks of sixteen: they are made and shaded in lanes all the same.
struct Single {
    static constexpr int lanes = 16;
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;

    static void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RayHit* block) {
        for (int k = 0; k < lanes; ++k) {
            if (valid[k] == 0) continue;
            RTCRayHit query;
            query.ray = ray_of(block->ray, k);
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene, context, &query);
            block->ray.tfar[k] = query.ray.tfar;
            block->hit.Ng_x[k] = query.hit.Ng_x;
            block->hit.Ng_y[k] = query.hit.Ng_y;
            block->hit.Ng_z[k] = query.hit.Ng_z;
            block->hit.primID[k] = query.hit.primID;
            block->hit.geomID[k] = query.hit.geomID;
            block->hit.instID[0][k] = query.hit.instID[0];
        }
    }
    static void occluded(const int* valid, RTCScene scene, RTCIntersectContext* context, Ray* block) {
        for (int k = 0; k < lanes; ++k) {
            if (valid[k] == 0) continue;
            RTCRay ray = ray_of(*block, k);
            rtcOccluded1(scene, context, &ray);
            block->tfar[k] = ray.tfar;
        }
    }
    static RTCRay ray_of(const Ray& block, int k) {
        return {block.org_x[k],
                block.org_y[k],
                block.org_z[k],
                block.tnear[k],
                block.dir_x[k],
                block.dir_y[k],
                block.dir_z[k],
                0,
                block.tfar[k],
                ~0u,
                0,
                0};
    }
};

struct Eight {
    static constexpr int lanes = 8;
    using Ray = RTCRay8;
    using RayHit = RTCRayHit8;
    static constexpr auto intersect = rtcIntersect8;
    static constexpr auto occluded = rtcOccluded8;
};

struct Sixteen {
    static constexpr int lanes = 16;
    using Ray = RTCRay16;
    using RayHit = RTCRayHit16;
    static constexpr auto intersect = rtcIntersect16;
    static constexpr auto occluded = rtcOccluded16;
};

template <int N>
using Floats = hn::CappedTag<float, N>;

constexpr float infinity = std::numeric_limits<float>::infinity();

HWY_INLINE RTCIntersectContext context_of(const EmbreeScene& embree) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = embree.coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

/// What no ray changes.
template <int N, class Ray>
HWY_INLINE void fill_constants(Ray& ray, const Vec3f* origin) {
    const Floats<N> d;
    for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
        if (origin != nullptr) {
            hn::Store(hn::Set(d, origin->x), d, ray.org_x + k);
            hn::Store(hn::Set(d, origin->y), d, ray.org_y + k);
            hn::Store(hn::Set(d, origin->z), d, ray.org_z + k);
        }
        hn::Store(hn::Zero(d), d, ray.tnear + k);
        hn::Store(hn::Zero(d), d, ray.time + k);
        const hn::RebindToUnsigned<Floats<N>> du;
        hn::Store(hn::Set(du, ~0u), du, ray.mask + k);
        hn::Store(hn::Zero(du), du, ray.id + k);
        hn::Store(hn::Zero(du), du, ray.flags + k);
    }
}

/// What a packet of 4 x 4 or 4 x 2 pixels adds to the place of its first one.
alignas(64) constexpr float packet_columns[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) constexpr float packet_rows[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// Aims a packet from the camera at the pixels from (x, y) on.
template <int N, class RayHit>
HWY_INLINE void aim_packet(const CameraFrame& camera, int x, int y, RayHit& query) {
    const Floats<N> d;
    const hn::RebindToUnsigned<Floats<N>> du;
    const auto along = [&](auto px, auto py, float corner, float right, float down) HWY_ATTR {
        return hn::Add(hn::Add(hn::Set(d, corner), hn::Mul(px, hn::Set(d, right))), hn::Mul(py, hn::Set(d, down)));
    };
    for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
        const auto px = hn::Add(hn::Set(d, static_cast<float>(x) + 0.5f), hn::Load(d, packet_columns + k));
        const auto py = hn::Add(hn::Set(d, static_cast<float>(y) + 0.5f), hn::Load(d, packet_rows + k));
        hn::Store(along(px, py, camera.corner.x, camera.du.x, camera.dv.x), d, query.ray.dir_x + k);
        hn::Store(along(px, py, camera.corner.y, camera.du.y, camera.dv.y), d, query.ray.dir_y + k);
        hn::Store(along(px, py, camera.corner.z, camera.du.z, camera.dv.z), d, query.ray.dir_z + k);
        hn::Store(hn::Set(d, infinity), d, query.ray.tfar + k);
        hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.geomID + k);
        hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.instID[0] + k);
    }
}

/// The loop for so many rays a call.
template <class Job>
using Loop = void (*)(const Job&);

template <class Job>
void run(const Job& job, int lanes, Loop<Job> single, Loop<Job> eight, Loop<Job> sixteen) {
    (lanes == 1 ? single : lanes == 8 ? eight : sixteen)(job);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render::detail
HWY_AFTER_NAMESPACE();
#endif  // per target
