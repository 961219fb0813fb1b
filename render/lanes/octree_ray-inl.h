// What walks of one ray share: its shear and its place in registers, and a leaf's triangles a register at a time.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// One ray's shear in all lanes, and which columns it calls x, y and z (triangle_test.h).
struct ShearedLanes {
    V shear_x, shear_y, shear_z, x, y, z;
    std::size_t kx, ky, kz;

    HWY_INLINE explicit ShearedLanes(const ObjectRay& ray) {
        const D d;
        const float *origin = &ray.origin_x, *direction = &ray.direction_x;
        const float ax = magnitude(direction[0]), ay = magnitude(direction[1]), az = magnitude(direction[2]);
        const std::size_t is_z = static_cast<std::size_t>(az >= ax) & static_cast<std::size_t>(az >= ay);
        kz = is_z << 1 | (~is_z & static_cast<std::size_t>(ay >= ax));
        kx = 9u >> 2 * kz & 3u;   // 1, 2, 0
        ky = 18u >> 2 * kz & 3u;  // 2, 0, 1
        const float along = 1.0f / direction[kz];
        shear_x = hn::Set(d, direction[kx] * along);
        shear_y = hn::Set(d, direction[ky] * along);
        shear_z = hn::Set(d, along);
        x = hn::Set(d, origin[kx]);
        y = hn::Set(d, origin[ky]);
        z = hn::Set(d, origin[kz]);
    }
};

/// What the edges say of a register of triangles.
struct EdgeLanes {
    V u, v, w;
};

/// meets_triangle's edges again in double, in the lanes where one of them is 0.
HWY_NOINLINE EdgeLanes edges_in_double(const V* HWY_RESTRICT corners, EdgeLanes edges, Bits zero) {
    alignas(64) float c[6][16], e[3][16];
    const D d;
    for (int k = 0; k < 6; ++k) hn::Store(corners[k], d, c[k]);
    hn::Store(edges.u, d, e[0]);
    hn::Store(edges.v, d, e[1]);
    hn::Store(edges.w, d, e[2]);
    for (; zero != 0; zero &= zero - 1) {
        const int i = __builtin_ctz(zero);
        const double ax = c[0][i], ay = c[1][i], bx = c[2][i], by = c[3][i], cx = c[4][i], cy = c[5][i];
        e[0][i] = static_cast<float>(cx * by - cy * bx);
        e[1][i] = static_cast<float>(ax * cy - ay * cx);
        e[2][i] = static_cast<float>(bx * ay - by * ax);
    }
    return {hn::Load(d, e[0]), hn::Load(d, e[1]), hn::Load(d, e[2])};
}

/// The nearest so far: which triangle of which leaf, and at what distance.
struct NearestInLeaf {
    float t;
    std::uint32_t number;  ///< of the triangle in its mesh
    std::uint32_t first, count, place;
};

