#pragma once
// By which face a ray leaves a cube, and which quarter of that face it crosses, from the signs of three Plücker
// products and the paper's two tables (Portalez and Duguet 2016, sections 4.2.1 and 4.2.2). Header-only, for host and
// device.

#include <cstdint>

#include "accel/octree/rope_octree.h"
#include "render/isa.h"
#include "render/math.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

inline constexpr std::uint32_t invalid_exit = 7;  ///< signs that no ray has in exact arithmetic, but by ties

/// Eight numbers of `bits` bits each, the first lowest: tables lie in instructions, not in memory, of which a device's
/// thread would keep a copy of its own.
consteval std::uint32_t packed_row(std::uint32_t bits, const std::uint32_t (&row)[8]) {
    std::uint32_t packed = 0;
    for (std::uint32_t i = 0; i < 8; ++i) packed |= row[i] << (bits * i);
    return packed;
}

/// The row of the paper's equation 8 for a ray. octant: bit k where it goes up along axis k.
ENFILADE_HD std::uint32_t out_face_row(std::uint32_t octant) {
    constexpr std::uint32_t r0 = packed_row(3, {7, 2, 5, 2, 3, 3, 5, 7}), r1 = packed_row(3, {5, 7, 1, 1, 5, 2, 7, 2}),
                            r2 = packed_row(3, {3, 3, 7, 5, 0, 7, 0, 5}), r3 = packed_row(3, {0, 5, 0, 7, 7, 5, 1, 1}),
                            r4 = packed_row(3, {2, 4, 2, 7, 7, 4, 3, 3}), r5 = packed_row(3, {1, 1, 7, 4, 2, 7, 2, 4}),
                            r6 = packed_row(3, {4, 7, 3, 3, 4, 0, 7, 0}), r7 = packed_row(3, {7, 0, 4, 0, 1, 1, 4, 7});
    const std::uint32_t down = 7 - octant;
    const std::uint32_t low = (down & 2u) != 0 ? ((down & 1u) != 0 ? r3 : r2) : (down & 1u) != 0 ? r1 : r0;
    const std::uint32_t high = (down & 2u) != 0 ? ((down & 1u) != 0 ? r7 : r6) : (down & 1u) != 0 ? r5 : r4;
    return (down & 4u) != 0 ? high : low;
}

/// The paper's equation 8. row: the ray's; signs: as plucker_signs gives them at the corner where the three faces meet
/// by which such a ray can leave.
ENFILADE_HD std::uint32_t out_face_in(std::uint32_t row, std::uint32_t signs) { return row >> 3 * signs & 7u; }
ENFILADE_HD std::uint32_t out_face(std::uint32_t octant, std::uint32_t signs) {
    return out_face_in(out_face_row(octant), signs);
}

/// The paper's equation 9: u + 2 v. signs: at the middle of the face.
ENFILADE_HD std::uint32_t quarter_of(std::uint32_t face, std::uint32_t signs) {
    constexpr std::uint32_t r0 = packed_row(2, {1, 3, 1, 3, 0, 2, 0, 2}), r1 = packed_row(2, {2, 2, 0, 0, 3, 3, 1, 1}),
                            r2 = packed_row(2, {2, 0, 2, 0, 3, 1, 3, 1}), r3 = packed_row(2, {1, 1, 3, 3, 0, 0, 2, 2}),
                            r4 = packed_row(2, {2, 0, 3, 1, 2, 0, 3, 1}), r5 = packed_row(2, {1, 3, 0, 2, 1, 3, 0, 2});
    const std::uint32_t two = face < 2 ? r0 | r1 << 16 : face < 4 ? r2 | r3 << 16 : r4 | r5 << 16;
    return two >> (16 * (face & 1u) + 2 * signs) & 3u;
}

/// The sides on which a ray passes three lines along the axes x, y, z through one point: bit k where the product with
/// the line along axis k is not positive. direction; from: the ray's origin seen from that point. Moments are taken
/// about the point itself (the paper: about the scene's origin), so what is rounded is of the order of the octree.
template <class T>
ENFILADE_HD std::uint32_t plucker_signs(const T* direction, const T* from) {
    const T x = direction[1] * from[2] - direction[2] * from[1];
    const T y = direction[2] * from[0] - direction[0] * from[2];
    const T z = direction[0] * from[1] - direction[1] * from[0];
    return (x <= 0 ? 1u : 0u) | (y <= 0 ? 2u : 0u) | (z <= 0 ? 4u : 0u);
}

