// One ray through an octree, brick by brick: all 64 cells of a brick against the ray at once, and of those that it
// crosses the full ones in the order in which it comes to them (accel/octree/bricks.h).
// No include guard: octree.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Where the lowest corner of each cell of a brick is, in cells: x, y, z of each bit.
struct BrickCorners {
    alignas(16) float at[64][4];
    constexpr BrickCorners() : at() {
        for (int bit = 0; bit < 64; ++bit) {
            at[bit][0] = static_cast<float>(bit & 3);
            at[bit][1] = static_cast<float>(bit >> 2 & 3);
            at[bit][2] = static_cast<float>(bit >> 4);
        }
    }
};
inline constexpr BrickCorners brick_corners;

/// Of a level of a brick: x and y of its 16 cells.
alignas(64) inline constexpr float level_x[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
alignas(64) inline constexpr float level_y[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

/// A ray in the octree's lattice, mirrored so that it goes up along every axis. Parameters are the ray's own.
struct BrickRay {
    V4 first, step;        ///< where it meets the root's lowest planes, and how far it is from each plane to the next
    V4 slack;              ///< cells are larger by so much of the parameter on all sides, more than rounding moves it
    float enter, leave;    ///< its part in the box of the triangles
    std::uint32_t mirror;  ///< axes that are mirrored
    bool is_extreme;       ///< its direction is too long or too short for this arithmetic
};

HWY_INLINE BrickRay brick_ray(const accel::OctreeView& tree, const ObjectRay& ray) {
    const D4 d4;
    const Ring ring;
    const accel::LatticeBox& box = tree.box;
    const V4 zero = hn::Zero(d4), side = hn::Set(d4, box.side), cells_a_unit = hn::Load(d4, box.cells_a_unit);
    const V4 placed =
        hn::Mul(hn::Sub(three(ray.origin_x, ray.origin_y, ray.origin_z), hn::Load(d4, box.origin)), cells_a_unit);
    const V4 signed_direction = hn::Mul(three(ray.direction_x, ray.direction_y, ray.direction_z), cells_a_unit);
    const auto is_mirrored = hn::Lt(signed_direction, zero);
    const V4 from = hn::Load(d4, box.from), to = hn::Load(d4, box.to);
    const V4 origin = hn::IfThenElse(is_mirrored, hn::Sub(side, placed), placed);
    const V4 low = hn::IfThenElse(is_mirrored, hn::Sub(side, to), from);
    const V4 high = hn::IfThenElse(is_mirrored, hn::Sub(side, from), to);
    V4 direction = hn::Abs(signed_direction);
    const V4 largest = ring.largest(direction);
    direction = hn::Max(direction, hn::Mul(largest, hn::Set(d4, least_share)));
    const V4 inverse = hn::Div(hn::Set(d4, 1.0f), direction);
    const V4 entries = hn::Max(hn::Mul(hn::Sub(low, origin), inverse), hn::Set(d4, ray.near));
    const V4 exits = hn::Min(hn::Mul(hn::Sub(high, origin), inverse), hn::Set(d4, ray.far));
    BrickRay r;
    r.first = hn::Mul(hn::Sub(zero, origin), inverse);
    r.step = hn::Mul(hn::Set(d4, 0.25f * box.side), inverse);
    r.slack = hn::Mul(hn::Set(d4, 2 * static_cast<float>(accel::octree_slack) * box.side), inverse);
    r.enter = hn::GetLane(ring.largest(entries));
    r.leave = hn::GetLane(ring.least(exits));
    r.mirror = bits_of_4(is_mirrored) & 7u;
    const float length = hn::GetLane(largest);
    r.is_extreme = !(length * extreme_direction >= 1.0f && length <= extreme_direction);
    return r;
}

/// A brick on the ray's way: where it meets the brick's lowest planes and how far it is to the next ones; which of its
/// full cells are still to be looked into.
struct BrickOnWay {
    V4 first, step;
    std::uint64_t cells;
    std::uint32_t brick;
    float far;  ///< of the ray, when `cells` was found
};

/// Three lanes, each by itself; through memory they would be waited for.
struct OfAxes {
    float x, y, z;
    HWY_INLINE explicit OfAxes(V4 v)
        : x(hn::GetLane(v)), y(hn::GetLane(hn::Shuffle2301(v))), z(hn::GetLane(hn::Shuffle1032(v))) {}
};

/// Which of a brick's cells the ray crosses before `far`; some that it passes by less than the slack.
HWY_INLINE std::uint64_t crossed_cells(const BrickRay& r, V4 first, V4 step, float far) {
    using F = Floats<16>;
    const V4 before = hn::Sub(first, r.slack), behind = hn::Add(first, r.slack);
    const OfAxes in(before), out(behind), by(step);
    const F x = load<16>(level_x), y = load<16>(level_y), one(1.0f), step_x(by.x), step_y(by.y), step_z(by.z);
    const F enter = largest(largest(fused_lanes(x, step_x, F(in.x)), fused_lanes(y, step_y, F(in.y))), F(r.enter));
    const F leave = least(least(fused_lanes(x + one, step_x, F(out.x)), fused_lanes(y + one, step_y, F(out.y))),
                          F(far < r.leave ? far : r.leave));
    F bottom(in.z), top = F(out.z) + step_z;
    std::uint64_t crossed = 0;
    for (int z = 0; z < 4; ++z) {
        crossed |= std::uint64_t{is_at_most(largest(enter, bottom), least(leave, top))} << (16 * z);
        bottom = bottom + step_z;
        top = top + step_z;
    }
    return crossed;
}

/// What octree_walk finds, brick by brick. ray: near the mesh; `moved`: by which bring_near moved it.
template <bool any>
HWY_INLINE bool brick_walk_near(const accel::OctreeView& tree, const ObjectRay& ray, float moved, ObjectRay* answer) {
    const BrickRay r = brick_ray(tree, ray);
    if (HWY_UNLIKELY(r.is_extreme)) {
        ObjectRay asked = ray;
        NoOctreeEvents events;
        if (!octree_walk<any>(tree, asked, events)) return false;
        if (any) return true;
        *answer = asked;
        answer->far += moved;
        return true;
    }
    if (!(r.enter <= r.leave)) return false;
    const D4 d4;
    const ShearedLanes sheared(ray);
    const std::uint32_t mirror = accel::brick_mirror(r.mirror);
    NearestInLeaf best = {ray.far, ray.triangle, 0, 0, 0};
    BrickOnWay waiting[accel::largest_octree_depth / 2 + 2];
    int waiting_count = 0;
    std::uint64_t last = 0;  // leaf that was looked into
    BrickOnWay at = {r.first, r.step, 0, 0, best.t};
    at.cells = crossed_cells(r, at.first, at.step, best.t) & tree.brick_masks[0].mirrored[r.mirror];
    while (true) {
        while (at.cells != 0) {
            const auto bit = static_cast<std::uint32_t>(__builtin_ctzll(at.cells));
            at.cells &= at.cells - 1;
            const std::uint64_t below = (std::uint64_t{1} << (bit ^ mirror)) - 1;
            const auto place =
                static_cast<std::uint32_t>(__builtin_popcountll(tree.brick_masks[at.brick].mirrored[0] & below));
            const accel::BrickEntry entry = tree.brick_entries[tree.brick_first[at.brick] + place];
            if (!entry.is_leaf()) {
                if (at.cells != 0) waiting[waiting_count++] = at;
                at.first = hn::MulAdd(hn::Load(d4, brick_corners.at[bit]), at.step, at.first);
                at.step = hn::Mul(at.step, hn::Set(d4, 0.25f));
                at.brick = entry.brick();
                at.far = best.t;
                at.cells = crossed_cells(r, at.first, at.step, best.t) & tree.brick_masks[at.brick].mirrored[r.mirror];
                continue;
            }
            if (entry.bits == last) continue;
            last = entry.bits;
            if (!leaf_met<any>(tree.corners, entry.first(), entry.count(), sheared, ray.near, best)) continue;
            if (any) return true;
            if (at.cells != 0) at.cells &= crossed_cells(r, at.first, at.step, best.t);
            at.far = best.t;
        }
        if (waiting_count == 0) break;
        at = waiting[--waiting_count];
        if (best.t < at.far) at.cells &= crossed_cells(r, at.first, at.step, best.t);
    }
    if (best.number == ray.triangle) return false;
    accel::LinkedLeaf of = {};
    of.first = best.first;
    of.count = best.count;
    const LeafTriangle triangle = triangle_in(tree, of, best.place);
    const TriangleAt met = {triangle.a, triangle.b, triangle.c};
    TriangleMeeting meeting = {};
    meets_triangle(sheared_ray(ray), met, meeting);
    describe_meeting(met, meeting, *answer);
    answer->far = best.t + moved;
    answer->triangle = best.number;
    return true;
}

template <bool any>
HWY_INLINE bool brick_walk(const accel::OctreeView& tree, const ObjectRay& ray, ObjectRay* answer) {
    if (tree.leaves == nullptr || !(ray.near <= ray.far)) return false;
    if (HWY_LIKELY(!is_far(tree.box, ray))) return brick_walk_near<any>(tree, ray, 0.0f, answer);
    ObjectRay asked = ray;
    const float moved = bring_near(tree.low, tree.high, asked);
    return brick_walk_near<any>(tree, asked, moved, answer);
}

bool octree_nearest(const accel::OctreeView& tree, ObjectRay& ray) { return brick_walk<false>(tree, ray, &ray); }

bool octree_blocked(const accel::OctreeView& tree, const ObjectRay& ray) {
    return brick_walk<true>(tree, ray, nullptr);
}

/// Sixteen rays that have nothing to do with each other: one by one. Going on in turn, by stages, hid their waiting and
/// cost as much (README.md, "Octrees").
void octree_nearest16_apart(const accel::OctreeView& tree, const std::int32_t* valid, ObjectRays& rays) {
    one_by_one(valid, rays, [&](ObjectRay& ray) { return octree_nearest(tree, ray); });
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