/// meets_leaf in lanes: the same numbers by the same operations. Returns whether one was met that is nearer.
template <bool any>
HWY_INLINE bool leaf_met(const float* HWY_RESTRICT corners, std::uint32_t first, std::uint32_t count,
                         const ShearedLanes& s, float near, NearestInLeaf& best) {
    const D d;
    const float* HWY_RESTRICT at = corners + first;
    const std::size_t n = count;
    const float *column_x = at + n * s.kx, *column_y = at + n * s.ky, *column_z = at + n * s.kz;
    bool is_met = false;
    for (std::size_t i = 0; i < n; i += lane_count) {
        const V a_along = hn::Sub(hn::LoadU(d, column_z + i), s.z);
        const V b_along = hn::Sub(hn::LoadU(d, column_z + 3 * n + i), s.z);
        const V c_along = hn::Sub(hn::LoadU(d, column_z + 6 * n + i), s.z);
        const auto across = [&](const float* p, V origin, V shear, V along) HWY_ATTR {
            return hn::Sub(hn::Sub(hn::LoadU(d, p + i), origin), hn::Mul(shear, along));
        };
        const V ax = across(column_x, s.x, s.shear_x, a_along), ay = across(column_y, s.y, s.shear_y, a_along);
        const V bx = across(column_x + 3 * n, s.x, s.shear_x, b_along);
        const V by = across(column_y + 3 * n, s.y, s.shear_y, b_along);
        const V cx = across(column_x + 6 * n, s.x, s.shear_x, c_along);
        const V cy = across(column_y + 6 * n, s.y, s.shear_y, c_along);
        EdgeLanes e = {hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx)), hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx)),
                       hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax))};
        const V zero = hn::Zero(d);
        const std::size_t left = n - i < lane_count ? n - i : lane_count;
        const Bits inside = all_bits<32> >> (32 - left);
        const auto some_zero = hn::Or(hn::Eq(e.u, zero), hn::Or(hn::Eq(e.v, zero), hn::Eq(e.w, zero)));
        if (const Bits bits = bits_of(some_zero) & inside; HWY_UNLIKELY(bits != 0)) {
            const V across_all[6] = {ax, ay, bx, by, cx, cy};
            e = edges_in_double(across_all, e, bits);
        }
        const V least = hn::Min(e.u, hn::Min(e.v, e.w)), most = hn::Max(e.u, hn::Max(e.v, e.w));
        Bits bits = inside & ~bits_of(hn::And(hn::Lt(least, zero), hn::Gt(most, zero)));
        if (bits == 0) continue;
        const V sum = hn::Add(hn::Add(e.u, e.v), e.w);
        const V along = hn::Add(hn::Add(hn::Mul(e.u, a_along), hn::Mul(e.v, b_along)), hn::Mul(e.w, c_along));
        const V t = hn::Div(hn::Mul(s.shear_z, along), sum);
        bits &= bits_of(hn::And(hn::Or(hn::Lt(sum, zero), hn::Gt(sum, zero)),
                                hn::And(hn::Ge(t, hn::Set(d, near)), hn::Le(t, hn::Set(d, best.t)))));
        alignas(64) float ts[16];
        if (bits != 0) hn::Store(t, d, ts);
        for (; bits != 0; bits &= bits - 1) {
            const auto place = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(__builtin_ctz(bits));
            const float here = ts[place - i];
            const std::uint32_t number = render::bits_of(at[9 * n + place]);
            if (!(here < best.t || (here == best.t && number < best.number))) continue;
            if (any) return true;
            best = {here, number, first, count, place};
            is_met = true;
        }
    }
    return is_met;
}

using D4 = hn::FixedTag<float, 4>;
using V4 = hn::Vec<D4>;

/// x, y, z of four lanes turned in a ring: the least and the largest of three, in each of them.
struct Ring {
    hn::Indices128<float> next, last;
    HWY_INLINE Ring() {
        alignas(16) static constexpr std::int32_t yzx[4] = {1, 2, 0, 3}, zxy[4] = {2, 0, 1, 3};
        next = hn::SetTableIndices(D4(), yzx);
        last = hn::SetTableIndices(D4(), zxy);
    }
    HWY_INLINE V4 least(V4 v) const {
        return hn::Min(hn::Min(v, hn::TableLookupLanes(v, next)), hn::TableLookupLanes(v, last));
    }
    HWY_INLINE V4 largest(V4 v) const {
        return hn::Max(hn::Max(v, hn::TableLookupLanes(v, next)), hn::TableLookupLanes(v, last));
    }
};

/// One by one: rays were just written so, and a load of all would wait for that.
HWY_INLINE V4 three(float x, float y, float z) {
#if HWY_ARCH_X86
    return V4{_mm_setr_ps(x, y, z, 0.0f)};
#else
    alignas(16) const float all[4] = {x, y, z, 0.0f};
    return hn::Load(D4(), all);
#endif
}

/// A bit each lane.
HWY_INLINE Bits bits_of_4(hn::Mask<D4> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(D4(), mask, bytes);
    return bytes[0];
}

/// As bring_near, in lanes: whether it would move the ray.
HWY_INLINE bool is_far(const accel::LatticeBox& box, const ObjectRay& ray) {
    const D4 d4;
    const Ring ring;
    const V4 low = hn::Load(d4, box.low), high = hn::Load(d4, box.high),
             origin = three(ray.origin_x, ray.origin_y, ray.origin_z);
    const V4 away = ring.largest(hn::Max(hn::Max(hn::Sub(low, origin), hn::Sub(origin, high)), hn::Zero(d4)));
    return hn::GetLane(away) > near_enough * box.size;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
