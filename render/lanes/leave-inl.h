// How sixteen rays leave a cell: the formulas of walk.h, a vertical line, a section and a face at a time for all rays
// in the cell. Whatever is loaded of the scene is one number for all of them: there is no gather.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Sixteen lines, and how ties on each are broken.
struct Rays16 {
    Vec16 origin;
    Vec16 direction;
    F16 moment;
    F16 flat;       ///< dx dx + dy dy
    F16 threshold;  ///< a side is left if it is greater: 0, or the number before 0 where zero counts as left
    Bits descends;  ///< dz < 0
    Bits climbs;    ///< dz > 0

    /// The ray of one lane, as the scalar walk takes it.
    [[nodiscard]] HWY_NOINLINE Ray<float> ray(int lane) const {
        float n[7][rays_at_once];
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
HWY_INLINE Rays16 make_rays(const Vec16& o, const Vec16& d) {
    Rays16 rays;
    rays.origin = o;
    rays.direction = d;
    const F16 zero = broadcast(0);
    const F16 cd = o.y * d.x;
    const F16 error = fused_lanes(-o.y, d.x, cd);
    rays.moment = fused_lanes(o.x, d.y, -cd) + error;
    rays.flat = d.x * d.x + d.y * d.y;
    const Bits zero_is_left = is_less(d.y, zero) | (is_equal(d.y, zero) & is_less(zero, d.x));
    rays.threshold = choose(zero_is_left, broadcast(-0x1p-149f), zero);
    rays.descends = is_less(d.z, zero);
    rays.climbs = is_less(zero, d.z);
    return rays;
}

/// The sides of a vertical line, as line_side.
HWY_INLINE F16 sides16(const Rays16& rays, const F16& minus_dy, float x, float y) {
    return fused_lanes(broadcast(y), rays.direction.x, fused_lanes(broadcast(x), minus_dy, rays.moment));
}

/// A face by which some rays leave a cell.
struct Way {
    Bits rays;
    Exit exit;
    std::uint32_t section;  ///< for Exit::Side
    std::uint32_t next_section;
    std::uint32_t face;  ///< for Exit::Side
    accel::Target target;
};

/// Where rays cross the plane of the section they leave by: t = num / den (walk.h, Crossing). Of no meaning for those
/// that leave by floor or ceiling.
struct Crossings16 {
    F16 num, den;
};

/// Calls visit(way, crossings) for every face by which one of `rays.lanes in mask` leaves the cell, and returns the
/// lanes for which several sections accept or none does, for which nothing was called.
template <class Visit>
HWY_INLINE Bits leave_cell16(const accel::SceneView& scene, const Rays16& rays, const accel::Cell& cell, Bits mask,
                             const Visit& visit) {
    constexpr std::uint32_t most_accepting = 2 * rays_at_once;
    struct Accepting {
        std::uint32_t section;
        Bits rays;
    };
    Accepting accepting[most_accepting];
    std::uint32_t accepting_count = 0;
    Bits seen = 0, several = 0;
    const float* xs = scene.section_x.first + cell.first_section;
    const float* ys = scene.section_y.first + cell.first_section;
    const std::uint32_t count = cell.section_count;
    const F16 minus_dy = -rays.direction.y;
    const Bits first_left = is_less(rays.threshold, sides16(rays, minus_dy, xs[0], ys[0]));
    Bits p_left = first_left;
    const auto accept = [&](std::uint32_t section, Bits q_left) {
        const Bits accepted = ~p_left & q_left & mask;
        if (accepted != 0) {
            several |= seen & accepted;
            seen |= accepted;
            if (accepting_count < most_accepting) accepting[accepting_count++] = {section, accepted};
            else several |= accepted;
        }
    };
    for (std::uint32_t i = 1; i < count; ++i) {
        const Bits q_left = is_less(rays.threshold, sides16(rays, minus_dy, xs[i], ys[i]));
        accept(i - 1, q_left);
        p_left = q_left;
    }
    accept(count - 1, first_left);

    const F16 floor_rise = broadcast(cell.z_floor) - rays.origin.z;
    const F16 ceiling_rise = broadcast(cell.z_ceiling) - rays.origin.z;
    const F16 dx = rays.direction.x, dy = rays.direction.y, dz = rays.direction.z;
    Bits by_floor = 0, by_ceiling = 0;
    Crossings16 at;
    for (std::uint32_t k = 0; k < accepting_count; ++k) {
        Bits left = accepting[k].rays & ~several;
        if (left == 0) continue;
        const std::uint32_t i = accepting[k].section;
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        const F16 px = broadcast(xs[i]), py = broadcast(ys[i]), qx = broadcast(xs[j]), qy = broadcast(ys[j]);
        const F16 p_side = sides16(rays, minus_dy, xs[i], ys[i]);
        const F16 q_side = sides16(rays, minus_dy, xs[j], ys[j]);
        const F16 p_along = fused_lanes(px - rays.origin.x, dx, (py - rays.origin.y) * dy);
        const F16 q_along = fused_lanes(qx - rays.origin.x, dx, (qy - rays.origin.y) * dy);
        at.num = q_side * p_along - p_side * q_along;
        at.den = (q_side - p_side) * rays.flat;
        const F16 rise = at.num * dz;
        const Bits down = left & rays.descends & is_less(rise, floor_rise * at.den);
        by_floor |= down;
        left &= ~down;
        const Bits up = left & rays.climbs & ~is_less(rise, ceiling_rise * at.den);
        Bits sideways = left & ~up;
        by_ceiling |= up;
        if (sideways == 0) continue;
        const std::uint32_t section = cell.first_section + i, next = cell.first_section + j;
        std::uint32_t face = scene.section_tails[section].first_face;
        const std::uint32_t top = scene.section_tails[section + 1].first_face - 1;
        // Rays above the last face that do not leave by the ceiling leave by that face: the ceiling is left upwards.
        for (; face < top && sideways != 0; ++face) {
            const accel::SideFace& side = scene.side_faces[face];
            const Bits here = sideways & is_less(rise, (broadcast(side.z_top) - rays.origin.z) * at.den);
            if (here == 0) continue;
            visit(Way{here, Exit::Side, section, next, face, side.target}, at);
            sideways &= ~here;
        }
        if (sideways != 0) visit(Way{sideways, Exit::Side, section, next, top, scene.side_faces[top].target}, at);
    }
    if (by_floor != 0) visit(Way{by_floor, Exit::Floor, no_section, no_section, 0, cell.floor}, at);
    if (by_ceiling != 0) visit(Way{by_ceiling, Exit::Ceiling, no_section, no_section, 0, cell.ceiling}, at);
    return mask & (~seen | several);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
