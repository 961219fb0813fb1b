// Hits of Embree's as pixels, in lanes. Compiled once for every instruction set of Highway's.
// No pragma once: the include guard is turned over for each of them.

#if defined(ENFILADE_RENDER_EMBREE_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ENFILADE_RENDER_EMBREE_SHADE_INL_H
#undef ENFILADE_RENDER_EMBREE_SHADE_INL_H
#else
#define ENFILADE_RENDER_EMBREE_SHADE_INL_H
#endif

#include <hwy/highway.h>

#include "render/embree_loops.h"
#include "render/framebuffer.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::render::detail {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class D>
struct Vec3 {
    hn::Vec<D> x, y, z;
};

template <class D>
HWY_INLINE hn::Vec<D> dot(const Vec3<D>& a, const Vec3<D>& b) {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}

/// 1 / sqrt(a) to some 22 bits.
template <class D>
HWY_INLINE hn::Vec<D> inverse_root(D d, hn::Vec<D> a) {
    const auto guess = hn::ApproximateReciprocalSqrt(a);
    const auto half = hn::Mul(hn::Mul(a, hn::Set(d, 0.5f)), guess);
    return hn::Mul(guess, hn::NegMulAdd(half, guess, hn::Set(d, 1.5f)));
}

/// A channel of a framebuffer from the square root of its light.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> encoded(D d, hn::Vec<D> root) {
    const auto channel = hn::MulAdd(hn::Set(d, 255.0f), hn::Min(root, hn::Set(d, 1.0f)), hn::Set(d, 0.5f));
    return hn::BitCast(hn::RebindToUnsigned<D>(), hn::ConvertTo(hn::RebindToSigned<D>(), channel));
}

/// Square roots of the sky's light.
template <class D>
HWY_INLINE Vec3<D> sky(D d, const Look& look, const Vec3<D>& direction) {
    const auto up = hn::Mul(direction.z, inverse_root(d, dot<D>(direction, direction)));
    const auto blend = hn::Sqrt(hn::Max(up, hn::Zero(d)));
    const auto between = [&](float horizon, float zenith) {
        return hn::Sqrt(hn::MulAdd(blend, hn::Set(d, zenith - horizon), hn::Set(d, horizon)));
    };
    return {between(look.sky_horizon.x, look.sky_zenith.x), between(look.sky_horizon.y, look.sky_zenith.y),
            between(look.sky_horizon.z, look.sky_zenith.z)};
}

/// Which place was hit; `place_count` where it was a face.
template <class DU, class Hit>
HWY_INLINE hn::Vec<DU> place_of(DU du, const EmbreeScene& embree, const Hit& hit, std::size_t k) {
    return hn::Min(hn::Load(du, (embree.flat ? hit.geomID : hit.instID[0]) + k), hn::Set(du, embree.place_count));
}

/// The square root of the cosine between two vectors of any length, whichever way they point.
template <class D>
HWY_INLINE hn::Vec<D> root_of_cosine(D d, const Vec3<D>& a, const Vec3<D>& b) {
    const auto scale = hn::Mul(dot<D>(a, a), dot<D>(b, b));
    return hn::Sqrt(hn::Mul(hn::Abs(dot<D>(a, b)), inverse_root(d, scale)));
}

/// Turns the lanes' normals, where objects were hit, and their triangles into looks. Most packets see one object.
template <class D>
HWY_INLINE void through_places(D d, const EmbreeScene& embree, hn::Vec<hn::RebindToUnsigned<D>> place, Vec3<D>& normal,
                               hn::Vec<hn::RebindToUnsigned<D>>& primitive) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    const Vec3<D> n = normal;
    const std::uint32_t first = hn::GetLane(place);
    if (HWY_LIKELY(hn::AllTrue(du, hn::Eq(place, hn::Set(du, first))))) {
        if (first == embree.place_count) return;
        const EmbreePlace& one = embree.places[first];
        const auto row = [&](const float* m) HWY_ATTR {
            return hn::MulAdd(n.x, hn::Set(d, m[0]), hn::MulAdd(n.y, hn::Set(d, m[1]), hn::Mul(n.z, hn::Set(d, m[2]))));
        };
        normal = {row(one.normal), row(one.normal + 3), row(one.normal + 6)};
        primitive = hn::Add(hn::And(primitive, hn::Set(du, one.look_mask)), hn::Set(du, one.first_look));
        return;
    }
    const auto at = hn::BitCast(di, hn::ShiftLeft<4>(place));
    const float* numbers = embree.places->normal;
    const auto row = [&](const float* m) HWY_ATTR {
        return hn::MulAdd(n.x, hn::GatherIndex(d, m, at),
                          hn::MulAdd(n.y, hn::GatherIndex(d, m + 1, at), hn::Mul(n.z, hn::GatherIndex(d, m + 2, at))));
    };
    normal = {row(numbers), row(numbers + 3), row(numbers + 6)};
    const std::uint32_t* looks = &embree.places->first_look;
    primitive = hn::Add(hn::And(primitive, hn::GatherIndex(du, looks + 1, at)), hn::GatherIndex(du, looks, at));
}

