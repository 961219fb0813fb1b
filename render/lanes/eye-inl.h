// N rays from one point, within four corner rays: the corners tell which vertical lines all rays pass on one side, so
// that few sections, most often one, are left to be asked; and the point folds into one number a section.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Four rays around others from the same point, in plan.
struct Corners4 {
    struct Line {
        float dx, minus_dy, moment;
    } line[4];
    Vec3f eye;
    float noise;  ///< times a line's coordinates and the eye's: more than rounding makes of any side of it

    /// Through the centres of a rectangle's corner pixels.
    HWY_INLINE Corners4(const CameraFrame& camera, const Rectangle& at) {
        const float x[2] = {static_cast<float>(at.x0) + 0.5f, static_cast<float>(at.x1) - 0.5f};
        const float y[2] = {static_cast<float>(at.y0) + 0.5f, static_cast<float>(at.y1) - 0.5f};
        for (int i = 0; i < 4; ++i) {
            const Vec3f d = camera.direction(x[i % 2], y[i / 2]);
            line[i].dx = d.x;
            line[i].minus_dy = -d.y;
            line[i].moment = camera.origin.x * d.y - camera.origin.y * d.x;
        }
        const auto level = [](Vec3f v) { return magnitude(v.x) + magnitude(v.y); };
        eye = camera.origin;
        noise = 0x1p-20f * (level(camera.corner) + x[1] * level(camera.du) + y[1] * level(camera.dv));
    }
};

/// On which sides of rays between four corners 16 vertical lines pass: on the left of all of them, and perhaps on the
/// left of some. What rounding may make of any ray is allowed for, so that no line is thought to lie on one side of a
/// ray that its own test puts on the other: the decisions are the scalar walk's.
struct LineSides {
    Bits all_left = ~Bits(0), some_left = 0;

    /// Numbers behind the last line are read: zeros follow each array.
    HWY_INLINE LineSides(const Corners4& corners, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys) {
        using F = Floats<16>;
        const F x = load<16>(xs), y = load<16>(ys);
        const F reach = magnitude_of(x) + magnitude_of(y) + F(magnitude(corners.eye.x) + magnitude(corners.eye.y));
        const F noise = reach * F(corners.noise);
        for (const Corners4::Line& corner : corners.line) {
            const F side = fused_lanes(y, F(corner.dx), fused_lanes(x, F(corner.minus_dy), F(corner.moment)));
            all_left &= is_less(noise, side);
            some_left |= is_at_most(-noise, side);  // zero, where eye and line are at the origin
        }
    }
};

/// Sections that a ray between the corners may leave by: those that begin on the right of some ray and end on the left
/// of some. Counted from the cell's first.
struct Candidates {
    static constexpr std::uint32_t most = 12;
    std::uint32_t size = 0;
    std::uint32_t section[most];

    HWY_INLINE Candidates(const Corners4& corners, const float* HWY_RESTRICT xs, const float* HWY_RESTRICT ys,
                          std::uint32_t count) {
        constexpr std::uint32_t lines = 16;
        Bits first_some_left = 0;
        bool last_some_right = false;
        for (std::uint32_t begin = 0; begin < count; begin += lines) {
            const LineSides sides(corners, xs + begin, ys + begin);
            if (begin == 0) first_some_left = sides.some_left & 1u;
            else if (last_some_right && (sides.some_left & 1u) != 0) add(begin - 1);
            const std::uint32_t present = count - begin < lines ? count - begin : lines;
            for (Bits both = ~sides.all_left & sides.some_left >> 1 & ((Bits(1) << (present - 1)) - 1); both != 0;
                 both &= both - 1)
                add(begin + lowest_bit(both));
            last_some_right = (sides.all_left >> (present - 1) & 1u) == 0;
        }
        if (last_some_right && first_some_left != 0) add(count - 1);
    }

private:
    /// Too many are told by a size that cannot be.
    HWY_INLINE void add(std::uint32_t i) {
        if (size < most) section[size] = i;
        ++size;
    }
};

/// A cell as rays from one point between four corners see it: the few sections by which they may leave it.
struct Outlook {
    static constexpr std::uint32_t most = Candidates::most;
    struct Section {
        std::uint32_t index, next;  ///< in the scene
        float px, py, qx, qy;       ///< where it begins and ends
        float nx, ny;               ///< its outward normal, of its length
        float away;                 ///< from the point to its plane, times its length
        bool is_near;               ///< to its plane: what that says of rays is noise over noise
        float squared;              ///< its length, squared
        std::uint32_t first_face, top_face;
    };
    std::uint32_t cell = no_section;  ///< none: not made yet
    std::uint32_t size;
    bool is_known;  ///< else there are too many
    Section section[most];

