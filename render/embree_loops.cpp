// Rays for Embree, made and shaded in lanes. Compiled once for every instruction set of Highway's.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/embree_loops.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include <limits>

#include "render/embree_loops.h"
#include "render/embree_shade-inl.h"
#include "render/object_tracer.h"
#include "render/walk_events.h"

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

template <class Packet>
HWY_NOINLINE void trace_tile(const EmbreeTile& job) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    const hn::RebindToUnsigned<Floats<N>> du;
    using D = Floats<N>;
    alignas(64) static constexpr float columns[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
    alignas(64) static constexpr float rows[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    RTCIntersectContext context = context_of(job.embree);
    alignas(64) int valid[N];
    for (int& lane : valid) lane = -1;
    alignas(64) typename Packet::RayHit query;
    fill_constants<N>(query.ray, &job.camera->origin);
    const CameraFrame camera = *job.camera;
    const auto along = [&](auto x, auto y, float corner, float right, float down) HWY_ATTR {
        return hn::Add(hn::Add(hn::Set(d, corner), hn::Mul(x, hn::Set(d, right))), hn::Mul(y, hn::Set(d, down)));
    };
    for (int y = job.y0; y < job.y1; y += N / 4) {
        for (int x = job.x0; x < job.x1; x += 4) {
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const auto px = hn::Add(hn::Set(d, static_cast<float>(x) + 0.5f), hn::Load(d, columns + k));
                const auto py = hn::Add(hn::Set(d, static_cast<float>(y) + 0.5f), hn::Load(d, rows + k));
                hn::Store(along(px, py, camera.corner.x, camera.du.x, camera.dv.x), d, query.ray.dir_x + k);
                hn::Store(along(px, py, camera.corner.y, camera.du.y, camera.dv.y), d, query.ray.dir_y + k);
                hn::Store(along(px, py, camera.corner.z, camera.du.z, camera.dv.z), d, query.ray.dir_z + k);
                hn::Store(hn::Set(d, infinity), d, query.ray.tfar + k);
                hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.geomID + k);
                hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.instID[0] + k);
            }
            Packet::intersect(valid, job.embree.scene, &context, &query);
            alignas(64) std::uint32_t pixels[N];
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const Vec3<D> direction = {hn::Load(d, query.ray.dir_x + k), hn::Load(d, query.ray.dir_y + k),
                                           hn::Load(d, query.ray.dir_z + k)};
                hn::Store(shaded(d, job, direction, query.hit, k), du, pixels + k);
            }
            std::uint32_t* to = job.rgba + static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x;
            for (int row = 0; row < N / 4; ++row, to += job.width) __builtin_memcpy(to, pixels + 4 * row, 16);
        }
    }
}

/// Lanes of columns from i on; beyond the end the last ones, which the caller masks.
template <class D>
HWY_INLINE hn::Vec<D> lanes_of(D d, const float* column, std::uint64_t i, std::uint64_t end) {
    const std::uint64_t lanes = hn::Lanes(d);
    if (HWY_LIKELY(i + lanes <= end)) return hn::LoadU(d, column + i);
    alignas(64) float copy[16];
    for (std::uint64_t k = 0; k < lanes; ++k) copy[k] = column[i + k < end ? i + k : end - 1];
    return hn::Load(d, copy);
}

/// Writes what became of ray i, lane k of a packet.
template <class Query>
HWY_INLINE void answer(const EmbreeRays& job, std::uint64_t i, int k, const Query& query, float metres) {
    const EmbreeScene& embree = job.embree;
    const bool is_hit = query.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    const std::uint32_t place = embree.flat ? query.hit.geomID[k] : query.hit.instID[0][k];
    const bool is_object = is_hit && embree.places != nullptr && place < embree.place_count;
    const bool is_limited = job.max_distance != nullptr && job.max_distance[i] < 1e30f;
    if (job.distance != nullptr) job.distance[i] = query.ray.tfar[k] * metres;
    if (job.source_face != nullptr)
        job.source_face[i] =
            is_hit && !is_object
                ? static_cast<accel::SourceFaceId>(embree.looks[query.hit.primID[k]].source_face & ~sky_bit)
                : none<accel::SourceFaceId>;
    if (job.status != nullptr)
        job.status[i] = is_object    ? WalkStatus::Object
                        : is_hit     ? WalkStatus::Hit
                        : is_limited ? WalkStatus::Reached
                                     : WalkStatus::Leak;
    if (job.object != nullptr) job.object[i] = is_object ? static_cast<accel::ObjectId>(place) : none<accel::ObjectId>;
    if (job.triangle != nullptr) job.triangle[i] = is_object ? query.hit.primID[k] : no_triangle;
}

