// Sixteen rays through an octree together: from the root down, nearest children first, each node for those rays that
// pass it; the planes between a node's eighths are all that is computed of boxes.
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Parameters of planes: (plane - origin) / direction, in the lattice. As good as parallel is as parallel as can be
/// counted: all of the ray is on one side.
struct PacketPlanes {
    Floats<16> inverse[3], offset[3];
    [[nodiscard]] HWY_INLINE Floats<16> at(int axis, float plane) const {
        return fused_lanes(Floats<16>(plane), inverse[axis], offset[axis]);
    }
};

/// Where a packet is on its way down.
struct PacketPlace {
    accel::OctreeEntry entry;
    float low[3], half;  ///< of the node's box, in the lattice
    Bits rays;           ///< those that pass it
    Floats<16> enter, leave;

    HWY_INLINE void go_down(const accel::OctreeEntry* children, std::uint32_t octant) {
        entry = children[octant];
        for (int k = 0; k < 3; ++k) low[k] += (octant >> k & 1u) != 0 ? half : 0.0f;
        half *= 0.5f;
    }
};

/// A node whose eighths are asked one after the other. They are counted in the order in which rays pass them: bit k of
/// the order is set behind the plane that halves axis k.
struct alignas(64) PacketNode {
    float enter[16], middle[3][16], leave[16];  ///< parameters of the rays
    const accel::OctreeEntry* children;
    float low[3], half;
    Bits left;        ///< eighths to come
    Bits rays_of[8];  ///< which rays pass each
};

/// any: it is enough to meet something; rays that do are done.
template <bool any>
struct PacketWalk {
    static constexpr std::uint32_t few_rays = 1;  ///< for so many each triangle costs less than the beam does

    const accel::OctreeView& tree;
    const PacketPlanes& planes;
    PacketRays& rays;
    const PacketBeam& beam;
    std::uint32_t flip;  ///< bit k: rays come down axis k

    /// The triangles of a leaf that the beam meets, for some rays: whichever takes fewer registers of the two ways.
    HWY_INLINE void meet(const LeafTriangles& leaf, Bits some) {
        constexpr std::uint32_t at_once = 32;
        const LeafColumns columns(tree, leaf, rays);
        const auto count = static_cast<std::uint32_t>(hwy::PopCount(some));
        for (std::uint32_t first = 0; first < leaf.count; first += at_once) {
            const std::uint32_t here = std::min(leaf.count - first, at_once);
            Bits which = ~Bits(0) >> (at_once - here);
            std::uint32_t registers = (here + lane_count - 1) / lane_count;
            if (beam.is_known() && count > few_rays) {
                Bits inside = 0;
                registers = 0;
                for (std::uint32_t i = 0; i < here; i += lane_count) {
                    const Bits bits = beam.may_meet(columns.many(first + i)) & which >> i;
                    inside |= bits << i;
                    registers += bits != 0 ? 1 : 0;
                }
                which &= inside;
                if (which == 0) continue;
            }
            if (registers * count < static_cast<std::uint32_t>(hwy::PopCount(which))) {
                for (Bits left = some; left != 0; left &= left - 1)
                    meet_by_ray(tree, leaf, columns, first, which, static_cast<int>(first_bit(left)), rays);
            } else {
                meet_by_triangles(tree, leaf, columns, first, which, some, rays);
            }
        }
    }

    /// Bits by eighths, in the order in which rays pass them.
    [[nodiscard]] HWY_INLINE Bits in_order(Bits bits) const {
        if ((flip & 1u) != 0) bits = (bits & 0x55u) << 1 | (bits >> 1 & 0x55u);
        if ((flip & 2u) != 0) bits = (bits & 0x33u) << 2 | (bits >> 2 & 0x33u);
        if ((flip & 4u) != 0) bits = (bits & 0x0fu) << 4 | bits >> 4;
        return bits;
    }

