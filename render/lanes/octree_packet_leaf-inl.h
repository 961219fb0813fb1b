// The triangles of a leaf and sixteen rays: triangle_test.h in lanes, of rays for a triangle or of triangles for a ray.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Rays, or one in all lanes, along kx, ky and kz.
struct PacketShear {
    V ox, oy, oz, sx, sy, sz;
};

/// Corners likewise.
struct PacketCorners {
    V ax, ay, az, bx, by, bz, cx, cy, cz;
};

/// As in meets_triangle.
struct PacketEdges {
    V u, v, w, a_along, b_along, c_along;
};

HWY_INLINE hn::Mask<D> is_negative(V a) { return hn::RebindMask(D(), hn::Lt(hn::BitCast(DI(), a), hn::Zero(DI()))); }

/// Lanes that pass the three edges on one side. `unclear`: where a product vanishes, so that doubles decide.
HWY_INLINE hn::Mask<D> pass_edges(const PacketShear& r, const PacketCorners& p, PacketEdges& e, hn::Mask<D>& unclear) {
    e.a_along = hn::Sub(p.az, r.oz);
    e.b_along = hn::Sub(p.bz, r.oz);
    e.c_along = hn::Sub(p.cz, r.oz);
    const V ax = hn::Sub(hn::Sub(p.ax, r.ox), hn::Mul(r.sx, e.a_along));
    const V ay = hn::Sub(hn::Sub(p.ay, r.oy), hn::Mul(r.sy, e.a_along));
    const V bx = hn::Sub(hn::Sub(p.bx, r.ox), hn::Mul(r.sx, e.b_along));
    const V by = hn::Sub(hn::Sub(p.by, r.oy), hn::Mul(r.sy, e.b_along));
    const V cx = hn::Sub(hn::Sub(p.cx, r.ox), hn::Mul(r.sx, e.c_along));
    const V cy = hn::Sub(hn::Sub(p.cy, r.oy), hn::Mul(r.sy, e.c_along));
    e.u = hn::Sub(hn::Mul(cx, by), hn::Mul(cy, bx));
    e.v = hn::Sub(hn::Mul(ax, cy), hn::Mul(ay, cx));
    e.w = hn::Sub(hn::Mul(bx, ay), hn::Mul(by, ax));
    const V zero = hn::Zero(D());
    unclear = hn::Or(hn::Or(hn::Eq(e.u, zero), hn::Eq(e.v, zero)), hn::Eq(e.w, zero));
    return hn::Not(hn::Or(unclear, is_negative(hn::Or(hn::Xor(e.u, e.v), hn::Xor(e.v, e.w)))));
}

/// Of the unclear lanes those that doubles could still let in: no two products are plainly of different signs.
HWY_INLINE Bits still_unclear(const PacketEdges& e, hn::Mask<D> unclear) {
    const V plain = hn::Set(D(), 1e-30f);  // smaller ones may vanish where doubles become floats
    const auto below = hn::Lt(hn::Min(e.u, hn::Min(e.v, e.w)), hn::Neg(plain));
    const auto above = hn::Gt(hn::Max(e.u, hn::Max(e.v, e.w)), plain);
    return bits_of(hn::AndNot(hn::And(below, above), unclear));
}

/// The parameters of the meetings, and the sums of shares.
HWY_INLINE V parameter_of(const PacketShear& r, const PacketEdges& e, V& sum) {
    sum = hn::Add(hn::Add(e.u, e.v), e.w);
    const V along = hn::Add(hn::Add(hn::Mul(e.u, e.a_along), hn::Mul(e.v, e.b_along)), hn::Mul(e.w, e.c_along));
    return hn::Div(hn::Mul(r.sz, along), sum);
}

/// Where a leaf's triangles are.
struct LeafTriangles {
    std::uint32_t first, count;
};