    Outlook() {}  // the rest is made when it is needed
    /// Whether all rays leave by one section, and its plane tells where.
    [[nodiscard]] HWY_INLINE bool is_plain() const { return is_known && size == 1 && !section[0].is_near; }
    HWY_NOINLINE void make(const accel::SceneView& scene, std::uint32_t cell_, Vec3f eye, const Corners4& corners) {
        cell = cell_;
        size = 0;
        is_known = true;
        const accel::Cell& c = scene.cells[cell];
        const float* xs = scene.section_x.first + c.first_section;
        const float* ys = scene.section_y.first + c.first_section;
        const Candidates candidates(corners, xs, ys, c.section_count);
        if (candidates.size > most) {
            is_known = false;
            return;
        }
        // From nearer than this to its plane a section is crossed nobody knows where: rays may run along it, and
        // what its plane says is noise over noise (README.md).
        constexpr float near = 0x1p-8f;
        for (std::uint32_t k = 0; k < candidates.size; ++k) {
            const std::uint32_t i = candidates.section[k];
            const std::uint32_t j = i + 1 == c.section_count ? 0 : i + 1;
            Section& s = section[size];
            s.index = c.first_section + i;
            s.next = c.first_section + j;
            s.px = xs[i];
            s.py = ys[i];
            s.qx = xs[j];
            s.qy = ys[j];
            s.nx = s.qy - s.py;
            s.ny = s.px - s.qx;
            s.away = s.nx * (s.px - eye.x) + s.ny * (s.py - eye.y);
            s.squared = s.nx * s.nx + s.ny * s.ny;
            s.first_face = scene.section_tails[s.index].first_face;
            s.top_face = scene.section_tails[s.index + 1].first_face - 1;
            s.is_near = !(s.away * s.away > near * near * s.squared);
            // From beyond its plane rays come in by this section: they would leave by it behind the eye.
            if (s.is_near || s.away > 0) ++size;
        }
    }
};

class LitFaces;

/// The cells that rays between four corners cross, as far as they are asked for; a few are remembered.
class Outlooks {
public:
    /// `around`: those of a rectangle that holds this one, or nullptr.
    Outlooks(const accel::SceneView& scene, const CameraFrame& camera, ObjectsOnImage& on_image, const Rectangle& at,
             const Outlooks* around)
        : objects(scene, on_image, at, around != nullptr ? &around->objects : nullptr),
          scene_(scene),
          camera_(camera),
          around_(around),
          corners_(camera, at) {}

    ObjectsInView objects;
    LitFaces* lit = nullptr;  ///< what lamps light in a rectangle around this one, if anybody knows

    /// Its height does not matter: a mirrored eye sees the same.
    [[nodiscard]] HWY_INLINE const Outlook& on(std::uint32_t cell) {
        if (const Outlook* narrow = narrow_one_on(cell)) return *narrow;
        Outlook& outlook = outlooks_[cell % remembered];
        if (HWY_UNLIKELY(outlook.cell != cell)) outlook.make(scene_, cell, camera_.origin, corners_);
        return outlook;
    }

private:
    static constexpr std::uint32_t remembered = 8;
    /// Asking few sections for nothing costs less than finding out which ones.
    static constexpr std::uint32_t narrow = 2;

    /// The outlook of a larger rectangle, where that is as good.
    [[nodiscard]] HWY_INLINE const Outlook* narrow_one_on(std::uint32_t cell) const {
        for (const Outlooks* wider = around_; wider != nullptr; wider = wider->around_) {
            const Outlook& outlook = wider->outlooks_[cell % remembered];
            if (outlook.cell == cell && outlook.is_known && outlook.size <= narrow) return &outlook;
        }
        return nullptr;
    }
    const accel::SceneView& scene_;
    const CameraFrame& camera_;
    const Outlooks* around_;
    Corners4 corners_;
    Outlook outlooks_[remembered];
};

/// N rays of the camera through pixels of a rectangle. What only the sides of lines need is made when one is asked for.
template <int N>
struct EyeRays {
    Outlooks& outlooks;  ///< from the camera, through more than these rays
    Vec3f eye;           ///< the camera's, or its image in a floor
    Points<N> direction;
    Bits descends;  ///< dz < 0
    Bits climbs;    ///< dz > 0
    bool is_mirrored = false;
    mutable bool has_lines = false;
    mutable Floats<N> moment, minus_dy, threshold;

