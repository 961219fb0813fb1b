#pragma once
// Three numbers, on host and device.

#include "accel/host_device.h"
#include "render/math.h"

namespace enfilade::render {

template <class T>
struct Vec {
    T x, y, z;

    friend ENFILADE_HD Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend ENFILADE_HD Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend ENFILADE_HD Vec operator-(Vec a) { return {-a.x, -a.y, -a.z}; }
    friend ENFILADE_HD Vec operator*(T s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
    friend ENFILADE_HD Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

template <class T>
ENFILADE_HD T dot(Vec<T> a, Vec<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
ENFILADE_HD Vec<T> cross(Vec<T> a, Vec<T> b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
ENFILADE_HD T length(Vec<T> a) {
    return root(dot(a, a));
}

template <class T>
ENFILADE_HD Vec<T> normalized(Vec<T> a) {
    return (T(1) / length(a)) * a;
}

template <class To, class From>
ENFILADE_HD Vec<To> vec_cast(Vec<From> a) {
    return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

using Vec3f = Vec<float>;
using Vec3d = Vec<double>;

}  // namespace enfilade::render
