// How N rays leave a cell: the formulas of walk.h, a vertical line, a section and a face at a time for all rays in the
// cell. Whatever is loaded of the scene is one number for all of them: there is no gather.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// N lines, and how ties on each are broken.
template <int N>
struct Rays {
    Points<N> origin;
    Points<N> direction;
    Floats<N> moment;
    Floats<N> minus_dy;
    Floats<N> threshold;  ///< a side is left if it is greater: 0, or the number before 0 where zero counts as left
    Bits descends;        ///< dz < 0
    Bits climbs;          ///< dz > 0

    [[nodiscard]] HWY_INLINE const Rays& all() const { return *this; }
    /// The ray of one lane, as the scalar walk takes it.
    [[nodiscard]] HWY_NOINLINE Ray<float> ray(int lane) const {
        float n[6][N];
        store(origin.x, n[0]);
        store(origin.y, n[1]);
        store(origin.z, n[2]);
        store(direction.x, n[3]);
        store(direction.y, n[4]);
        store(direction.z, n[5]);
        return make_ray_unchecked(Vec3f{n[0][lane], n[1][lane], n[2][lane]}, Vec3f{n[3][lane], n[4][lane], n[5][lane]});
    }
};

/// As make_ray_unchecked.
template <int N>
HWY_INLINE Rays<N> make_rays(const Points<N>& o, const Points<N>& d) {
    Rays<N> rays;
    rays.origin = o;
    rays.direction = d;
    const Floats<N> zero(0);
    const Floats<N> cd = o.y * d.x;
    const Floats<N> error = fused_lanes(-o.y, d.x, cd);
    rays.moment = fused_lanes(o.x, d.y, -cd) + error;
    rays.minus_dy = -d.y;
    const Bits zero_is_left = is_less(d.y, zero) | (is_equal(d.y, zero) & is_less(zero, d.x));
    rays.threshold = choose(zero_is_left, Floats<N>(-0x1p-149f), zero);
    rays.descends = is_less(d.z, zero);
    rays.climbs = is_less(zero, d.z);
    return rays;
}

/// The sides of a vertical line, as line_side.
template <int N>
HWY_INLINE Floats<N> sides_of(const Rays<N>& rays, float x, float y) {
    return fused_lanes(Floats<N>(y), rays.direction.x, fused_lanes(Floats<N>(x), rays.minus_dy, rays.moment));
}

/// A face by which some rays leave a cell.
struct Way {
    Bits rays;
    Exit exit;
    std::uint32_t section;  ///< for Exit::Side
    std::uint32_t next_section;
    std::uint32_t face;         ///< for Exit::Side
    std::uint32_t target_bits;  ///< of accel::Target, which would write a zero to each of an array of ways

    [[nodiscard]] HWY_INLINE accel::Target target() const { return {target_bits}; }
};

/// Faces by which N rays leave a cell; no ray is in two of them.
template <int N>
struct Ways {
    int size = 0;
    Bits alone = 0;  ///< rays that several sections accept, or none does
    Way of[N + 2];   // as many as are said

    Ways() {}
    HWY_INLINE void add(const Way& way) { of[size++] = way; }
};

/// Sections that accept rays, before anything is done for them: only then is known which rays several accept.
struct Accepting {
    static constexpr int most = 64;
    struct {
        std::uint32_t section;
        Bits rays;
    } of[most];
    int size = 0;
    Bits seen = 0;     ///< rays that some section accepts
    Bits several = 0;  ///< that several accept, or too many to be kept

    HWY_INLINE void add(std::uint32_t section, Bits rays) {
        several |= seen & rays;
        seen |= rays;
        if (HWY_UNLIKELY(size == most)) {
            several |= rays;
            return;
        }
        of[size++] = {section, rays};
    }
};

