// How a register of rays, all in one cell, leaves it: every ray finds its own section in one pass over the cell's
// lines, and fetches that section's numbers. Only what is beyond the noise of rounding is decided here.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

using Numbers = hn::Vec<DI>;
using Mask = hn::Mask<D>;

/// Lines in a register.
struct Beams {
    V ox, oy, oz, dx, dy, dz;
    V moment, minus_dy;
    V noise;  ///< what a side of one of the scene's lines may be wrong by

    /// \pre no origin lies farther out than twice `extent`, metres; `noise_of` it
    HWY_INLINE Beams(V ox_, V oy_, V oz_, V dx_, V dy_, V dz_, float noise_a_length)
        : ox(ox_), oy(oy_), oz(oz_), dx(dx_), dy(dy_), dz(dz_) {
        const V product = hn::Mul(oy, dx);
        const V error = hn::NegMulAdd(oy, dx, product);
        moment = hn::Add(hn::MulSub(ox, dy, product), error);
        minus_dy = hn::Neg(dy);
        noise = hn::Mul(hn::Set(D(), noise_a_length), hn::Add(hn::Abs(dx), hn::Abs(dy)));
    }
    /// As line_side.
    [[nodiscard]] HWY_INLINE V side(V x, V y) const { return hn::MulAdd(y, dx, hn::MulAdd(x, minus_dy, moment)); }
    /// How far along the beams a line lies.
    [[nodiscard]] HWY_INLINE V along(V x, V y) const {
        return hn::MulAdd(hn::Sub(x, ox), dx, hn::Mul(hn::Sub(y, oy), dy));
    }
};

/// Ten roundings of the largest products in a side, with a margin: moments of origins twice as far out as the scene.
HWY_INLINE float noise_of(float extent) { return 0x1p-20f * extent; }

/// Where beams leave a cell.
struct Departure {
    Mask sure;       ///< else rounding may have decided: nothing below has a meaning
    Mask is_level;   ///< by floor or ceiling
    V num, den;      ///< the parameter there; den < 0 for floors
    Numbers target;  ///< bits
};

/// Numbers of one section for each ray, from those of a cell: numbers[index], of `count`.
HWY_INLINE V each_of(const float* HWY_RESTRICT numbers, Numbers index, std::uint32_t count) {
    if constexpr (lane_count == 16) {
        if (HWY_LIKELY(count <= 16))
            return hn::TableLookupLanes(hn::LoadU(D(), numbers), hn::IndicesFromVec(D(), index));
    }
    (void)count;
    return hn::GatherIndex(D(), numbers, index);
}
HWY_INLINE Numbers each_of(const accel::SectionTail* tails, Numbers index, std::uint32_t count) {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(tails);
    if constexpr (lane_count == 16) {
        if (HWY_LIKELY(count <= 16))
            return hn::TableLookupLanes(hn::LoadU(DI(), numbers), hn::IndicesFromVec(DI(), index));
    }
    (void)count;
    return hn::GatherIndex(DI(), numbers, index);
}

HWY_INLINE Mask as_mask(hn::Mask<DI> mask) { return hn::RebindMask(D(), mask); }

/// The section that each beam has on its right where it begins and on its left where it ends, counted from the cell's
/// first: the last one of several, any where there is none.
HWY_INLINE Numbers accepting_section(const Beams& beams, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys,
                                     std::uint32_t count, Mask& several) {
    const V zero = hn::Zero(D());
    Numbers section = hn::Set(DI(), static_cast<std::int32_t>(count - 1));
    const Mask first = hn::Gt(beams.side(hn::Set(D(), xs[0]), hn::Set(D(), ys[0])), zero);
    Mask before = first, found = hn::MaskFromVec(zero);
    several = found;
    for (std::uint32_t i = 1; i < count; ++i) {
        const Mask left = hn::Gt(beams.side(hn::Set(D(), xs[i]), hn::Set(D(), ys[i])), zero);
        const Mask accepting = hn::AndNot(before, left);
        section =
            hn::IfThenElse(hn::RebindMask(DI(), accepting), hn::Set(DI(), static_cast<std::int32_t>(i - 1)), section);
        several = hn::Or(several, hn::And(found, accepting));
        found = hn::Or(found, accepting);
        before = left;
    }
    several = hn::Or(several, hn::And(found, hn::AndNot(before, first)));
    return section;
}

