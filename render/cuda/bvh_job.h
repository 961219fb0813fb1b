#pragma once
// What kernels ask of trees of boxes and what they make of the answers: pictures, rays, segments, lamps. Header-only,
// for host and device.

#include <cstdint>

#include "accel/scene.h"
#include "render/camera.h"
#include "render/cuda/bvh_ray.h"
#include "render/cuda/octree_job.h"
#include "render/cuda/quick_math.h"
#include "render/cuda/streams.h"
#include "render/face_mesh.h"
#include "render/framebuffer.h"
#include "render/lamp_light.h"
#include "render/look.h"
#include "render/ray.h"
#include "render/shade.h"

namespace enfilade::render::cuda {

/// What a pixel sees, for lamps: 48 bytes.
struct alignas(16) SeenPlace {
    float point[3];
    std::uint32_t is_lit;  ///< 0: sky, or nothing; the pixel is written already
    float normal[3];       ///< of length 1, towards the eye
    float reserved;
    float colour[3];  ///< square roots of the diffuse reflectance
    float reserved_too;
};
static_assert(sizeof(SeenPlace) == 48);

/// The lamps that each cell's places ask for (render/embree_lamps.h, LampLists), in the device's memory.
struct BvhLamps {
    const accel::Light* lights;
    const std::uint32_t* offsets;  ///< [cell_count + 1] into `lamps`
    const std::uint32_t* lamps;
    const std::uint32_t* cells;  ///< [width * height]: of what each pixel sees
    float exposure;
    bool from_lamps;  ///< shadow rays start at lamps, which makes neighbours' alike, instead of at places
};

enum class BvhAsk : std::uint32_t { Pixels, Places, Columns, OfMesh };

/// Pointers that are not asked for are nullptr.
struct BvhJob {
    BvhAsk ask;
    std::uint64_t count;  ///< of threads' items: pixels tile by tile, rays, segments
    TriangleTest test;
    float skin;  ///< metres: hits nearer to an origin, or to the end of a segment, do not count
    const detail::PrimitiveLook* looks;

    CameraFrame camera;
    Look look;
    int width, height;
    std::uint32_t* rgba;
    SeenPlace* places;  ///< [count]
    BvhLamps lamps;
    DeviceRays rays;
    DeviceHits hits;
    DeviceSegments segments;
    std::uint8_t* visible;
    const OctreeRay* mesh_rays;
    OctreeAnswer* answers;
};

/// Pixels in the order of threads: eight by four a warp. -1: beyond the picture's edge.
ENFILADE_HD std::int64_t pixel_of(const BvhJob& job, std::uint64_t i) {
    const auto tile = static_cast<std::uint32_t>(i / 32), lane = static_cast<std::uint32_t>(i % 32);
    const std::uint32_t across = (static_cast<std::uint32_t>(job.width) + 7) / 8;
    const auto x = static_cast<int>(tile % across * 8 + lane % 8), y = static_cast<int>(tile / across * 4 + lane / 8);
    return x < job.width && y < job.height ? std::int64_t{y} * job.width + x : -1;
}
/// Threads for all of them.
ENFILADE_HD std::uint64_t pixel_threads(int width, int height) {
    return (static_cast<std::uint64_t>(width) + 7) / 8 * ((static_cast<std::uint64_t>(height) + 3) / 4) * 32;
}

ENFILADE_HD Vec3f pixel_direction(const BvhJob& job, std::int64_t pixel) {
    const auto at = static_cast<std::uint32_t>(pixel), width = static_cast<std::uint32_t>(job.width);
    return job.camera.direction(static_cast<float>(at % width) + 0.5f, static_cast<float>(at / width) + 0.5f);
}

/// What was hit, as it looks.
struct BvhShown {
    Vec3f normal;  ///< of any length, on either side
    detail::PrimitiveLook look;
};

template <class View>
ENFILADE_HD BvhShown shown(const BvhJob& job, const View& bvh, const BvhHit& hit) {
    const RecordAt r = load_record(bvh.records, hit.record);
    std::uint32_t look = r.item & item_mask;
    Vec3f normal = job.test == TriangleTest::Fast ? cross(r.c, r.b) : cross(r.b - r.a, r.c - r.a);
    if (hit.instance != no_object) {
        const InstanceAt instance = load_instance(bvh.instances, hit.instance);
        normal = instance.turned_normal(normal);
        if (instance.look != no_look) look = instance.look;
    }
    const Float4 at = load_float4(job.looks + look);
    return {normal, {at.x, at.y, at.z, bits_of(at.w)}};
}

ENFILADE_HD bool is_sky(const detail::PrimitiveLook& look) { return (look.source_face & detail::sky_bit) != 0; }

/// A pixel from the square roots of its light.
ENFILADE_HD std::uint32_t encoded_roots(Vec3f roots) {
    const auto channel = [](float a) { return static_cast<std::uint32_t>(fused(255.0f, least(a, 1.0f), 0.5f)); };
    return channel(roots.x) | channel(roots.y) << 8 | channel(roots.z) << 16 | 0xff000000u;
}

inline constexpr std::uint32_t nothing_seen = 0xffff00ffu;

/// The nearest hits of pixels and rays. One query an item.
struct NearestFeeder {
    static constexpr bool any = false;
    bool is_asked;

