// Rays for Embree, made and shaded in lanes. Compiled once for every instruction set of Highway's.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/embree_loops.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "render/embree_loops.h"
#include "render/embree_packets-inl.h"
#include "render/embree_shade-inl.h"
#include "render/object_tracer.h"
#include "render/walk_events.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Packet>
HWY_NOINLINE void trace_tile(const EmbreeTile& job) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    const hn::RebindToUnsigned<Floats<N>> du;
    using D = Floats<N>;
    RTCIntersectContext context = context_of(job.embree);
    alignas(64) int valid[N];
    for (int& lane : valid) lane = -1;
    alignas(64) typename Packet::RayHit query;
    fill_constants<N>(query.ray, &job.camera->origin);
    const CameraFrame camera = *job.camera;
    for (int y = job.y0; y < job.y1; y += N / 4) {
        for (int x = job.x0; x < job.x1; x += 4) {
            aim_packet<N>(camera, x, y, query);
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