    /// Goes down while all rays pass one eighth alone. Returns whether it came to a leaf with triangles (true), or to a
    /// node that is now open, or to nothing (with no eighths left).
    HWY_INLINE bool go_down(PacketPlace& at, PacketNode& node) {
        using F = Floats<16>;
        while (!at.entry.is_leaf()) {
            const std::size_t number = at.entry.number();
            const accel::OctreeEntry* const children = tree.children + 8 * number;
            F middle[3];
            Bits before[3], behind[3];  // which rays pass the half before the plane, and that behind it
            std::uint32_t one_side = 0, order = 0;
            for (std::uint32_t k = 0; k < 3; ++k) {
                middle[k] = planes.at(static_cast<int>(k), at.low[k] + at.half);
                before[k] = at.rays & is_at_most(at.enter, middle[k]);
                behind[k] = at.rays & is_at_most(middle[k], at.leave);
                one_side += before[k] == 0 || behind[k] == 0 ? 1 : 0;
                order |= (before[k] == 0 ? 1u : 0u) << k;
            }
            if (one_side == 3) {
                const std::uint32_t octant = order ^ flip;
                node.left = 0;
                if ((tree.occupied[number] >> octant & 1u) == 0) return false;
                at.go_down(children, octant);
                continue;
            }
            const Bits xy = is_at_most(middle[0], middle[1]), yx = is_at_most(middle[1], middle[0]);
            const Bits xz = is_at_most(middle[0], middle[2]), zx = is_at_most(middle[2], middle[0]);
            const Bits yz = is_at_most(middle[1], middle[2]), zy = is_at_most(middle[2], middle[1]);
            node.rays_of[0] = before[0] & before[1] & before[2];
            node.rays_of[1] = behind[0] & before[1] & before[2] & xy & xz;
            node.rays_of[2] = before[0] & behind[1] & before[2] & yx & yz;
            node.rays_of[3] = behind[0] & behind[1] & before[2] & xz & yz;
            node.rays_of[4] = before[0] & before[1] & behind[2] & zx & zy;
            node.rays_of[5] = behind[0] & before[1] & behind[2] & xy & zy;
            node.rays_of[6] = before[0] & behind[1] & behind[2] & yx & zx;
            node.rays_of[7] = behind[0] & behind[1] & behind[2];
            open(at, children, middle, in_order(tree.occupied[number]), node);
            return false;
        }
        return true;
    }

    HWY_INLINE void open(const PacketPlace& at, const accel::OctreeEntry* children, const Floats<16>* middle,
                         Bits occupied, PacketNode& node) {
        node.children = children;
        for (int k = 0; k < 3; ++k) {
            node.low[k] = at.low[k];
            store(middle[k], node.middle[k]);
        }
        node.half = at.half;
        store(at.enter, node.enter);
        store(at.leave, node.leave);
        Bits passed = 0;
        for (int i = 0; i < 8; ++i) passed |= (node.rays_of[i] != 0 ? 1u : 0u) << i;
        node.left = passed & occupied;
        for (Bits left = node.left; left != 0; left &= left - 1) {
            const accel::OctreeEntry child = children[first_bit(left) ^ flip];
            const void* const next = child.is_leaf()
                                         ? static_cast<const void*>(tree.leaves + child.number())
                                         : static_cast<const void*>(tree.children + std::size_t{8} * child.number());
            hwy::Prefetch(next);
        }
    }

    /// The next eighth of a node with some left; false: no ray passes it before what it met.
    HWY_INLINE bool take_next(PacketNode& node, PacketPlace& at) {
        using F = Floats<16>;
        const std::uint32_t order = first_bit(node.left);
        node.left &= node.left - 1;
        const auto plane = [&](int k)
                               HWY_ATTR { return load<16>((order >> k & 1u) != 0 ? node.middle[k] : node.enter); };
        const auto plane_behind = [&](int k) HWY_ATTR {
            return load<16>((order >> k & 1u) != 0 ? node.leave : node.middle[k]);
        };
        const F far = load<16>(rays.far);
        at.enter = largest(largest(plane(0), plane(1)), plane(2));
        at.rays = node.rays_of[order] & is_at_most(at.enter, far);
        if (at.rays == 0) return false;
        at.leave = least(least(plane_behind(0), plane_behind(1)), least(plane_behind(2), far));
        for (int k = 0; k < 3; ++k) at.low[k] = node.low[k];
        at.half = node.half;
        at.go_down(node.children, order ^ flip);
        return true;
    }

    /// Those that met something have no part left.
    HWY_INLINE void retire(Bits some) {
        const D d;
        for (int k = 0; k < PacketRays::count; k += lane_count) {
            const auto met = hn::RebindMask(d, hn::Ne(hn::Load(DU(), rays.triangle + k), hn::Set(DU(), no_triangle)));
            const auto done = hn::And(met, mask_of(some, k / lane_count));
            hn::BlendedStore(hn::Set(d, -std::numeric_limits<float>::infinity()), done, d, rays.far + k);
        }
    }

    void run(Bits some, const Floats<16>& enter, const Floats<16>& leave) {
        PacketNode nodes[accel::largest_octree_depth + 1];
        PacketNode* node = nodes;
        PacketPlace at = {tree.root, {0, 0, 0}, 0.5f * tree.frame.side(), some, enter, leave};
        while (true) {
            if (go_down(at, *node)) {
                const accel::LinkedLeaf& leaf = tree.leaves[at.entry.number()];
                meet({leaf.first, leaf.count}, at.rays);
                if (any) retire(at.rays);
                node->left = 0;
            }
            do {
                while (node->left == 0) {
                    if (node == nodes) return;
                    --node;
                }
            } while (!take_next(*node, at));
            ++node;
        }
    }
};