template <class Packet>
HWY_NOINLINE void trace_rays(const EmbreeRays& job) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    const hn::RebindToUnsigned<Floats<N>> du;
    RTCIntersectContext context = context_of(job.embree);
    alignas(64) int valid[N];
    alignas(64) typename Packet::RayHit query;
    alignas(64) float metres[N];
    fill_constants<N>(query.ray, nullptr);
    for (std::uint64_t i = job.begin; i < job.end; i += N) {
        for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
            const auto column = [&](const float* from) HWY_ATTR { return lanes_of(d, from, i + k, job.end); };
            const Vec3<Floats<N>> along = {column(job.direction[0]), column(job.direction[1]),
                                           column(job.direction[2])};
            const auto square = dot<Floats<N>>(along, along);
            hn::Store(column(job.origin[0]), d, query.ray.org_x + k);
            hn::Store(column(job.origin[1]), d, query.ray.org_y + k);
            hn::Store(column(job.origin[2]), d, query.ray.org_z + k);
            hn::Store(along.x, d, query.ray.dir_x + k);
            hn::Store(along.y, d, query.ray.dir_y + k);
            hn::Store(along.z, d, query.ray.dir_z + k);
            const auto inverse = inverse_root(d, square);
            hn::Store(hn::Mul(square, inverse), d, metres + k);
            hn::Store(hn::Mul(hn::Set(d, job.skin), inverse), d, query.ray.tnear + k);
            hn::Store(job.max_distance == nullptr ? hn::Set(d, infinity) : hn::Mul(column(job.max_distance), inverse),
                      d, query.ray.tfar + k);
            hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.geomID + k);
            hn::Store(hn::Set(du, RTC_INVALID_GEOMETRY_ID), du, query.hit.instID[0] + k);
        }
        const auto count = static_cast<int>(job.end - i < N ? job.end - i : N);
        for (int k = 0; k < N; ++k) valid[k] = k < count ? -1 : 0;
        Packet::intersect(valid, job.embree.scene, &context, &query);
        for (int k = 0; k < count; ++k) answer(job, i + k, k, query, metres[k]);
    }
}

template <class Packet>
HWY_NOINLINE void trace_segments(const EmbreeSegments& job) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    RTCIntersectContext context = context_of(job.embree);
    alignas(64) int valid[N];
    alignas(64) typename Packet::Ray ray;
    fill_constants<N>(ray, nullptr);
    for (std::uint64_t i = job.begin; i < job.end; i += N) {
        for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
            const auto column = [&](const float* from) HWY_ATTR { return lanes_of(d, from, i + k, job.end); };
            const Vec3<Floats<N>> from = {column(job.from[0]), column(job.from[1]), column(job.from[2])};
            const Vec3<Floats<N>> along = {hn::Sub(column(job.to[0]), from.x), hn::Sub(column(job.to[1]), from.y),
                                           hn::Sub(column(job.to[2]), from.z)};
            const auto skin = hn::Mul(hn::Set(d, job.skin), inverse_root(d, dot<Floats<N>>(along, along)));
            hn::Store(from.x, d, ray.org_x + k);
            hn::Store(from.y, d, ray.org_y + k);
            hn::Store(from.z, d, ray.org_z + k);
            hn::Store(along.x, d, ray.dir_x + k);
            hn::Store(along.y, d, ray.dir_y + k);
            hn::Store(along.z, d, ray.dir_z + k);
            hn::Store(skin, d, ray.tnear + k);
            hn::Store(hn::Sub(hn::Set(d, 1.0f), skin), d, ray.tfar + k);
        }
        const auto count = static_cast<int>(job.end - i < N ? job.end - i : N);
        for (int k = 0; k < N; ++k) valid[k] = k < count ? -1 : 0;
        Packet::occluded(valid, job.embree.scene, &context, &ray);
        for (int k = 0; k < count; ++k) job.visible[i + k] = ray.tfar[k] >= 0 ? 1 : 0;
    }
}

template <class Job>
using Loop = void (*)(const Job&);

template <class Job>
void run(const Job& job, int lanes, Loop<Job> single, Loop<Job> eight, Loop<Job> sixteen) {
    (lanes == 1 ? single : lanes == 8 ? eight : sixteen)(job);
}

void tile(const EmbreeTile& job, int lanes) {
    run(job, lanes, trace_tile<Single>, trace_tile<Eight>, trace_tile<Sixteen>);
}
void rays(const EmbreeRays& job, int lanes) {
    run(job, lanes, trace_rays<Single>, trace_rays<Eight>, trace_rays<Sixteen>);
}
void segments(const EmbreeSegments& job, int lanes) {
    run(job, lanes, trace_segments<Single>, trace_segments<Eight>, trace_segments<Sixteen>);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade::render::detail {

HWY_EXPORT(tile);
HWY_EXPORT(rays);
HWY_EXPORT(segments);

void embree_tile(const EmbreeTile& job, int lanes) { HWY_DYNAMIC_DISPATCH(tile)(job, lanes); }
void embree_rays(const EmbreeRays& job, int lanes) { HWY_DYNAMIC_DISPATCH(rays)(job, lanes); }
void embree_segments(const EmbreeSegments& job, int lanes) { HWY_DYNAMIC_DISPATCH(segments)(job, lanes); }

}  // namespace enfilade::render::detail
#endif
