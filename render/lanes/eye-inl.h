// N rays from one point, within four corner rays: the corners tell which vertical lines all rays pass on one side, so
// that few sections, most often one, are left to be asked; and the point folds into one number a section.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Four rays around others from the same point, in plan.
struct Corners4 {
    struct Line {
        float dx, minus_dy, moment, threshold;
    } line[4];

    /// Through four points of the image.
    HWY_INLINE Corners4(const CameraFrame& camera, float x0, float y0, float x1, float y1) {
        for (int i = 0; i < 4; ++i) {
            const Vec3f d = camera.direction(i % 2 == 0 ? x0 : x1, i / 2 == 0 ? y0 : y1);
            line[i] = {d.x, -d.y, camera.origin.x * d.y - camera.origin.y * d.x,
                       zero_side_is_positive(d.x, d.y) ? -0x1p-149f : 0.0f};
        }
    }
};

/// N rays from `eye`, in plan between the corners. What only the sides of lines need is made when one is asked for.
template <int N>
struct EyeRays {
    Vec3f eye;
    Points<N> direction;
    Bits descends;  ///< dz < 0
    Bits climbs;    ///< dz > 0
    const Corners4& corners;
    mutable bool has_lines = false;
    mutable Floats<N> moment, minus_dy, threshold;

    HWY_INLINE EyeRays(Vec3f eye_, const Points<N>& direction_, const Corners4& corners_)
        : eye(eye_),
          direction(direction_),
          descends(is_less(direction_.z, Floats<N>(0))),
          climbs(is_less(Floats<N>(0), direction_.z)),
          corners(corners_) {}

    HWY_INLINE void mirror(float floor) {
        eye.z = floor + (floor - eye.z);
        direction.z = -direction.z;
        const Bits swapped = descends;
        descends = climbs;
        climbs = swapped;
    }
    /// The same rays as any others are walked.
    [[nodiscard]] HWY_INLINE Rays<N> all() const {
        return make_rays(Points<N>{Floats<N>(eye.x), Floats<N>(eye.y), Floats<N>(eye.z)}, direction);
    }
    [[nodiscard]] HWY_NOINLINE Ray<float> ray(int lane) const { return all().ray(lane); }
    HWY_INLINE void need_lines() const {
        if (has_lines) return;
        has_lines = true;
        const Rays<N> rays = all();
        moment = rays.moment;
        minus_dy = rays.minus_dy;
        threshold = rays.threshold;
    }
};

template <int N>
HWY_INLINE Bits left_of(const EyeRays<N>& rays, float x, float y) {
    return is_less(rays.threshold,
                   fused_lanes(Floats<N>(y), rays.direction.x, fused_lanes(Floats<N>(x), rays.minus_dy, rays.moment)));
}

/// Which of 16 lines a corner ray has on its left. Numbers behind the last line are read: zeros follow each array.
HWY_INLINE Bits left_lines(const Corners4::Line& ray, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys) {
    using F = Floats<16>;
    const F side = fused_lanes(load<16>(ys), F(ray.dx), fused_lanes(load<16>(xs), F(ray.minus_dy), F(ray.moment)));
    return is_less(F(ray.threshold), side);
}

/// Sections that a ray between the corners may leave by: those that begin on the right of some corner and end on the
/// left of some. Counted from the cell's first.
struct Candidates {
    static constexpr std::uint32_t most = 64;
    std::uint32_t size = 0;
    std::uint32_t section[most];

    HWY_INLINE Candidates(const Corners4& corners, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys,
                          std::uint32_t count) {
        constexpr std::uint32_t lines = 16;
        Bits first_any_left = 0;
        bool last_some_right = false;
        for (std::uint32_t begin = 0; begin < count; begin += lines) {
            Bits all_left = ~Bits(0), any_left = 0;
            for (const Corners4::Line& corner : corners.line) {
                const Bits left = left_lines(corner, xs + begin, ys + begin);
                all_left &= left;
                any_left |= left;
            }
            if (begin == 0) first_any_left = any_left & 1u;
            else if (last_some_right && (any_left & 1u) != 0) add(begin - 1);
            const std::uint32_t present = count - begin < lines ? count - begin : lines;
            for (Bits both = ~all_left & any_left >> 1 & ((Bits(1) << (present - 1)) - 1); both != 0; both &= both - 1)
                add(begin + lowest_bit(both));
            last_some_right = (all_left >> (present - 1) & 1u) == 0;
        }
        if (last_some_right && first_any_left != 0) add(count - 1);
    }

private:
    /// Too many are told by a size that cannot be.
    HWY_INLINE void add(std::uint32_t i) {
        if (size < most) section[size] = i;
        ++size;
    }
};