    HWY_INLINE EyeRays(Outlooks& outlooks_, Vec3f eye_, const Points<N>& direction_)
        : outlooks(outlooks_),
          eye(eye_),
          direction(direction_),
          descends(is_less(direction_.z, Floats<N>(0))),
          climbs(is_less(Floats<N>(0), direction_.z)) {}

    HWY_INLINE void mirror(float floor) {
        is_mirrored = true;
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

/// Which rays each section of an outlook accepts (step 1).
template <int N>
struct Accepted {
    Bits by[Outlook::most];
    Bits seen = 0, several = 0;

    HWY_INLINE Accepted(const EyeRays<N>& rays, const Outlook& outlook, Bits mask) {
        if (HWY_LIKELY(outlook.size == 1)) {
            by[0] = seen = mask;
            return;
        }
        rays.need_lines();
        std::uint32_t tested = no_section;
        Bits q_left = 0;
        for (std::uint32_t k = 0; k < outlook.size; ++k) {
            const Outlook::Section& s = outlook.section[k];
            const Bits p_left = tested == s.index ? q_left : left_of(rays, s.px, s.py);
            q_left = left_of(rays, s.qx, s.qy);
            tested = s.next;
            by[k] = ~p_left & q_left & mask;
            several |= seen & by[k];
            seen |= by[k];
        }
    }
};

template <int N>
HWY_NOINLINE void leave_as_any(const accel::SceneView& scene, const EyeRays<N>& rays, std::uint32_t cell, Bits mask,
                               Ways<N>& ways) {
    leave_together(scene, rays.all(), cell, mask, ways);
}

/// As any rays leave a cell (leave-inl.h), by what the outlook knows of it.
template <int N>
HWY_INLINE void leave_cell_by(const accel::SceneView& scene, const EyeRays<N>& rays, const Outlook& outlook, Bits mask,
                              Ways<N>& ways) {
    using F = Floats<N>;
    if (HWY_UNLIKELY(!outlook.is_known)) return leave_as_any(scene, rays, outlook.cell, mask, ways);
    const Accepted<N> accepted(rays, outlook, mask);
    const accel::Cell& cell = scene.cells[outlook.cell];
    const F dz = rays.direction.z;
    const float floor_rise = cell.z_floor - rays.eye.z, ceiling_rise = cell.z_ceiling - rays.eye.z;
    Bits by_floor = 0, by_ceiling = 0, near = 0;
    for (std::uint32_t k = 0; k < outlook.size; ++k) {
        Bits left = accepted.by[k] & ~accepted.several;
        if (left == 0) continue;
        const Outlook::Section& s = outlook.section[k];
        if (HWY_UNLIKELY(s.is_near)) {
            near |= left;
            continue;
        }
        const F den = fused_lanes(F(s.nx), rays.direction.x, F(s.ny) * rays.direction.y);
        const F rise = F(s.away) * dz;
        const Bits down = left & rays.descends & is_less(rise, F(floor_rise) * den);
        const Bits up = left & rays.climbs & ~is_less(rise, F(ceiling_rise) * den);
        by_floor |= down;
        by_ceiling |= up;
        left &= ~(down | up);
        for (std::uint32_t face = s.first_face; face < s.top_face && left != 0; ++face) {
            const accel::SideFace& side = scene.side_faces[face];
            const Bits here = left & is_less(rise, F(side.z_top - rays.eye.z) * den);
            if (here == 0) continue;
            ways.add({here, Exit::Side, s.index, s.next, face, side.target.bits});
            left &= ~here;
        }
        if (left != 0)
            ways.add({left, Exit::Side, s.index, s.next, s.top_face, scene.side_faces[s.top_face].target.bits});
    }
    if (by_floor != 0) ways.add({by_floor, Exit::Floor, no_section, no_section, 0, cell.floor.bits});
    if (by_ceiling != 0) ways.add({by_ceiling, Exit::Ceiling, no_section, no_section, 0, cell.ceiling.bits});
    ways.alone |= mask & (~accepted.seen | accepted.several);
    if (HWY_UNLIKELY(near != 0)) leave_as_any(scene, rays, outlook.cell, near, ways);
}

/// A step of the walk.
template <int N>
HWY_INLINE void leave_together(const accel::SceneView& scene, const EyeRays<N>& rays, std::uint32_t cell, Bits mask,
                               Ways<N>& ways) {
    leave_cell_by(scene, rays, rays.outlooks.on(cell), mask, ways);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