/// The face of each beam's stack: the first whose top lies above it, else the last (find_face).
HWY_INLINE Numbers face_of_stacks(const accel::SceneView& scene, const accel::Cell& cell, const Beams& beams,
                                  Numbers section, V scaled_dz, V den, Mask asking) {
    const accel::SectionTail* tails = scene.section_tails.first + cell.first_section;
    const auto* tops = &scene.side_faces.first->z_top;
    const Numbers one = hn::Set(DI(), 1);
    Numbers face = each_of(tails, section, cell.section_count);
    const Numbers top = hn::Sub(each_of(tails + 1, section, cell.section_count), one);
    Mask higher = hn::And(asking, as_mask(hn::Lt(face, top)));
    while (!hn::AllFalse(D(), higher)) {
        const V z_top = hn::GatherIndex(D(), tops, hn::ShiftLeft<1>(face));
        const Mask is_it = hn::Lt(scaled_dz, hn::Mul(hn::Sub(z_top, beams.oz), den));
        higher = hn::AndNot(is_it, higher);
        face = hn::IfThenElse(hn::RebindMask(DI(), higher), hn::Add(face, one), face);
        higher = hn::And(higher, as_mask(hn::Lt(face, top)));
    }
    return face;
}

/// By the formulas of walk.h. A section is sure where it alone accepts the beam (where the grid has bent a wall inwards
/// two may, and the farthest is to be taken) and the beam passes its ends by more than noise.
HWY_INLINE Departure leave_prism(const accel::SceneView& scene, const accel::Cell& cell, const Beams& beams,
                                 Mask mask) {
    const float* xs = scene.section_x.first + cell.first_section;
    const float* ys = scene.section_y.first + cell.first_section;
    const std::uint32_t count = cell.section_count;
    Mask several;
    const Numbers p = accepting_section(beams, xs, ys, count, several);
    const Numbers last = hn::Set(DI(), static_cast<std::int32_t>(count - 1));
    const Numbers q = hn::IfThenZeroElse(hn::Eq(p, last), hn::Add(p, hn::Set(DI(), 1)));
    const V px = each_of(xs, p, count), py = each_of(ys, p, count);
    const V qx = each_of(xs, q, count), qy = each_of(ys, q, count);
    const V p_side = beams.side(px, py), q_side = beams.side(qx, qy);
    Departure to;
    to.sure = hn::AndNot(several, mask);
    to.sure = hn::And(to.sure, hn::And(hn::Lt(p_side, hn::Neg(beams.noise)), hn::Gt(q_side, beams.noise)));

    const V zero = hn::Zero(D());
    const V flat = hn::Add(hn::Mul(beams.dx, beams.dx), hn::Mul(beams.dy, beams.dy));
    const V num = hn::Sub(hn::Mul(q_side, beams.along(px, py)), hn::Mul(p_side, beams.along(qx, qy)));
    const V den = hn::Mul(hn::Sub(q_side, p_side), flat);
    const V scaled_dz = hn::Mul(num, beams.dz);
    const Mask descends = hn::Lt(beams.dz, zero), climbs = hn::Lt(zero, beams.dz);
    const V level = hn::IfThenElse(descends, hn::Set(D(), cell.z_floor), hn::Set(D(), cell.z_ceiling));
    const V rise = hn::Sub(level, beams.oz);
    const Mask is_below = hn::Lt(scaled_dz, hn::Mul(rise, den));
    const Mask down = hn::And(descends, is_below), up = hn::AndNot(is_below, climbs);
    to.is_level = hn::Or(down, up);
    to.num = hn::IfThenElse(to.is_level, rise, num);
    to.den = hn::IfThenElse(to.is_level, beams.dz, den);

    const Numbers face = face_of_stacks(scene, cell, beams, p, scaled_dz, den, hn::AndNot(to.is_level, to.sure));
    const auto* targets = reinterpret_cast<const std::int32_t*>(&scene.side_faces.first->target.bits);
    to.target = hn::GatherIndex(DI(), targets, hn::ShiftLeft<1>(face));
    to.target = hn::IfThenElse(hn::RebindMask(DI(), down), hn::Set(DI(), static_cast<std::int32_t>(cell.floor.bits)),
                               to.target);
    to.target = hn::IfThenElse(hn::RebindMask(DI(), up), hn::Set(DI(), static_cast<std::int32_t>(cell.ceiling.bits)),
                               to.target);
    return to;
}

HWY_INLINE Mask is_portal(Numbers target) {
    const Numbers kind = hn::And(target, hn::Set(DI(), static_cast<std::int32_t>(~accel::Target::index_mask)));
    return as_mask(hn::Ne(kind, hn::Zero(DI())));
}

/// Where the limits t lie before the departures: as Limit.
HWY_INLINE Mask is_limit_before(const Departure& to, V t) {
    const V at_limit = hn::Mul(t, to.den);
    const Mask descends = hn::Lt(to.den, hn::Zero(D()));
    return hn::Not(hn::Or(hn::AndNot(descends, hn::Le(to.num, at_limit)), hn::And(descends, hn::Ge(to.num, at_limit))));
}

/// No coordinate of the scene in plan is larger: metres.
HWY_INLINE float extent_of(const accel::SceneView& scene) {
    if (scene.locator_nodes.empty()) return 0;
    const accel::LocatorNode& all = scene.locator_nodes[0];
    float extent = 1;
    for (int k = 0; k < 2; ++k) {
        if (-all.low[k] > extent) extent = -all.low[k];
        if (all.high[k] > extent) extent = all.high[k];
    }
    return extent;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
