// Sixteen rays that go through an octree: how they are taken from who asks, and what they found is written.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

HWY_INLINE std::uint32_t first_bit(Bits bits) {
    return static_cast<std::uint32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
}

/// Sixteen rays as triangles are asked, and what was found for them so far.
struct alignas(64) PacketRays {
    static constexpr int count = ObjectRays::count;
    float origin[3][count], direction[3][count];  ///< near the mesh
    float near[count], far[count];
    float shear_x[count], shear_y[count], shear_z[count];  ///< of those for which kz is right
    std::uint32_t triangle[count];
    float b[count], c[count], sum[count];     ///< as TriangleMeeting
    std::uint32_t place[count], step[count];  ///< of its corners: of the first number, and from each to the next
    int kx, ky, kz;
    float moved[count];  ///< how far origins were brought near, if any was
    bool is_any_moved;

    PacketRays() {}  // lanes are written where they count
};

/// Origins that are far are brought near, one by one: they are few, or none.
HWY_NOINLINE inline void bring_packet_near(const accel::OctreeView& tree, Bits some, PacketRays& rays) {
    for (Bits left = some; left != 0; left &= left - 1) {
        const auto i = first_bit(left);
        ObjectRay ray = {};
        ray.origin_x = rays.origin[0][i];
        ray.origin_y = rays.origin[1][i];
        ray.origin_z = rays.origin[2][i];
        ray.direction_x = rays.direction[0][i];
        ray.direction_y = rays.direction[1][i];
        ray.direction_z = rays.direction[2][i];
        ray.near = rays.near[i];
        ray.far = rays.far[i];
        rays.moved[i] = bring_near(tree.low, tree.high, ray);
        rays.origin[0][i] = ray.origin_x;
        rays.origin[1][i] = ray.origin_y;
        rays.origin[2][i] = ray.origin_z;
        rays.near[i] = ray.near;
        rays.far[i] = ray.far;
    }
}

/// Those of the rays that start far from the mesh, as bring_near counts it.
HWY_INLINE Bits far_away(const accel::OctreeView& tree, const PacketRays& rays) {
    using F = Floats<16>;
    F away(0);
    float size = 0;
    for (int k = 0; k < 3; ++k) {
        const F o = load<16>(rays.origin[k]);
        size = larger(size, tree.high[k] - tree.low[k]);
        away = largest(away, largest(F(tree.low[k]) - o, o - F(tree.high[k])));
    }
    return is_less(F(near_enough * size), away);
}

/// Those whose directions are too long or too short for walks (octree_walk.h).
HWY_INLINE Bits extreme_rays(const accel::OctreeView& tree, const PacketRays& rays) {
    using F = Floats<16>;
    F longest(0);
    for (int k = 0; k < 3; ++k)
        longest = largest(longest, magnitude_of(load<16>(rays.direction[k]) * F(tree.box.cells_a_unit[k])));
    return ~(is_at_most(F(1 / extreme_direction), longest) & is_at_most(longest, F(extreme_direction)));
}

/// Takes the rays, each near the mesh. Returns those that are valid and have a part that counts; those that sixteen
/// cannot take together are answered here.
HWY_INLINE Bits take_rays(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays,
                          PacketRays& asked) {
    using F = Floats<16>;
    Bits some = 0;
    const float* const from[8] = {rays.origin_x,    rays.origin_y,    rays.origin_z, rays.direction_x,
                                  rays.direction_y, rays.direction_z, rays.near,     rays.far};
    float* const to[8] = {asked.origin[0],    asked.origin[1],    asked.origin[2], asked.direction[0],
                          asked.direction[1], asked.direction[2], asked.near,      asked.far};
    for (int i = 0; i < 8; ++i) store(load<16>(from[i]), to[i]);
    for (int k = 0; k < 16; k += lane_count) {
        const auto numbers = hn::LoadU(DU(), rays.triangle + k);
        hn::Store(numbers, DU(), asked.triangle + k);
        const auto is_valid = hn::Ne(hn::LoadU(DI(), valid + k), hn::Zero(DI()));
        some |= bits_of(hn::RebindMask(D(), is_valid)) << k;
    }
    const Bits away = some & far_away(tree, asked);
    asked.is_any_moved = away != 0;
    if (HWY_UNLIKELY(asked.is_any_moved)) {
        store(F(0), asked.moved);
        bring_packet_near(tree, away, asked);
    }
    some &= is_at_most(load<16>(asked.near), load<16>(asked.far));
    const Bits alone = some & extreme_rays(tree, asked);
    for (Bits left = alone; HWY_UNLIKELY(left != 0); left &= left - 1) {
        const auto i = static_cast<int>(first_bit(left));
        ObjectRay ray = ray_of(rays, i);
        if (octree_nearest(tree, ray)) write_hit(ray, i, rays);
    }
    return some & ~alone;
}

/// Writes what was found for those of `some` that did not have it before.
HWY_INLINE void write_hits(const accel::OctreeView& tree, Bits some, const PacketRays& asked, ObjectRays& rays) {
    using F = Floats<16>;
    Bits hit = 0;
    for (int k = 0; k < 16; k += lane_count)
        hit |=
            bits_of(hn::RebindMask(D(), hn::Ne(hn::Load(DU(), asked.triangle + k), hn::LoadU(DU(), rays.triangle + k))))
            << k;
    hit &= some;
    if (hit == 0) return;
    const F sum = load<16>(asked.sum);
    const F far = load<16>(asked.far) + (asked.is_any_moved ? load<16>(asked.moved) : F(0));  // -0 + 0: +0
    const auto write = [&](const F& lanes, float* at) HWY_ATTR {
        for (int k = 0; k < 16; k += lane_count)
            hn::BlendedStore(lanes.v[k / lane_count], mask_of(hit, k / lane_count), D(), at + k);
    };
    write(far, rays.far);
    write(load<16>(asked.b) / sum, rays.u);
    write(load<16>(asked.c) / sum, rays.v);
    write(load<16>(reinterpret_cast<const float*>(asked.triangle)), reinterpret_cast<float*>(rays.triangle));
    for (Bits left = hit; left != 0; left &= left - 1) {
        const auto i = first_bit(left);
        const float* const at = tree.corners + asked.place[i];
        const std::size_t n = asked.step[i];
        const float ax = at[0], ay = at[n], az = at[2 * n];
        const Vec3f normal = cross(Vec3f{at[3 * n] - ax, at[4 * n] - ay, at[5 * n] - az},
                                   Vec3f{at[6 * n] - ax, at[7 * n] - ay, at[8 * n] - az});
        rays.normal_x[i] = normal.x;
        rays.normal_y[i] = normal.y;
        rays.normal_z[i] = normal.z;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
