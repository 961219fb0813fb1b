#pragma once
// Inside of accel/octree: which eighths of a cube triangles meet, sixteen triangles at a time. Plain loops over plain
// arrays, without branches, that compilers turn into registers; or one by one, by the same functions, on a device.

#include <cmath>
#include <cstdint>

#include "accel/host_device.h"

namespace enfilade::accel::detail {

/// Sixteen triangles about a node's centre.
struct TriangleBlock {
    static constexpr std::uint32_t size = 16;
    float at[3][3][size];  ///< [corner][axis][triangle]
};

[[nodiscard]] ENFILADE_HD float least(float a, float b) { return a < b ? a : b; }
[[nodiscard]] ENFILADE_HD float most(float a, float b) { return a < b ? b : a; }

/// The bits where the condition holds; written so that no branch comes of it.
[[nodiscard]] ENFILADE_HD std::uint32_t bits_where(bool holds, std::uint32_t bits) {
    return (0u - static_cast<std::uint32_t>(holds)) & bits;
}

/// Octants on the sides that a triangle's box reaches along one axis. a, b, c: its corners there
[[nodiscard]] ENFILADE_HD std::uint32_t halves_of_box(float a, float b, float c, int axis, float slack) {
    const std::uint32_t lower = axis == 0 ? 0x55 : axis == 1 ? 0x33 : 0x0f;
    const float low = least(least(a, b), c), high = most(most(a, b), c);
    return bits_where(low <= slack, lower) | bits_where(high >= -slack, lower ^ 0xffu);
}

/// By the triangles' boxes alone: which halves they reach along each axis, as octants. Returns whether all lie in one
/// octant each, so that no more need be asked.
[[nodiscard]] inline bool octants_of_boxes(const TriangleBlock& p, float slack, std::uint32_t* octants) {
    std::uint32_t shared = 0;
    for (std::uint32_t i = 0; i < TriangleBlock::size; ++i) {
        std::uint32_t mask = 0xff;
        for (int k = 0; k < 3; ++k) mask &= halves_of_box(p.at[0][k][i], p.at[1][k][i], p.at[2][k][i], k, slack);
        octants[i] = mask;
        shared |= mask & (mask - 1u);
    }
    return shared == 0;
}

/// A corner seen along one axis.
struct SeenCorner {
    float u, v;
};

/// How far the four squares of a projection lie outside of a triangle, in any unit: 0 or less where they meet.
struct SquareGaps {
    float low_low = -INFINITY, high_low = -INFINITY, low_high = -INFINITY, high_high = -INFINITY;  ///< by u, by v
};

/// One separating axis: the normal of the edge pq, seen along an axis (the cross product of both). Any normal is a true
/// test, whatever rounding did to it, for all three corners are measured along it.
ENFILADE_HD void widen_gaps(SeenCorner p, SeenCorner q, SeenCorner r, float half, float reach, SquareGaps& gaps) {
    const float a = q.v - p.v, b = p.u - q.u;
    const float at_p = a * p.u + b * p.v, at_q = a * q.u + b * q.v, at_r = a * r.u + b * r.v;
    const float outwards = at_r > at_p ? -1.0f : 1.0f;
    const float border =
        most(most(outwards * at_p, outwards * at_q), outwards * at_r) + reach * (std::abs(a) + std::abs(b));
    const float along_u = outwards * half * a, along_v = outwards * half * b;
    const float sum = along_u + along_v, difference = along_u - along_v;
    gaps.low_low = most(gaps.low_low, -sum - border);
    gaps.high_low = most(gaps.high_low, difference - border);
    gaps.low_high = most(gaps.low_high, -difference - border);
    gaps.high_high = most(gaps.high_high, sum - border);
}

[[nodiscard]] ENFILADE_HD SquareGaps square_gaps(SeenCorner p, SeenCorner q, SeenCorner r, float half, float reach) {
    SquareGaps gaps;
    widen_gaps(p, q, r, half, reach, gaps);
    widen_gaps(q, r, p, half, reach, gaps);
    widen_gaps(r, p, q, half, reach, gaps);
    return gaps;
}

/// Octants of squares that are missed: `squares` has them by u, by v.
[[nodiscard]] ENFILADE_HD std::uint32_t missed_squares(const SquareGaps& gaps, std::uint32_t low_low,
                                                       std::uint32_t high_low, std::uint32_t low_high,
                                                       std::uint32_t high_high) {
    return bits_where(gaps.low_low > 0, low_low) | bits_where(gaps.high_low > 0, high_low) |
           bits_where(gaps.low_high > 0, low_high) | bits_where(gaps.high_high > 0, high_high);
}

struct SpaceCorner {
    float x, y, z;
};

/// Octants that the triangle's plane misses: the separating axis along its normal.
[[nodiscard]] ENFILADE_HD std::uint32_t missed_by_plane(SpaceCorner p, SpaceCorner q, SpaceCorner r, float half,
                                                        float reach) {
    const SpaceCorner e = {q.x - p.x, q.y - p.y, q.z - p.z}, f = {r.x - p.x, r.y - p.y, r.z - p.z};
    const SpaceCorner n = {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
    const float at_p = n.x * p.x + n.y * p.y + n.z * p.z, at_q = n.x * q.x + n.y * q.y + n.z * q.z,
                at_r = n.x * r.x + n.y * r.y + n.z * r.z;
    const float wide = reach * (std::abs(n.x) + std::abs(n.y) + std::abs(n.z));
    const float low = least(least(at_p, at_q), at_r) - wide, high = most(most(at_p, at_q), at_r) + wide;
    const float x = n.x * half, y = n.y * half, z = n.z * half;
    const float o3 = x + y + z, o2 = -x + y + z, o1 = x - y + z, o0 = -x - y + z;  // 7, 6, 5, 4; the others opposite
    std::uint32_t missed = bits_where(o3 > high, 0x80u) | bits_where(o3 < low, 0x80u);
    missed |= bits_where(-o3 > high, 0x01u) | bits_where(-o3 < low, 0x01u);
    missed |= bits_where(o2 > high, 0x40u) | bits_where(o2 < low, 0x40u);
    missed |= bits_where(-o2 > high, 0x02u) | bits_where(-o2 < low, 0x02u);
    missed |= bits_where(o1 > high, 0x20u) | bits_where(o1 < low, 0x20u);
    missed |= bits_where(-o1 > high, 0x04u) | bits_where(-o1 < low, 0x04u);
    missed |= bits_where(o0 > high, 0x10u) | bits_where(o0 < low, 0x10u);
    missed |= bits_where(-o0 > high, 0x08u) | bits_where(-o0 < low, 0x08u);
    return missed;
}

/// Octants that a triangle misses. `half`: of an octant's width; `reach`: half plus slack.
[[nodiscard]] ENFILADE_HD std::uint32_t missed_octants(SpaceCorner p, SpaceCorner q, SpaceCorner r, float half,
                                                       float reach) {
    const SquareGaps xy = square_gaps({p.x, p.y}, {q.x, q.y}, {r.x, r.y}, half, reach);
    const SquareGaps yz = square_gaps({p.y, p.z}, {q.y, q.z}, {r.y, r.z}, half, reach);
    const SquareGaps zx = square_gaps({p.z, p.x}, {q.z, q.x}, {r.z, r.x}, half, reach);
    return missed_squares(xy, 0x11, 0x22, 0x44, 0x88) | missed_squares(yz, 0x03, 0x0c, 0x30, 0xc0) |
           missed_squares(zx, 0x05, 0x50, 0x0a, 0xa0) | missed_by_plane(p, q, r, half, reach);
}

/// Takes from `octants` those that triangles miss.
inline void refine_octants(const TriangleBlock& block, float half, float reach, std::uint32_t* octants) {
    for (std::uint32_t i = 0; i < TriangleBlock::size; ++i) {
        const SpaceCorner p = {block.at[0][0][i], block.at[0][1][i], block.at[0][2][i]};
        const SpaceCorner q = {block.at[1][0][i], block.at[1][1][i], block.at[1][2][i]};
        const SpaceCorner r = {block.at[2][0][i], block.at[2][1][i], block.at[2][2][i]};
        octants[i] &= ~missed_octants(p, q, r, half, reach);
    }
}

}  // namespace enfilade::accel::detail