    ENFILADE_HD void start(const BvhJob&, std::uint64_t) { is_asked = false; }

    ENFILADE_HD bool next(const BvhJob& job, std::uint64_t i, BvhQuery& query) {
        if (is_asked) return false;
        is_asked = true;
        return query_of(job, i, query);
    }

    template <class View>
    ENFILADE_HD void answer(const BvhJob& job, std::uint64_t i, const View& bvh, const BvhHit& hit) const {
        if (job.ask == BvhAsk::Columns) return answer_ray(job, i, bvh, hit);
        if (job.ask == BvhAsk::OfMesh) {
            const bool is_hit = hit.record != no_record;
            job.answers[i] = {hit.t, is_hit ? bvh.records[hit.record].item & item_mask : no_triangle};
            return;
        }
        answer_pixel(job, i, bvh, hit);
    }

private:
    /// False where there is no ray.
    static ENFILADE_HD bool query_of(const BvhJob& job, std::uint64_t i, BvhQuery& query) {
        if (job.ask == BvhAsk::Columns) {
            float metres, limit;
            return column_query(job, i, query, metres, limit);
        }
        if (job.ask == BvhAsk::OfMesh) {
            const Float4 a = load_float4(job.mesh_rays + i);
            const Float4 b = load_float4(reinterpret_cast<const unsigned char*>(job.mesh_rays + i) + 16);
            query = {{a.x, a.y, a.z}, {b.x, b.y, b.z}, a.w, b.w, no_object};
            return true;
        }
        const std::int64_t pixel = pixel_of(job, i);
        if (pixel < 0) {
            if (job.ask == BvhAsk::Places) job.places[i].is_lit = 0;
            return false;
        }
        query = {job.camera.origin, pixel_direction(job, pixel), 0, 3e38f, no_object};
        return true;
    }

    /// metres: of the direction; limit: metres
    static ENFILADE_HD bool column_query(const BvhJob& job, std::uint64_t i, BvhQuery& query, float& metres,
                                         float& limit) {
        const Vec3f o = {job.rays.origin[0][i], job.rays.origin[1][i], job.rays.origin[2][i]};
        const Vec3f d = {job.rays.direction[0][i], job.rays.direction[1][i], job.rays.direction[2][i]};
        limit = job.rays.max_distance != nullptr ? job.rays.max_distance[i] : 3e38f;
        metres = 1;
        if (!is_ray(o, d) || !(limit == limit)) {
            write(job, i, WalkStatus::Refused, float_of(0x7fc00000u), ~0u, no_object, no_triangle);
            return false;
        }
        const Vec3f scaled = scaled_direction(d);
        metres = quick_root(dot(scaled, scaled));
        const float inverse = quick_inverse(metres);
        query = {o, scaled, job.skin * inverse, limit < 1e30f ? limit * inverse : 3e38f, no_object};
        return true;
    }