/// Step 1: one section, or those that accept rays among the candidates.
template <int N>
HWY_INLINE void find_sections(const EyeRays<N>& rays, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys,
                              std::uint32_t count, Bits mask, Accepting& accepting) {
    const Candidates candidates(rays.corners, xs, ys, count);
    if (HWY_LIKELY(candidates.size == 1)) return accepting.add(candidates.section[0], mask);
    if (HWY_UNLIKELY(candidates.size > Candidates::most))
        return find_sections(rays.all(), xs, ys, count, mask, accepting);
    rays.need_lines();
    std::uint32_t tested = ~0u;
    Bits q_left = 0;
    for (std::uint32_t k = 0; k < candidates.size; ++k) {
        const std::uint32_t i = candidates.section[k];
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        const Bits p_left = tested == i ? q_left : left_of(rays, xs[i], ys[i]);
        q_left = left_of(rays, xs[j], ys[j]);
        tested = j;
        const Bits accepted = ~p_left & q_left & mask;
        if (accepted != 0) accepting.add(i, accepted);
    }
}

/// As for any rays (leave-inl.h), but for the crossings, which nobody asks for.
template <int N, class Visit>
HWY_INLINE Bits leave_cell_together(const accel::SceneView& scene, const EyeRays<N>& rays, const accel::Cell& cell,
                                    Bits mask, const Visit& visit) {
    using F = Floats<N>;
    const float* xs = scene.section_x.first + cell.first_section;
    const float* ys = scene.section_y.first + cell.first_section;
    const std::uint32_t count = cell.section_count;
    Accepting accepting;
    find_sections(rays, xs, ys, count, mask, accepting);

    // From nearer than this to its plane a section is crossed nobody knows where: rays may run along it, and the
    // quotient below is noise over noise (README.md).
    constexpr float near = 0.05f;
    const F dz = rays.direction.z;
    Bits by_floor = 0, by_ceiling = 0, doubtful = 0;
    for (int k = 0; k < accepting.size; ++k) {
        Bits left = accepting.of[k].rays & ~accepting.several;
        if (HWY_UNLIKELY(left == 0)) continue;
        const std::uint32_t i = accepting.of[k].section;
        const std::uint32_t j = i + 1 == count ? 0 : i + 1;
        const float nx = ys[j] - ys[i], ny = xs[i] - xs[j];
        const float away = nx * (xs[i] - rays.eye.x) + ny * (ys[i] - rays.eye.y);
        if (HWY_UNLIKELY(!(away > 0 && away * away > near * near * (nx * nx + ny * ny)))) {
            doubtful |= left;
            continue;
        }
        const F den = fused_lanes(F(nx), rays.direction.x, F(ny) * rays.direction.y);
        const F rise = F(away) * dz;
        const Bits down = left & rays.descends & is_less(rise, F(cell.z_floor - rays.eye.z) * den);
        by_floor |= down;
        left &= ~down;
        const Bits up = left & rays.climbs & ~is_less(rise, F(cell.z_ceiling - rays.eye.z) * den);
        by_ceiling |= up;
        left &= ~up;
        if (left == 0) continue;
        const std::uint32_t section = cell.first_section + i, next = cell.first_section + j;
        std::uint32_t face = scene.section_tails[section].first_face;
        const std::uint32_t top = scene.section_tails[section + 1].first_face - 1;
        for (; face < top; ++face) {
            const accel::SideFace& side = scene.side_faces[face];
            const Bits here = left & is_less(rise, F(side.z_top - rays.eye.z) * den);
            if (here == 0) continue;
            visit(Way{here, Exit::Side, section, next, face, side.target});
            left &= ~here;
            if (left == 0) break;
        }
        if (left != 0) visit(Way{left, Exit::Side, section, next, top, scene.side_faces[top].target});
    }
    if (HWY_UNLIKELY(doubtful != 0)) {
        const auto ignore_crossings = [&](const Way& way, const Crossings<N>&) HWY_ATTR {
            // Floors and ceilings are told of once.
            if (way.exit == Exit::Floor) by_floor |= way.rays;
            else if (way.exit == Exit::Ceiling) by_ceiling |= way.rays;
            else visit(way);
        };
        doubtful = leave_cell_together(scene, rays.all(), cell, doubtful, ignore_crossings);
    }
    if (by_floor != 0) visit(Way{by_floor, Exit::Floor, no_section, no_section, 0, cell.floor});
    if (by_ceiling != 0) visit(Way{by_ceiling, Exit::Ceiling, no_section, no_section, 0, cell.ceiling});
    return (mask & (~accepting.seen | accepting.several)) | doubtful;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