/// Those of one octant, longest along one axis, together. negative: [axis] which go down it
template <bool any>
HWY_INLINE void walk_by_groups(const accel::OctreeView& tree, const PacketPlanes& planes, const Bits* negative,
                               Bits some, const Floats<16>& enter, const Floats<16>& leave, PacketRays& asked) {
    using F = Floats<16>;
    const F dx = magnitude_of(load<16>(asked.direction[0])), dy = magnitude_of(load<16>(asked.direction[1])),
            dz = magnitude_of(load<16>(asked.direction[2]));
    const Bits z_longest = is_at_most(dx, dz) & is_at_most(dy, dz);
    const Bits y_longest = is_at_most(dx, dy) & ~z_longest;
    for (Bits left = some; left != 0;) {
        const Bits first = left & (~left + 1);
        Bits group = left;
        std::uint32_t flip = 0;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const bool is_down = (negative[k] & first) != 0;
            group &= is_down ? negative[k] : ~negative[k];
            flip |= (is_down ? 1u : 0u) << k;
        }
        group &= (z_longest & first) != 0 ? z_longest : ~z_longest;
        group &= (y_longest & first) != 0 ? y_longest : ~y_longest;
        left &= ~group;
        asked.kz = (z_longest & first) != 0 ? 2 : (y_longest & first) != 0 ? 1 : 0;
        asked.kx = asked.kz == 2 ? 0 : asked.kz + 1;
        asked.ky = asked.kx == 2 ? 0 : asked.kx + 1;
        const F shear_z = F(1) / load<16>(asked.direction[asked.kz]);
        store(shear_z, asked.shear_z);
        store(load<16>(asked.direction[asked.kx]) * shear_z, asked.shear_x);
        store(load<16>(asked.direction[asked.ky]) * shear_z, asked.shear_y);
        const PacketBeam beam(tree, asked, group);
        PacketWalk<any>{tree, planes, asked, beam, flip}.run(group, enter, leave);
    }
}

/// Returns the rays that were walked; those that sixteen cannot take together are answered in `rays`.
template <bool any>
HWY_INLINE Bits walk_sixteen(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays,
                             PacketRays& asked) {
    using F = Floats<16>;
    if (!tree.root.is_leaf()) {
        hwy::Prefetch(tree.children + std::size_t{8} * tree.root.number());
        hwy::Prefetch(tree.occupied + tree.root.number());
    }
    Bits some = take_rays(tree, valid, rays, asked);
    F enter = load<16>(asked.near), leave = load<16>(asked.far);
    PacketPlanes planes;
    Bits negative[3];
    const float slack = static_cast<float>(accel::octree_slack) * tree.frame.side();
    for (int k = 0; k < 3; ++k) {
        const float scale = tree.frame.cells_a_unit.data()[k], base = tree.frame.low.data()[k];
        F d = load<16>(asked.direction[k]) * F(scale);
        negative[k] = is_less(d, F(0));
        const F tiny(0x1p-100f);
        d = choose(is_less(magnitude_of(d), tiny), choose(negative[k], -tiny, tiny), d);
        planes.inverse[k] = F(1) / d;
        planes.offset[k] = (F(base) - load<16>(asked.origin[k])) * F(scale) * planes.inverse[k];
        const F a = planes.at(k, (tree.low[k] - base) * scale - slack);
        const F b = planes.at(k, (tree.high[k] - base) * scale + slack);
        enter = largest(enter, least(a, b));
        leave = least(leave, largest(a, b));
    }
    some &= is_at_most(enter, leave);
    if (some != 0) walk_by_groups<any>(tree, planes, negative, some, enter, leave, asked);
    return some;
}

void octree_nearest16(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    if (tree.leaves == nullptr) return;
    PacketRays asked;
    const Bits some = walk_sixteen<false>(tree, valid, rays, asked);
    if (some != 0) write_hits(tree, some, asked, rays);
}

/// Which of sixteen triangles are some.
HWY_INLINE Bits with_triangle(const std::uint32_t* triangles) {
    Bits bits = 0;
    for (int k = 0; k < 16; k += lane_count) {
        const auto is_one = hn::Ne(hn::LoadU(DU(), triangles + k), hn::Set(DU(), no_triangle));
        bits |= bits_of(hn::RebindMask(D(), is_one)) << k;
    }
    return bits;
}

std::uint32_t octree_blocked16(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    if (tree.leaves == nullptr) return 0;
    for (int k = 0; k < 16; k += lane_count) hn::StoreU(hn::Set(DU(), no_triangle), DU(), rays.triangle + k);
    PacketRays asked;
    const Bits some = walk_sixteen<true>(tree, valid, rays, asked);
    return static_cast<std::uint32_t>((with_triangle(asked.triangle) & some) | with_triangle(rays.triangle));
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