/// Where the columns of a leaf's triangles lie, along kx, ky and kz.
struct LeafColumns {
    const float* at;
    std::size_t x, y, z, corner;  ///< steps from `at` to the first corner's coordinates, and from corner to corner
    HWY_INLINE LeafColumns(const accel::OctreeView& tree, const LeafTriangles& leaf, const PacketRays& rays)
        : at(tree.corners + leaf.first) {
        const std::size_t n = leaf.count;
        x = static_cast<std::size_t>(rays.kx) * n;
        y = static_cast<std::size_t>(rays.ky) * n;
        z = static_cast<std::size_t>(rays.kz) * n;
        corner = 3 * n;
    }
    [[nodiscard]] HWY_INLINE PacketCorners one(std::size_t i) const {
        const float *a = at + i, *b = a + corner, *c = b + corner;
        const D d;
        return {hn::Set(d, a[x]), hn::Set(d, a[y]), hn::Set(d, a[z]), hn::Set(d, b[x]), hn::Set(d, b[y]),
                hn::Set(d, b[z]), hn::Set(d, c[x]), hn::Set(d, c[y]), hn::Set(d, c[z])};
    }
    [[nodiscard]] HWY_INLINE PacketCorners many(std::size_t i) const {
        const float *a = at + i, *b = a + corner, *c = b + corner;
        const D d;
        return {hn::LoadU(d, a + x), hn::LoadU(d, a + y), hn::LoadU(d, a + z), hn::LoadU(d, b + x), hn::LoadU(d, b + y),
                hn::LoadU(d, b + z), hn::LoadU(d, c + x), hn::LoadU(d, c + y), hn::LoadU(d, c + z)};
    }
};

/// Whether a meeting counts for a ray: near enough, and before what it met so far.
HWY_INLINE bool is_nearer(const PacketRays& rays, int lane, float t, std::uint32_t number) {
    return t >= rays.near[lane] && (t < rays.far[lane] || (t == rays.far[lane] && number < rays.triangle[lane]));
}

HWY_INLINE void take_meeting(PacketRays& rays, int lane, const LeafTriangles& leaf, std::uint32_t i,
                             std::uint32_t number, const TriangleMeeting& at) {
    rays.far[lane] = at.t;
    rays.triangle[lane] = number;
    rays.b[lane] = at.b;
    rays.c[lane] = at.c;
    rays.sum[lane] = at.sum;
    rays.place[lane] = leaf.first + i;
    rays.step[lane] = leaf.count;
}

/// One ray, one triangle, as the scalar walk asks: where lanes do not decide.
HWY_NOINLINE inline void meet_alone(const accel::OctreeView& tree, const LeafTriangles& leaf, std::uint32_t i, int lane,
                                    PacketRays& rays) {
    const ShearedRay ray = {
        rays.kx,
        rays.ky,
        rays.kz,
        rays.shear_x[lane],
        rays.shear_y[lane],
        rays.shear_z[lane],
        {rays.origin[0][lane], rays.origin[1][lane], rays.origin[2][lane]},
    };
    accel::LinkedLeaf at = {};
    at.first = leaf.first;
    at.count = leaf.count;
    const LeafTriangle triangle = triangle_in(tree, at, i);
    TriangleMeeting meeting = {};
    if (meets_triangle(ray, {triangle.a, triangle.b, triangle.c}, meeting) &&
        is_nearer(rays, lane, meeting.t, triangle.number))
        take_meeting(rays, lane, leaf, i, triangle.number, meeting);
}

/// Those of a register of rays that meet a triangle, its place and their parameters, if it is nearer than what they
/// have.
HWY_INLINE void take_meetings(const PacketShear& r, const PacketEdges& e, hn::Mask<D> met, const LeafTriangles& leaf,
                              const LeafColumns& columns, std::uint32_t i, int k, PacketRays& rays) {
    const D d;
    V sum;
    const V t = parameter_of(r, e, sum), far = hn::Load(d, rays.far + k);
    const std::uint32_t number = render::bits_of(columns.at[9 * std::size_t{leaf.count} + i]);
    auto nearer = hn::Lt(t, far);
    const auto same = hn::And(met, hn::Eq(t, far));
    if (HWY_UNLIKELY(!hn::AllFalse(d, same))) {
        const auto before = hn::Gt(hn::Load(DU(), rays.triangle + k), hn::Set(DU(), number));
        nearer = hn::Or(nearer, hn::And(same, hn::RebindMask(d, before)));
    }
    const auto taken = hn::And(hn::And(met, nearer), hn::Ge(t, hn::Load(d, rays.near + k)));
    if (hn::AllFalse(d, taken)) return;
    const auto whole = [&](std::uint32_t a, std::uint32_t* at) HWY_ATTR {
        hn::BlendedStore(hn::BitCast(d, hn::Set(DU(), a)), taken, d, reinterpret_cast<float*>(at) + k);
    };
    hn::BlendedStore(t, taken, d, rays.far + k);
    hn::BlendedStore(e.v, taken, d, rays.b + k);
    hn::BlendedStore(e.w, taken, d, rays.c + k);
    hn::BlendedStore(sum, taken, d, rays.sum + k);
    whole(number, rays.triangle);
    whole(leaf.first + i, rays.place);
    whole(leaf.count, rays.step);
}