    static ENFILADE_HD void write(const BvhJob& job, std::uint64_t i, WalkStatus status, float distance,
                                  std::uint32_t face, std::uint32_t object, std::uint32_t triangle) {
        if (job.hits.distance != nullptr) job.hits.distance[i] = distance;
        if (job.hits.source_face != nullptr) job.hits.source_face[i] = static_cast<accel::SourceFaceId>(face);
        if (job.hits.status != nullptr) job.hits.status[i] = status;
        if (job.hits.object != nullptr) job.hits.object[i] = static_cast<accel::ObjectId>(object);
        if (job.hits.triangle != nullptr) job.hits.triangle[i] = triangle;
    }

    template <class View>
    static ENFILADE_HD void answer_ray(const BvhJob& job, std::uint64_t i, const View& bvh, const BvhHit& hit) {
        BvhQuery query = {};
        float metres, limit;
        column_query(job, i, query, metres, limit);
        if (hit.record == no_record) {
            const bool is_limited = limit < 1e30f;
            return write(job, i, is_limited ? WalkStatus::Reached : WalkStatus::Leak, limit, ~0u, no_object,
                         no_triangle);
        }
        const std::uint32_t item = bvh.records[hit.record].item & item_mask;
        if (hit.instance == no_object)
            return write(job, i, WalkStatus::Hit, hit.t * metres, job.looks[item].source_face & ~detail::sky_bit,
                         no_object, no_triangle);
        write(job, i, WalkStatus::Object, hit.t * metres, ~0u, hit.instance,
              item - bvh.instances[hit.instance].first_triangle);
    }

    template <class View>
    static ENFILADE_HD void answer_pixel(const BvhJob& job, std::uint64_t i, const View& bvh, const BvhHit& hit) {
        const std::int64_t pixel = pixel_of(job, i);
        const Vec3f d = pixel_direction(job, pixel);
        std::uint32_t* rgba = job.rgba + pixel;
        if (job.ask == BvhAsk::Places) job.places[i].is_lit = 0;
        if (hit.record == no_record) {
            *rgba = nothing_seen;
            return;
        }
        const BvhShown seen = shown(job, bvh, hit);
        if (is_sky(seen.look)) {
            *rgba = encoded(sky_colour(job.look, d));
            return;
        }
        const float along = dot(seen.normal, d);
        if (job.ask == BvhAsk::Places) {
            const float scale = (along > 0 ? -1.0f : 1.0f) * quick_inverse(quick_root(dot(seen.normal, seen.normal)));
            const Vec3f p = job.camera.origin + hit.t * d, n = scale * seen.normal;
            job.places[i] = {
                {p.x, p.y, p.z}, 1, {n.x, n.y, n.z}, 0, {seen.look.red, seen.look.green, seen.look.blue}, 0};
            return;
        }
        const float cosine =
            magnitude(along) * quick_inverse(quick_root(dot(seen.normal, seen.normal)) * quick_root(dot(d, d)));
        const float lit = quick_root(cosine);
        *rgba = encoded_roots({seen.look.red * lit, seen.look.green * lit, seen.look.blue * lit});
    }
};

/// Whether something lies on segments.
struct SegmentFeeder {
    static constexpr bool any = true;
    bool is_asked;

    ENFILADE_HD void start(const BvhJob&, std::uint64_t) { is_asked = false; }

