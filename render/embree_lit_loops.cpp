// Pictures lit by lamps through Embree: sixteen neighbours ask for one lamp after the other. Compiled once for every
// instruction set of Highway's.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/embree_lit_loops.cpp"
#include <hwy/foreach_target.h>
//
#include <hwy/highway.h>

#include "render/embree_lit_loops.h"
#include "render/embree_packets-inl.h"
#include "render/embree_shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Places that gather light.
template <int N>
struct alignas(64) LitBlock {
    float point[3][N];
    float normal[3][N];
    float lux[3][N];
    std::uint32_t cell[N];
    std::int32_t waiting[N];  ///< -1: not lit yet
};

template <int N>
HWY_INLINE Vec3<Floats<N>> load(const float (&columns)[3][N], std::size_t k) {
    const Floats<N> d;
    return {hn::Load(d, columns[0] + k), hn::Load(d, columns[1] + k), hn::Load(d, columns[2] + k)};
}

template <int N>
HWY_INLINE void store(const Vec3<Floats<N>>& v, float (&columns)[3][N], std::size_t k) {
    const Floats<N> d;
    hn::Store(v.x, d, columns[0] + k);
    hn::Store(v.y, d, columns[1] + k);
    hn::Store(v.z, d, columns[2] + k);
}

/// Shadow rays of a block, and who asks with them.
template <class Packet>
struct ShadowRays {
    static constexpr int N = Packet::lanes;
    RTCScene scene;
    RTCIntersectContext context;
    alignas(64) typename Packet::Ray ray;
    alignas(64) std::int32_t asking[N];  ///< -1: of the lamp's list
    alignas(64) int valid[N];
    alignas(64) float share[N];  ///< of the lamp's intensity, where it is seen

    explicit ShadowRays(const EmbreeLitTile& job) : scene(job.tile.embree.scene) {
        EmbreeScene embree = job.tile.embree;
        embree.coherent = job.coherent_shadows;
        context = context_of(embree);
        fill_constants<N>(ray, nullptr);
    }
};

/// Rays between a lamp and those places that face it; whether there are any.
template <bool from_lamp, class Packet>
HWY_INLINE bool aim_at_lamp(const accel::Light& light, const LitBlock<Packet::lanes>& block, ShadowRays<Packet>& to) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    const hn::RebindToSigned<Floats<N>> di;
    using V = Vec3<Floats<N>>;
    const V lamp = {hn::Set(d, light.position[0]), hn::Set(d, light.position[1]), hn::Set(d, light.position[2])};
    bool any = false;
    for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
        const V place = load<N>(block.point, k);
        const V way = {hn::Sub(lamp.x, place.x), hn::Sub(lamp.y, place.y), hn::Sub(lamp.z, place.z)};
        const auto inverse = inverse_root(d, dot<Floats<N>>(way, way));
        const auto towards = dot<Floats<N>>(way, load<N>(block.normal, k));
        const auto faces = hn::Gt(towards, hn::Zero(d));
        const auto valid = hn::And(hn::Load(di, to.asking + k), hn::VecFromMask(di, hn::RebindMask(di, faces)));
        any = any || !hn::AllFalse(di, hn::Lt(valid, hn::Zero(di)));
        hn::Store(valid, di, to.valid + k);
        // Never an infinite share, however near the lamp is (lamp_light.h).
        const auto share = hn::Mul(hn::Mul(towards, inverse), hn::Mul(inverse, inverse));
        hn::Store(hn::Min(share, hn::Set(d, 1e12f)), d, to.share + k);
        const auto skin = hn::Mul(hn::Set(d, shadow_skin), inverse);
        const V& start = from_lamp ? lamp : place;
        hn::Store(start.x, d, to.ray.org_x + k);
        hn::Store(start.y, d, to.ray.org_y + k);
        hn::Store(start.z, d, to.ray.org_z + k);
        hn::Store(from_lamp ? hn::Neg(way.x) : way.x, d, to.ray.dir_x + k);
        hn::Store(from_lamp ? hn::Neg(way.y) : way.y, d, to.ray.dir_y + k);
        hn::Store(from_lamp ? hn::Neg(way.z) : way.z, d, to.ray.dir_z + k);
        hn::Store(from_lamp ? hn::Zero(d) : skin, d, to.ray.tnear + k);
        hn::Store(from_lamp ? hn::Sub(hn::Set(d, 1.0f), skin) : hn::Set(d, 1.0f), d, to.ray.tfar + k);
    }
    return any;
}