/// The triangles of `which`, numbered from `first` in their leaf, each against registers of rays: those of `active`.
HWY_INLINE void meet_by_triangles(const accel::OctreeView& tree, const LeafTriangles& leaf, const LeafColumns& columns,
                                  std::uint32_t first, Bits which, Bits active, PacketRays& rays) {
    const D d;
    for (int k = 0; k < PacketRays::count; k += lane_count) {
        if ((active >> k & all_bits<lane_count>) == 0) continue;
        const auto asked = mask_of(active, k / lane_count);
        const PacketShear r = {hn::Load(d, rays.origin[rays.kx] + k), hn::Load(d, rays.origin[rays.ky] + k),
                               hn::Load(d, rays.origin[rays.kz] + k), hn::Load(d, rays.shear_x + k),
                               hn::Load(d, rays.shear_y + k),         hn::Load(d, rays.shear_z + k)};
        for (Bits triangles = which; triangles != 0; triangles &= triangles - 1) {
            const std::uint32_t i = first + first_bit(triangles);
            PacketEdges e;
            hn::Mask<D> unclear;
            const auto met = hn::And(asked, pass_edges(r, columns.one(i), e, unclear));
            unclear = hn::And(asked, unclear);
            if (HWY_UNLIKELY(!hn::AllFalse(d, unclear)))
                for (Bits left = still_unclear(e, unclear); left != 0; left &= left - 1)
                    meet_alone(tree, leaf, i, k + static_cast<int>(first_bit(left)), rays);
            if (!hn::AllFalse(d, met)) take_meetings(r, e, met, leaf, columns, i, k, rays);
        }
    }
}

/// A ray against those registers of triangles that hold some of `which`, numbered from `first` in their leaf.
HWY_INLINE void meet_by_ray(const accel::OctreeView& tree, const LeafTriangles& leaf, const LeafColumns& columns,
                            std::uint32_t first, Bits which, int lane, PacketRays& rays) {
    const D d;
    const PacketShear r = {hn::Set(d, rays.origin[rays.kx][lane]), hn::Set(d, rays.origin[rays.ky][lane]),
                           hn::Set(d, rays.origin[rays.kz][lane]), hn::Set(d, rays.shear_x[lane]),
                           hn::Set(d, rays.shear_y[lane]),         hn::Set(d, rays.shear_z[lane])};
    for (std::uint32_t i = first; which != 0; i += lane_count, which = which >> (lane_count - 1) >> 1) {
        const Bits here = which & all_bits<lane_count>;
        if (here == 0) continue;
        PacketEdges e;
        hn::Mask<D> unclear;
        const auto met = pass_edges(r, columns.many(i), e, unclear);
        if (HWY_UNLIKELY((bits_of(unclear) & here) != 0))
            for (Bits some = still_unclear(e, unclear) & here; some != 0; some &= some - 1)
                meet_alone(tree, leaf, i + first_bit(some), lane, rays);
        Bits some = bits_of(met) & here;
        if (some == 0) continue;
        V sum;
        const V t = parameter_of(r, e, sum);
        alignas(64) float ts[lane_count], bs[lane_count], cs[lane_count], sums[lane_count];
        hn::Store(t, d, ts);
        hn::Store(e.v, d, bs);
        hn::Store(e.w, d, cs);
        hn::Store(sum, d, sums);
        for (; some != 0; some &= some - 1) {
            const auto j = first_bit(some);
            const std::uint32_t number = render::bits_of(columns.at[9 * std::size_t{leaf.count} + i + j]);
            if (is_nearer(rays, lane, ts[j], number))
                take_meeting(rays, lane, leaf, i + j, number, {bs[j], cs[j], sums[j], ts[j]});
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