    ENFILADE_HD bool next(const BvhJob& job, std::uint64_t i, BvhQuery& query) {
        if (is_asked) return false;
        is_asked = true;
        const Vec3f p = {job.segments.from[0][i], job.segments.from[1][i], job.segments.from[2][i]};
        const Vec3f q = {job.segments.to[0][i], job.segments.to[1][i], job.segments.to[2][i]};
        const Vec3f d = q - p;
        const float part = job.skin * quick_inverse(quick_root(dot(d, d)));
        if (is_place(p) && is_place(q) && part < 0.5f) {
            query = {p, d, part, 1 - part, no_object};
            return true;
        }
        job.visible[i] = is_place(p) && is_place(q) ? 1 : 0;  // nearer to each other than the skin
        return false;
    }

    template <class View>
    ENFILADE_HD void answer(const BvhJob& job, std::uint64_t i, const View&, const BvhHit& hit) const {
        job.visible[i] = hit.record == no_record ? 1 : 0;
    }
};

/// Light of the lamps that each place's cell may see: a shadow ray each, one after the other.
struct LampFeeder {
    static constexpr bool any = true;
    static constexpr float shadow_skin = 1e-3f;  ///< metres: shadow rays are kept this far off the places
    Vec3f lux;
    float share;  ///< of the lamp's intensity that is asked about
    std::uint32_t at, end;

    ENFILADE_HD void start(const BvhJob& job, std::uint64_t i) {
        lux = {0, 0, 0};
        at = end = 0;
        if (job.places[i].is_lit == 0) return;
        const std::uint32_t cell = job.lamps.cells[pixel_of(job, i)];
        at = job.lamps.offsets[cell];
        end = job.lamps.offsets[cell + 1];
    }

    ENFILADE_HD bool next(const BvhJob& job, std::uint64_t i, BvhQuery& query) {
        const auto* from = reinterpret_cast<const unsigned char*>(job.places + i);
        const Float4 place = load_float4(from);
        if (bits_of(place.w) == 0) return false;
        const Float4 normal = load_float4(from + 16);
        for (; at < end; ++at) {
            const accel::Light& light = job.lamps.lights[job.lamps.lamps[at]];
            const auto* lamp = reinterpret_cast<const float*>(&light.position);
            const Vec3f way = {lamp[0] - place.x, lamp[1] - place.y, lamp[2] - place.z};
            const float towards = fused(way.x, normal.x, fused(way.y, normal.y, way.z * normal.z));
            if (!(towards > 0)) continue;
            const float square = fused(way.x, way.x, fused(way.y, way.y, way.z * way.z));
            const float inverse = quick_inverse(quick_root(square));
            share = least(towards * inverse * (inverse * inverse), largest_share);
            const float skin = shadow_skin * inverse;
            const auto carrier = static_cast<std::uint32_t>(light.carrier);
            query = job.lamps.from_lamps ? BvhQuery{{lamp[0], lamp[1], lamp[2]}, -way, 0, 1 - skin, carrier}
                                         : BvhQuery{{place.x, place.y, place.z}, way, skin, 1, carrier};
            return true;
        }
        write(job, i);
        return false;
    }

    template <class View>
    ENFILADE_HD void answer(const BvhJob& job, std::uint64_t, const View&, const BvhHit& hit) {
        const accel::Light& light = job.lamps.lights[job.lamps.lamps[at++]];
        if (hit.record != no_record) return;
        const auto* candela = reinterpret_cast<const float*>(&light.intensity);
        lux = {fused(share, candela[0], lux.x), fused(share, candela[1], lux.y), fused(share, candela[2], lux.z)};
    }

private:
    ENFILADE_HD void write(const BvhJob& job, std::uint64_t i) const {
        const Float4 colour = load_float4(reinterpret_cast<const unsigned char*>(job.places + i) + 32);
        const float scale = job.lamps.exposure * 0.318309886f;
        job.rgba[pixel_of(job, i)] =
            encoded_roots({quick_root(lux.x * scale) * colour.x, quick_root(lux.y * scale) * colour.y,
                           quick_root(lux.z * scale) * colour.z});
    }
};

}  // namespace enfilade::render::cuda