/// Step 1 for all rays of the mask: sections counted from the cell's first.
template <int N>
HWY_INLINE void find_sections(const Rays<N>& rays, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys,
                              std::uint32_t count, Bits mask, Accepting& accepting) {
    const Bits first_left = is_less(rays.threshold, sides_of(rays, xs[0], ys[0]));
    Bits p_left = first_left;
    for (std::uint32_t i = 1; i < count; ++i) {
        const Bits q_left = is_less(rays.threshold, sides_of(rays, xs[i], ys[i]));
        const Bits accepted = ~p_left & q_left & mask;
        if (accepted != 0) accepting.add(i - 1, accepted);
        p_left = q_left;
    }
    const Bits accepted = ~p_left & first_left & mask;
    if (accepted != 0) accepting.add(count - 1, accepted);
}

/// Adds the faces by which rays of the mask leave the cell.
template <int N>
HWY_INLINE void leave_together(const accel::SceneView& scene, const Rays<N>& rays, std::uint32_t cell_id, Bits mask,
                               Ways<N>& ways) {
    const accel::Cell& cell = scene.cells[cell_id];
    const float* xs = scene.section_x.first + cell.first_section;
    const float* ys = scene.section_y.first + cell.first_section;
    const std::uint32_t count = cell.section_count;
    Accepting accepting;
    find_sections(rays, xs, ys, count, mask, accepting);

    const Floats<N> dx = rays.direction.x, dy = rays.direction.y, dz = rays.direction.z;
    const Floats<N> flat = dx * dx + dy * dy;
    const Floats<N> floor_rise = Floats<N>(cell.z_floor) - rays.origin.z;
    const Floats<N> ceiling_rise = Floats<N>(cell.z_ceiling) - rays.origin.z;
    Bits by_floor = 0, by_ceiling = 0;
    for (int k = 0; k < accepting.size; ++k) {
        Bits left = accepting.of[k].rays & ~accepting.several;
        if (HWY_UNLIKELY(left == 0)) continue;
        const std::uint32_t i = accepting.of[k].section;
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        const Floats<N> p_side = sides_of(rays, xs[i], ys[i]), q_side = sides_of(rays, xs[j], ys[j]);
        const Floats<N> p_along =
            fused_lanes(Floats<N>(xs[i]) - rays.origin.x, dx, (Floats<N>(ys[i]) - rays.origin.y) * dy);
        const Floats<N> q_along =
            fused_lanes(Floats<N>(xs[j]) - rays.origin.x, dx, (Floats<N>(ys[j]) - rays.origin.y) * dy);
        const Floats<N> num = q_side * p_along - p_side * q_along;
        const Floats<N> den = (q_side - p_side) * flat;
        const Floats<N> rise = num * dz;
        const Bits down = left & rays.descends & is_less(rise, floor_rise * den);
        by_floor |= down;
        left &= ~down;
        const Bits up = left & rays.climbs & ~is_less(rise, ceiling_rise * den);
        by_ceiling |= up;
        left &= ~up;
        if (left == 0) continue;
        const std::uint32_t section = cell.first_section + i, next = cell.first_section + j;
        std::uint32_t face = scene.section_tails[section].first_face;
        const std::uint32_t top = scene.section_tails[section + 1].first_face - 1;
        // Rays above the last face that do not leave by the ceiling leave by that face: the ceiling is left upwards.
        for (; face < top; ++face) {
            const accel::SideFace& side = scene.side_faces[face];
            const Bits here = left & is_less(rise, (Floats<N>(side.z_top) - rays.origin.z) * den);
            if (here == 0) continue;
            ways.add(Way{here, Exit::Side, section, next, face, side.target.bits});
            left &= ~here;
            if (left == 0) break;
        }
        if (left != 0) ways.add(Way{left, Exit::Side, section, next, top, scene.side_faces[top].target.bits});
    }
    if (by_floor != 0) ways.add(Way{by_floor, Exit::Floor, no_section, no_section, 0, cell.floor.bits});
    if (by_ceiling != 0) ways.add(Way{by_ceiling, Exit::Ceiling, no_section, no_section, 0, cell.ceiling.bits});
    ways.alone |= mask & (~accepting.seen | accepting.several);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
