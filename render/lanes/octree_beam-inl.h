// The beam that sixteen rays make: four planes with all of them on one side, against a register of triangles. Most
// triangles of a leaf that neighbours meet are met by none of them.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Along kx and ky, by what is seen along kz: x - slope z is at most (at least) `bound` on all of each ray from its
/// origin on.
class PacketBeam {
public:
    /// Of the rays of a group: they share kz and its sign. Those that look back behind their origins have none.
    HWY_INLINE PacketBeam(const accel::OctreeView& tree, const PacketRays& rays, Bits group) {
        using F = Floats<16>;
        is_known_ = (is_less(load<16>(rays.near), F(0)) & group) == 0;
        if (!is_known_) return;
        // Rounding moves neither a corner nor a ray by as much: its unit is 2^-24 of the largest number.
        const float margin = 0x1p-19f * largest_number(tree);
        const std::uint32_t one = first_bit(group);
        const F along = load<16>(rays.origin[rays.kz]);
        is_up_ = rays.direction[rays.kz][one] > 0;
        const bool is_eye =
            (same(rays.origin[0], one) & same(rays.origin[1], one) & same(rays.origin[2], one) & group) == group;
        const auto least_of = [&](const F& a) HWY_ATTR { return least_lane(choose(group, a, F(endless))); };
        const auto most_of = [&](const F& a) HWY_ATTR { return largest_lane(choose(group, a, F(-endless))); };
        const auto plane = [&](int axis, const float* shear, bool is_most, int i) HWY_ATTR {
            const float slope = is_most ? most_of(load<16>(shear)) : least_of(load<16>(shear));
            const bool is_high = is_most == is_up_;
            slope_[i] = slope;
            if (is_eye) {
                bound_[i] = rays.origin[axis][one] - slope * rays.origin[rays.kz][one];
            } else {
                const F at = load<16>(rays.origin[axis]) - F(slope) * along;
                bound_[i] = is_high ? most_of(at) : least_of(at);
            }
            bound_[i] += is_high ? margin : -margin;
        };
        plane(rays.kx, rays.shear_x, true, 0);
        plane(rays.kx, rays.shear_x, false, 1);
        plane(rays.ky, rays.shear_y, true, 2);
        plane(rays.ky, rays.shear_y, false, 3);
    }

    [[nodiscard]] HWY_INLINE bool is_known() const { return is_known_; }

    /// The triangles of a register that are not wholly outside of one plane.
    [[nodiscard]] HWY_INLINE Bits may_meet(const PacketCorners& p) const {
        const auto x = outside(p.ax, p.bx, p.cx, p, 0), y = outside(p.ay, p.by, p.cy, p, 2);
        return ~bits_of(hn::Or(x, y)) & all_bits<lane_count>;
    }

private:
    static constexpr float endless = std::numeric_limits<float>::max();

    /// Of corners and origins: these are near (near_ray.h).
    static HWY_INLINE float largest_number(const accel::OctreeView& tree) {
        float corner = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            corner = larger(corner, larger(magnitude(tree.low[k]), magnitude(tree.high[k])));
            size = larger(size, tree.high[k] - tree.low[k]);
        }
        return corner + near_enough * size;
    }

    /// The lanes that are as lane `one`.
    static HWY_INLINE Bits same(const float* lanes, std::uint32_t one) {
        return is_equal(load<16>(lanes), Floats<16>(lanes[one]));
    }

    [[nodiscard]] HWY_INLINE hn::Mask<D> outside(V a, V b, V c, const PacketCorners& p, int i) const {
        const D d;
        const V most = hn::Set(d, slope_[i]), least = hn::Set(d, slope_[i + 1]);
        const V a0 = hn::NegMulAdd(most, p.az, a), a1 = hn::NegMulAdd(least, p.az, a);
        const V b0 = hn::NegMulAdd(most, p.bz, b), b1 = hn::NegMulAdd(least, p.bz, b);
        const V c0 = hn::NegMulAdd(most, p.cz, c), c1 = hn::NegMulAdd(least, p.cz, c);
        const V high = hn::Set(d, bound_[is_up_ ? i : i + 1]), low = hn::Set(d, bound_[is_up_ ? i + 1 : i]);
        const V of_high = is_up_ ? hn::Min(a0, hn::Min(b0, c0)) : hn::Min(a1, hn::Min(b1, c1));
        const V of_low = is_up_ ? hn::Max(a1, hn::Max(b1, c1)) : hn::Max(a0, hn::Max(b0, c0));
        return hn::Or(hn::Gt(of_high, high), hn::Lt(of_low, low));
    }

    float slope_[4], bound_[4];  ///< kx most and least, ky most and least
    bool is_known_, is_up_ = true;
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