/// What lanes of hits show.
template <class D>
struct Shown {
    hn::Mask<hn::RebindToUnsigned<D>> has_hit;
    Vec3<D> normal;  ///< of any length, on either side
    Vec3<D> colour;  ///< square roots of the diffuse reflectance
    hn::Mask<D> is_sky;
};

/// Most packets see one primitive.
template <class D, class Hit>
HWY_INLINE Shown<D> shown(D d, const EmbreeScene& embree, const Hit& hit, std::size_t k) {
    const hn::RebindToUnsigned<D> du;
    const hn::RebindToSigned<D> di;
    Shown<D> seen;
    seen.has_hit = hn::Ne(hn::Load(du, hit.geomID + k), hn::Set(du, RTC_INVALID_GEOMETRY_ID));
    auto primitive = hn::IfThenElseZero(seen.has_hit, hn::Load(du, hit.primID + k));
    seen.normal = {hn::Load(d, hit.Ng_x + k), hn::Load(d, hit.Ng_y + k), hn::Load(d, hit.Ng_z + k)};
    if (embree.places != nullptr) through_places<D>(d, embree, place_of(du, embree, hit, k), seen.normal, primitive);
    const bool is_one = hn::AllTrue(du, hn::And(seen.has_hit, hn::Eq(primitive, hn::Set(du, hn::GetLane(primitive)))));
    if (HWY_LIKELY(is_one)) {
        const PrimitiveLook& look = embree.looks[hn::GetLane(primitive)];
        seen.colour = {hn::Set(d, look.red), hn::Set(d, look.green), hn::Set(d, look.blue)};
        seen.is_sky = hn::MaskFromVec(hn::BitCast(d, hn::Set(du, (look.source_face & sky_bit) != 0 ? ~0u : 0u)));
    } else {
        const auto place = hn::BitCast(di, hn::ShiftLeft<2>(primitive));
        const float* looks = &embree.looks->red;
        seen.colour = {hn::GatherIndex(d, looks, place), hn::GatherIndex(d, looks + 1, place),
                       hn::GatherIndex(d, looks + 2, place)};
        const auto face = hn::BitCast(di, hn::GatherIndex(d, looks + 3, place));
        seen.is_sky = hn::RebindMask(d, hn::Lt(face, hn::Zero(di)));
    }
    return seen;
}

/// Square roots of light as pixels: the sky's own where it is seen, magenta where nothing is.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> pixels_of(D d, const Look& look, const Shown<D>& seen,
                                                      const Vec3<D>& direction, Vec3<D> light) {
    const hn::RebindToUnsigned<D> du;
    if (!hn::AllFalse(d, seen.is_sky)) {
        const Vec3<D> above = sky(d, look, direction);
        light = {hn::IfThenElse(seen.is_sky, above.x, light.x), hn::IfThenElse(seen.is_sky, above.y, light.y),
                 hn::IfThenElse(seen.is_sky, above.z, light.z)};
    }
    const auto pixels = hn::Or(hn::Or(encoded(d, light.x), hn::ShiftLeft<8>(encoded(d, light.y))),
                               hn::Or(hn::ShiftLeft<16>(encoded(d, light.z)), hn::Set(du, 0xff000000u)));
    return hn::IfThenElse(hn::RebindMask(du, seen.has_hit), pixels, hn::Set(du, 0xffff00ffu));
}

/// What Lambert's shading makes of lanes of hits. Square roots of colours are multiplied by those of cosines: one root
/// for three channels.
template <class D, class Hit>
HWY_INLINE hn::Vec<hn::RebindToUnsigned<D>> shaded(D d, const EmbreeTile& job, const Vec3<D>& direction, const Hit& hit,
                                                   std::size_t k) {
    const Shown<D> seen = shown(d, job.embree, hit, k);
    const auto lit = root_of_cosine<D>(d, seen.normal, direction);
    const Vec3<D>& own = seen.colour;
    return pixels_of<D>(d, *job.look, seen, direction, {hn::Mul(own.x, lit), hn::Mul(own.y, lit), hn::Mul(own.z, lit)});
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render::detail
HWY_AFTER_NAMESPACE();
#endif  // per target
