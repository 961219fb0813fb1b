// One ray through an octree, a register of triangles at a time.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// One ray's shear in all lanes (triangle_test.h).
struct ShearedLanes {
    V shear_x, shear_y, shear_z, x, y, z;

    HWY_INLINE explicit ShearedLanes(const ShearedRay& r) {
        const D d;
        shear_x = hn::Set(d, r.shear_x);
        shear_y = hn::Set(d, r.shear_y);
        shear_z = hn::Set(d, r.shear_z);
        x = hn::Set(d, r.origin[r.kx]);
        y = hn::Set(d, r.origin[r.ky]);
        z = hn::Set(d, r.origin[r.kz]);
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
                         const ShearedRay& r, const ShearedLanes& s, float near, NearestInLeaf& best) {
    const D d;
    const float* HWY_RESTRICT at = corners + first;
    const std::size_t n = count;
    const float *column_x = at + n * r.kx, *column_y = at + n * r.ky, *column_z = at + n * r.kz;
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
        const Bits inside = n - i < lane_count ? (1u << (n - i)) - 1 : all_bits<lane_count>;
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

/// octree_walk in lanes: the same leaves, the same answers.
template <bool any>
HWY_INLINE bool ray_walk(const accel::OctreeView& tree, const ObjectRay& ray, ObjectRay* answer) {
    if (tree.leaves == nullptr || !(ray.near <= ray.far)) return false;
    ObjectRay asked = ray;
    const float moved = bring_near(tree.low, tree.high, asked);
    const LatticeRay r = lattice_ray(tree.frame, asked);
    float enter = asked.near, leave = asked.far;
    if (!part_in_box(tree, r, enter, leave)) return false;
    const ShearedRay sheared = sheared_ray(asked);
    const ShearedLanes lanes(sheared);
    NearestInLeaf best = {asked.far, ray.triangle, 0, 0, 0};
    LatticeCell cell;
    for (int k = 0; k < 3; ++k) cell.at[k] = within(r.origin[k] + enter * r.direction[k], 0.0f, tree.frame.side());
    accel::OctreeEntry from = tree.root;
    std::uint32_t level = 0;
    NoOctreeEvents events;
    while (true) {
        const accel::LinkedLeaf& leaf = tree.leaves[leaf_at(tree, from, level, cell, events)];
        if (leaf_met<any>(tree.corners, leaf.first, leaf.count, sheared, lanes, asked.near, best) && any) return true;
        const BoxExit exit = exit_of(leaf, r);
        if (exit.axis < 0 || !(exit.t < best.t) || exit.t > leave) break;
        const int face = 2 * exit.axis + (r.inverse[exit.axis] > 0 ? 1 : 0);
        if (leaf.rope_level[face] == accel::no_neighbour) break;
        step(leaf, r, exit, cell);
        from = leaf.rope[face];
        level = leaf.rope_level[face];
    }
    if (best.number == ray.triangle) return false;
    accel::LinkedLeaf of = {};
    of.first = best.first;
    of.count = best.count;
    const LeafTriangle triangle = triangle_in(tree, of, best.place);
    const TriangleAt at = {triangle.a, triangle.b, triangle.c};
    TriangleMeeting meeting = {};
    meets_triangle(sheared, at, meeting);
    answer->far = best.t + moved;
    answer->triangle = best.number;
    describe_meeting(at, meeting, *answer);
    return true;
}

bool octree_nearest(const accel::OctreeView& tree, ObjectRay& ray) { return ray_walk<false>(tree, ray, &ray); }

bool octree_blocked(const accel::OctreeView& tree, const ObjectRay& ray) { return ray_walk<true>(tree, ray, nullptr); }

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