/// The paper's own form: the line's six coordinates (equation 1) once a ray, about the scene's origin, then equations 4
/// and 5. Far from that origin its signs are noise (README.md); kept to show so.
template <class T>
struct PluckerLine {
    T pi[6];
};
template <class T>
ENFILADE_HD PluckerLine<T> plucker_line(const T* origin, const T* direction) {
    const T q[3] = {origin[0] + direction[0], origin[1] + direction[1], origin[2] + direction[2]};
    return {{q[0] * origin[1] - origin[0] * q[1], q[0] * origin[2] - origin[0] * q[2], direction[0],
             q[1] * origin[2] - origin[1] * q[2], direction[2], -direction[1]}};
}
template <class T>
ENFILADE_HD std::uint32_t plucker_signs_at(const PluckerLine<T>& line, const T* point) {
    const T* pi = line.pi;
    const T x = pi[4] * point[1] + pi[5] * point[2] + pi[3];
    const T y = pi[2] * point[2] - pi[1] - pi[4] * point[0];
    const T z = pi[0] - pi[2] * point[1] - pi[5] * point[0];
    return (x <= 0 ? 1u : 0u) | (y <= 0 ? 2u : 0u) | (z <= 0 ? 4u : 0u);
}

/// A ray in an octree's lattice.
template <class T>
struct RopeRay {
    T origin[3];
    T direction[3];        ///< 0 where it is as good as 0: by those faces nothing is left
    T inverse[3];          ///< of it, 0 where it is 0
    std::uint32_t octant;  ///< bit k: it goes up along axis k
    std::uint32_t faces;   ///< out_face_row of it
};

/// origin, direction: in the mesh's own space.
template <class T>
ENFILADE_HD RopeRay<T> rope_ray(const accel::OctreeFrame& frame, const float* origin, const float* direction) {
    RopeRay<T> r;
    r.octant = 0;
    for (int k = 0; k < 3; ++k) {
        const T scale = frame.cells_a_unit.data()[k];
        r.origin[k] = (T(origin[k]) - T(frame.low.data()[k])) * scale;
        const T d = T(direction[k]) * scale;
        const bool is_still = magnitude(d) < T(0x1p-100);
        r.direction[k] = is_still ? T(0) : d;
        r.inverse[k] = is_still ? T(0) : T(1) / d;
        if (r.direction[k] > 0) r.octant |= 1u << k;
    }
    r.faces = out_face_row(r.octant);
    return r;
}

/// How a ray leaves a cube.
template <class T>
struct RopeExit {
    std::uint32_t face;  ///< invalid_exit: it has no direction
    T t;                 ///< where it meets that face's plane
    bool is_recovered;   ///< the table said nothing, or a face along which the ray goes
};

/// The face whose plane comes first; of several, that of the lowest axis. What is done where the table does not say.
template <class T>
ENFILADE_HD RopeExit<T> first_plane(const RopeRay<T>& r, const T* from) {
    RopeExit<T> exit = {invalid_exit, 0, true};
    for (int k = 0; k < 3; ++k) {
        const T t = -from[k] * r.inverse[k];
        if (r.inverse[k] == 0 || (exit.face != invalid_exit && !(t < exit.t))) continue;
        exit = {accel::face_at(k, r.inverse[k] > 0), t, true};
    }
    return exit;
}

/// from: the ray's origin seen from the corner by which it may leave (leaving_corner).
template <class T>
ENFILADE_HD RopeExit<T> exit_of(const RopeRay<T>& r, const T* from) {
    const std::uint32_t face = out_face_in(r.faces, plucker_signs(r.direction, from));
    if (face == invalid_exit) return first_plane(r, from);
    const int axis = accel::axis_of(face);
    const T inverse = component(r.inverse, axis);
    if (inverse == 0) return first_plane(r, from);
    return {face, -component(from, axis) * inverse, false};
}

/// The ray's origin seen from the corner of a cube where the faces meet by which it may leave.
template <class T>
ENFILADE_HD void from_leaving_corner(const RopeRay<T>& r, const accel::RopeCube& cube, T* from) {
    for (int k = 0; k < 3; ++k)
        from[k] = r.origin[k] - static_cast<T>(cube.low[k] + ((r.octant >> k & 1u) != 0 ? cube.width : 0u));
}

/// Which quarter of the face the ray crosses. from: as for exit_of.
template <class T>
ENFILADE_HD std::uint32_t quarter_left_by(const RopeRay<T>& r, const accel::RopeCube& cube, const T* from,
                                          std::uint32_t face) {
    const T half = static_cast<T>(cube.width) / 2;
    T middle[3];
    for (int k = 0; k < 3; ++k)
        middle[k] = k == accel::axis_of(face) ? from[k] : from[k] + ((r.octant >> k & 1u) != 0 ? half : -half);
    return quarter_of(face, plucker_signs(r.direction, middle));
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
