#pragma once
// A ray as the walk reads it: its line, and how ties on that line are broken.

#include <cstdint>

#include "accel/host_device.h"
#include "render/isa.h"
#include "render/math.h"
#include "render/vec.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Whether a zero side counts as positive: the sign it has when every vertical line is shifted by (e, e^2) for a
/// vanishing e. The reversed ray has the other answer, so it crosses the reversed cells.
template <class T>
ENFILADE_HD bool zero_side_is_positive(T dx, T dy) {
    return dy < T(0) || (dy == T(0) && dx > T(0));
}

/// A line in 3D, and its projection as a line in 2D by its Plücker coordinates.
template <class T>
struct Ray {
    Vec<T> origin;     ///< metres, scene frame
    Vec<T> direction;  ///< scaled by a power of two so that its largest component is in [1, 2)
    T moment;          ///< origin.x direction.y - origin.y direction.x
    T zero_sign;  ///< -1 where a zero side counts as positive, else 1: "positive" is `side > 0`, there `!(-side > 0)`
    std::uint32_t zero_mask;  ///< all ones where a zero side counts as positive
};

/// On which side of the ray the vertical line (x, y) passes: positive to the left. The one side-test function: every
/// cell and section evaluates a vertical line by these operations on these numbers.
template <class T>
ENFILADE_HD T line_side(const Ray<T>& ray, T x, T y) {
    return fused(y, ray.direction.x, fused(x, -ray.direction.y, ray.moment));
}

/// a b - c d to 1.5 ulp (Kahan), antisymmetric in exchanging the products.
template <class T>
ENFILADE_HD T difference_of_products(T a, T b, T c, T d) {
    const T cd = c * d;
    const T error = fused(-c, d, cd);
    return fused(a, b, -cd) + error;
}

/// \pre all numbers finite, the largest component of direction within 2^-10 and 2^10, and its level part zero or not
/// below 2^-40 of that: what a camera gives.
template <class T>
ENFILADE_HD Ray<T> make_ray_unchecked(Vec<T> origin, Vec<T> direction) {
    const bool zero_is_left = zero_side_is_positive(direction.x, direction.y);
    const T moment = difference_of_products(origin.x, direction.y, origin.y, direction.x);
    return {origin, direction, moment, zero_is_left ? T(-1) : T(1), zero_is_left ? ~0u : 0u};
}

/// No coordinate of a scene or a ray's origin lies beyond: metres.
inline constexpr float largest_place = 1e12f;

ENFILADE_HD bool is_place(Vec<float> p) {
    return (magnitude(p.x) <= largest_place) & (magnitude(p.y) <= largest_place) & (magnitude(p.z) <= largest_place);
}

template <class T>
ENFILADE_HD T largest_part(Vec<T> v) {
    return larger(larger(magnitude(v.x), magnitude(v.y)), magnitude(v.z));
}

/// What brings a to [1, 2): the power of two 2^-e for 2^e <= a < 2^(e+1). \pre 2^-126 <= a < 2^126
ENFILADE_HD float unit_scale(float a) { return float_of((254u << 23) - (bits_of(a) & 0x7f800000u)); }

/// Whether make_ray has an answer. The comparisons are written so that NaN fails them.
template <class T>
ENFILADE_HD bool is_ray(Vec<T> origin, Vec<T> direction) {
    const T largest = largest_part(direction);
    return (magnitude(direction.x) <= T(1e37)) & (magnitude(direction.y) <= T(1e37)) &
           (magnitude(direction.z) <= T(1e37)) & (magnitude(origin.x) <= T(largest_place)) &
           (magnitude(origin.y) <= T(largest_place)) & (magnitude(origin.z) <= T(largest_place)) & (largest > T(0));
}

/// The direction scaled by a power of two so that its largest component is in [1, 2), denormal and huge ones included;
/// what leans less than 2^-40 is vertical. \pre is_ray
ENFILADE_HD Vec<float> scaled_direction(Vec<float> direction) {
    const float largest = largest_part(direction);
    const float lift = largest < 0x1p-126f ? 0x1p100f : 1.0f;  // denormal numbers have no exponent of their own
    direction = unit_scale(lift * largest) * (lift * direction);
    const bool leans = (magnitude(direction.x) >= 0x1p-40f) | (magnitude(direction.y) >= 0x1p-40f);
    return {leans ? direction.x : 0.0f, leans ? direction.y : 0.0f, direction.z};
}

ENFILADE_HD Vec<double> scaled_direction(Vec<double> direction) {
    const int exponent = exponent_of(largest_part(direction));
    direction = {scaled(direction.x, -exponent), scaled(direction.y, -exponent), scaled(direction.z, -exponent)};
    if (magnitude(direction.x) < 0x1p-40 && magnitude(direction.y) < 0x1p-40) direction.x = direction.y = 0;
    return direction;
}

/// The ray from any finite, non-zero direction; false (and no ray) for others.
template <class T>
ENFILADE_HD bool make_ray(Vec<T> origin, Vec<T> direction, Ray<T>& ray) {
    if (!is_ray(origin, direction)) return false;
    ray = make_ray_unchecked(origin, scaled_direction(direction));
    return true;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