template <class Packet>
HWY_INLINE void add_light(const accel::Light& light, const ShadowRays<Packet>& from, LitBlock<Packet::lanes>& block) {
    constexpr int N = Packet::lanes;
    const Floats<N> d;
    const hn::RebindToSigned<Floats<N>> di;
    for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
        const auto is_valid = hn::RebindMask(d, hn::Lt(hn::Load(di, from.valid + k), hn::Zero(di)));
        const auto is_seen = hn::And(is_valid, hn::Ge(hn::Load(d, from.ray.tfar + k), hn::Zero(d)));
        const auto share = hn::IfThenElseZero(is_seen, hn::Load(d, from.share + k));
        for (int c = 0; c < 3; ++c) {
            float* lux = block.lux[c] + k;
            hn::Store(hn::MulAdd(share, hn::Set(d, light.intensity[static_cast<std::size_t>(c)]), hn::Load(d, lux)), d,
                      lux);
        }
    }
}

/// Lanes that wait in the first one's cell take turns no more, and ask.
template <int N>
HWY_INLINE bool next_cell(LitBlock<N>& block, std::int32_t* asking, std::uint32_t& cell) {
    int first = 0;
    while (first < N && block.waiting[first] == 0) ++first;
    if (first == N) return false;
    cell = block.cell[first];
    for (int k = 0; k < N; ++k) {
        asking[k] = block.cell[k] == cell ? block.waiting[k] : 0;
        block.waiting[k] ^= asking[k];
    }
    return true;
}

/// Most blocks lie in one cell; others ask by cell.
template <bool from_lamp, class Packet>
HWY_INLINE void gather(const EmbreeLitTile& job, ShadowRays<Packet>& shadows, LitBlock<Packet::lanes>& block) {
    __builtin_memset(block.lux, 0, sizeof block.lux);
    std::uint32_t cell = 0;
    while (next_cell<Packet::lanes>(block, shadows.asking, cell)) {
        const std::uint32_t end = job.offsets[cell + 1];
        for (std::uint32_t l = job.offsets[cell]; l < end; ++l) {
            const accel::Light& light = job.lights[job.lamps[l]];
            if (!aim_at_lamp<from_lamp, Packet>(light, block, shadows)) continue;
            Packet::occluded(shadows.valid, shadows.scene, &shadows.context, &shadows.ray);
            add_light<Packet>(light, shadows, block);
        }
    }
}

/// Where lanes of rays hit, and the unit normal there, towards the eye.
template <class D>
struct Place {
    Vec3<D> point, normal;
};

template <class D>
HWY_INLINE Place<D> place_of_hit(D d, const Vec3f& origin, const Vec3<D>& direction, hn::Vec<D> t, const Vec3<D>& n) {
    const auto inverse = inverse_root(d, dot<D>(n, n));
    const auto is_behind = hn::Gt(dot<D>(n, direction), hn::Zero(d));
    const auto scale = hn::IfThenElse(is_behind, hn::Neg(inverse), inverse);
    return {{hn::MulAdd(t, direction.x, hn::Set(d, origin.x)), hn::MulAdd(t, direction.y, hn::Set(d, origin.y)),
             hn::MulAdd(t, direction.z, hn::Set(d, origin.z))},
            {hn::Mul(n.x, scale), hn::Mul(n.y, scale), hn::Mul(n.z, scale)}};
}

/// Square roots of what light makes of colours.
template <class D>
HWY_INLINE Vec3<D> lit_roots(D d, float exposure, const Vec3<D>& lux, const Vec3<D>& colour) {
    const auto scale = hn::Set(d, exposure * 0.318309886f);
    return {hn::Mul(hn::Sqrt(hn::Mul(lux.x, scale)), colour.x), hn::Mul(hn::Sqrt(hn::Mul(lux.y, scale)), colour.y),
            hn::Mul(hn::Sqrt(hn::Mul(lux.z, scale)), colour.z)};
}

template <int N>
HWY_INLINE void store_pixels(const EmbreeTile& job, int x, int y, const std::uint32_t* pixels) {
    std::uint32_t* to = job.rgba + static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x;
    for (int row = 0; row < N / 4; ++row, to += job.width) __builtin_memcpy(to, pixels + 4 * row, 16);
}

template <int N>
HWY_INLINE void load_cells(const EmbreeLitTile& job, int x, int y, LitBlock<N>& block) {
    const std::size_t width = static_cast<std::size_t>(job.tile.width);
    const std::uint32_t* from = job.cells + static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
    for (int row = 0; row < N / 4; ++row, from += width) __builtin_memcpy(block.cell + 4 * row, from, 16);
}

template <class Packet, bool from_lamp>
HWY_NOINLINE void trace_lit(const EmbreeLitTile& job) {
    constexpr int N = Packet::lanes;
    using D = Floats<N>;
    const D d;
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    RTCIntersectContext context = context_of(job.tile.embree);
    alignas(64) int valid[N];
    for (int& lane : valid) lane = -1;
    alignas(64) typename Packet::RayHit query;
    fill_constants<N>(query.ray, &job.tile.camera->origin);
    ShadowRays<Packet> shadows(job);
    LitBlock<N> block;
    const CameraFrame camera = *job.tile.camera;
    const auto direction_at = [&](std::size_t k) HWY_ATTR {
        return Vec3<D>{hn::Load(d, query.ray.dir_x + k), hn::Load(d, query.ray.dir_y + k),
                       hn::Load(d, query.ray.dir_z + k)};
    };
    for (int y = job.tile.y0; y < job.tile.y1; y += N / 4) {
        for (int x = job.tile.x0; x < job.tile.x1; x += 4) {
            aim_packet<N>(camera, x, y, query);
            Packet::intersect(valid, job.tile.embree.scene, &context, &query);
            load_cells<N>(job, x, y, block);
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const Shown<D> seen = shown(d, job.tile.embree, query.hit, k);
                const Place<D> place =
                    place_of_hit<D>(d, camera.origin, direction_at(k), hn::Load(d, query.ray.tfar + k), seen.normal);
                store<N>(place.point, block.point, k);
                store<N>(place.normal, block.normal, k);
                const auto waits = hn::AndNot(hn::RebindMask(di, seen.is_sky), hn::RebindMask(di, seen.has_hit));
                hn::Store(hn::VecFromMask(di, waits), di, block.waiting + k);
            }
            gather<from_lamp, Packet>(job, shadows, block);
            alignas(64) std::uint32_t pixels[N];
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const Shown<D> seen = shown(d, job.tile.embree, query.hit, k);
                const Vec3<D> light = lit_roots<D>(d, job.exposure, load<N>(block.lux, k), seen.colour);
                hn::Store(pixels_of<D>(d, *job.tile.look, seen, direction_at(k), light), du, pixels + k);
            }
            store_pixels<N>(job.tile, x, y, pixels);
        }
    }
}

/// The block's first number in columns of blocks of 4 x 4 pixels.
HWY_INLINE std::size_t place_in_blocks(const EmbreeTile& job, int x, int y) {
    return static_cast<std::size_t>(16 * ((y / 4) * (job.width / 4) + x / 4) + 4 * (y % 4));
}

/// From known first hits: shadow rays and shading alone.
template <class Packet, bool from_lamp>
HWY_NOINLINE void light_known(const EmbreeLitTile& job) {
    constexpr int N = Packet::lanes;
    using D = Floats<N>;
    const D d;
    const hn::RebindToUnsigned<D> du;
    ShadowRays<Packet> shadows(job);
    LitBlock<N> block;
    for (int y = job.tile.y0; y < job.tile.y1; y += N / 4) {
        for (int x = job.tile.x0; x < job.tile.x1; x += 4) {
            const std::size_t at = place_in_blocks(job.tile, x, y);
            load_cells<N>(job, x, y, block);
            for (int c = 0; c < 3; ++c) {
                __builtin_memcpy(block.point[c], job.point[c] + at, sizeof block.point[c]);
                __builtin_memcpy(block.normal[c], job.normal[c] + at, sizeof block.normal[c]);
            }
            for (std::size_t k = 0; k < N; ++k) block.waiting[k] = -static_cast<std::int32_t>(job.is_lit[at + k]);
            gather<from_lamp, Packet>(job, shadows, block);
            alignas(64) std::uint32_t pixels[N];
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const Vec3<D> colour = {hn::LoadU(d, job.colour[0] + at + k), hn::LoadU(d, job.colour[1] + at + k),
                                        hn::LoadU(d, job.colour[2] + at + k)};
                const Vec3<D> light = lit_roots<D>(d, job.exposure, load<N>(block.lux, k), colour);
                const auto pixel = hn::Or(hn::Or(encoded(d, light.x), hn::ShiftLeft<8>(encoded(d, light.y))),
                                          hn::Or(hn::ShiftLeft<16>(encoded(d, light.z)), hn::Set(du, 0xff000000u)));
                hn::Store(pixel, du, pixels + k);
            }
            store_pixels<N>(job.tile, x, y, pixels);
        }
    }
}

void places_tile(const EmbreePlacesTile& job) {
    constexpr int N = Sixteen::lanes;
    using D = Floats<N>;
    const D d;
    RTCIntersectContext context = context_of(job.tile.embree);
    alignas(64) int valid[N];
    for (int& lane : valid) lane = -1;
    alignas(64) RTCRayHit16 query;
    fill_constants<N>(query.ray, &job.tile.camera->origin);
    for (int y = job.tile.y0; y < job.tile.y1; y += 4) {
        for (int x = job.tile.x0; x < job.tile.x1; x += 4) {
            aim_packet<N>(*job.tile.camera, x, y, query);
            rtcIntersect16(valid, job.tile.embree.scene, &context, &query);
            for (std::size_t k = 0; k < N; k += hn::Lanes(d)) {
                const std::size_t at = place_in_blocks(job.tile, x, y) + k;
                const Shown<D> seen = shown(d, job.tile.embree, query.hit, k);
                const Vec3<D> direction = {hn::Load(d, query.ray.dir_x + k), hn::Load(d, query.ray.dir_y + k),
                                           hn::Load(d, query.ray.dir_z + k)};
                const Place<D> place = place_of_hit<D>(d, job.tile.camera->origin, direction,
                                                       hn::Load(d, query.ray.tfar + k), seen.normal);
                const auto keep = [&](const Vec3<D>& v, float* const* columns) HWY_ATTR {
                    hn::StoreU(v.x, d, columns[0] + at);
                    hn::StoreU(v.y, d, columns[1] + at);
                    hn::StoreU(v.z, d, columns[2] + at);
                };
                keep(place.point, job.point);
                keep(place.normal, job.normal);
                keep(seen.colour, job.colour);
                const hn::RebindToSigned<D> di;
                alignas(64) std::int32_t lit[N];
                hn::Store(
                    hn::VecFromMask(di, hn::AndNot(hn::RebindMask(di, seen.is_sky), hn::RebindMask(di, seen.has_hit))),
                    di, lit);
                for (std::size_t i = 0; i < hn::Lanes(d); ++i) job.is_lit[at + i] = lit[i] != 0 ? 1 : 0;
            }
        }
    }
}

template <bool from_lamp>
void lit_tile_from(const EmbreeLitTile& job, int lanes) {
    if (job.is_lit == nullptr)
        run(job, lanes, trace_lit<Single, from_lamp>, trace_lit<Eight, from_lamp>, trace_lit<Sixteen, from_lamp>);
    else
        run(job, lanes, light_known<Single, from_lamp>, light_known<Eight, from_lamp>, light_known<Sixteen, from_lamp>);
}
void lit_tile(const EmbreeLitTile& job, int lanes) {
    (job.from_lamps ? lit_tile_from<true> : lit_tile_from<false>)(job, lanes);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render::detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade::render::detail {

HWY_EXPORT(lit_tile);
HWY_EXPORT(places_tile);

void embree_lit_tile(const EmbreeLitTile& job, int lanes) { HWY_DYNAMIC_DISPATCH(lit_tile)(job, lanes); }
void embree_places_tile(const EmbreePlacesTile& job) { HWY_DYNAMIC_DISPATCH(places_tile)(job); }

}  // namespace enfilade::render::detail
#endif
