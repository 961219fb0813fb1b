// N rays together through the cells: those in one cell leave it together (leave-inl.h), those that go on to one
// neighbour go on together.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Rays that are in one cell.
struct Group {
    std::uint32_t cell;
    Bits rays;
};

/// Where each ray is. No ray is in two groups.
struct Groups {
    int size = 0;
    Group of[32];

    Groups() {}  // the groups need no beginning
    HWY_INLINE void add(std::uint32_t cell, Bits rays) {
        for (int i = 0; i < size; ++i)
            if (of[i].cell == cell) {
                of[i].rays |= rays;
                return;
            }
        of[size++] = {cell, rays};
    }
    /// \pre the ray is in one of them
    [[nodiscard]] std::uint32_t cell_of(int ray) const {
        int i = 0;
        while ((of[i].rays >> ray & 1u) == 0) ++i;
        return of[i].cell;
    }
};

/// The products of the tints of the glass that rays crossed; ones until the first pane.
template <int N>
struct Tints {
    bool any = false;
    float rgb[3][N];

    Tints() {}  // the numbers are written when the first pane is crossed
    HWY_NOINLINE void multiply(Bits rays, Vec3f tint) {
        if (!any)
            for (auto& channel : rgb)
                for (float& value : channel) value = 1;
        any = true;
        for (int i = 0; i < N; ++i) {
            if ((rays >> i & 1u) == 0) continue;
            rgb[0][i] *= tint.x;
            rgb[1][i] *= tint.y;
            rgb[2][i] *= tint.z;
        }
    }
    /// Takes one ray's tint back to what it was.
    void restore(int ray, const Tints& before) {
        if (!any) return;
        for (int c = 0; c < 3; ++c) rgb[c][ray] = before.any ? before.rgb[c][ray] : 1;
    }
};

/// Walks until faces stop the light.
struct Unlimited {
    [[nodiscard]] HWY_INLINE Bits before_side(const auto&...) const { return 0; }
    [[nodiscard]] HWY_INLINE Bits before_level(float, const auto&) const { return 0; }
    [[nodiscard]] NoLimit of(int) const { return {}; }
};

/// Walks at most t times each ray's direction.
template <int N>
struct Limits {
    Floats<N> t;
    [[nodiscard]] HWY_INLINE Bits before_side(const Crossings<N>& at) const {
        return all_bits<N> & ~is_at_most(at.num, t * at.den);
    }
    [[nodiscard]] HWY_INLINE Bits before_level(float z, const Rays<N>& rays) const {
        const Floats<N> rise = Floats<N>(z) - rays.origin.z, reach = t * rays.direction.z;
        return all_bits<N> & ((rays.descends & ~is_at_most(reach, rise)) | (~rays.descends & ~is_at_most(rise, reach)));
    }
    [[nodiscard]] Limit<float> of(int ray) const {
        float each[N];
        store(t, each);
        return {each[ray]};
    }
};

/// A ray that rounding has left several exits or none is walked by itself from where it began, to its end: in one
/// arithmetic, for a walk that mixes two may go round a vertical line for ever.
template <int N, class SomeRays, class Limiting, class Sink, class Events>
HWY_NOINLINE void walk_by_itself(const accel::SceneView& scene, const SomeRays& rays, int ray, std::uint32_t cell,
                                 const Limiting& limits, Tints<N>& tints, Sink& sink, Events& events) {
    Vec3f throughput = {1, 1, 1};
    const Bits bit = Bits(1) << ray;
    const WalkEnd<float> end = walk(scene, rays.ray(ray), cell, limits.of(ray), throughput, events);
    if (!(throughput == Vec3f{1, 1, 1}) || tints.any) tints.multiply(bit, throughput);
    if (end.status == WalkStatus::Leak) return sink.leaked(bit, end.cell);
    if (end.status == WalkStatus::Reached) return sink.reached(bit, end.cell);
    sink.hit(Way{bit, end.exit, end.section, end.next_section, end.face, end.target.bits}, end.cell,
             Crossings<N>{Floats<N>(end.num), Floats<N>(end.den)});
}

/// Follows rays from the cells in which they start until faces or limits stop them. Calls sink.hit(way, cell,
/// crossings) for those that end together at a face, sink.reached(rays, cell) for those whose limit lies in the cell,
/// sink.leaked(rays, cell) for those that do not end (walk.h); sink.enter(rays, cell) as they go on, which returns
/// those that need go no further. Crossings are what leave_cell_together tells of such rays.
template <int N, class SomeRays, class Limiting, class Sink, class Events>
class Walk {
public:
    HWY_INLINE Walk(const accel::SceneView& scene, const SomeRays& rays, const Groups& start, const Limiting& limits,
                    Tints<N>& tints, Sink& sink, Events& events)
        : scene_(scene), rays_(rays), start_(start), limits_(limits), tints_(tints), sink_(sink), events_(events) {
        if (HWY_UNLIKELY(tints.any)) tints_before_ = tints;
    }

    /// Some rays leave a cell by this way.
    HWY_INLINE void take(std::uint32_t cell, const Way& way, const auto&... at) {
        Way rest = way;
        const accel::Cell& c = scene_.cells[cell];
        const Bits reached =
            way.rays &
            (way.exit == Exit::Side ? limits_.before_side(at...)
                                    : limits_.before_level(way.exit == Exit::Floor ? c.z_floor : c.z_ceiling, rays_));
        if (reached != 0) {
            sink_.reached(reached, cell);
            rest.rays &= ~reached;
            if (rest.rays == 0) return;
        }
        if (!way.target().is_portal()) return sink_.hit(rest, cell, at...);
        if (way.target().is_glass()) {
            tints_.multiply(rest.rays, tint_of(scene_, cell, way.exit, way.face));
            for (Bits left = rest.rays; left != 0; left &= left - 1) events_.crossed_glass();
        }
        const auto neighbour = static_cast<std::uint32_t>(way.target().neighbour());
        rest.rays &= ~sink_.enter(rest.rays, neighbour);
        if (rest.rays != 0) next_->add(neighbour, rest.rays);
    }
    /// These are walked by themselves, from where they began.
    HWY_INLINE void leave_alone(Bits rays) { alone_ |= rays; }

    /// From their first cells.
    HWY_INLINE void run() { follow(start_, 0); }
    /// After the first step was taken, by `take`.
    HWY_INLINE void run_on() { follow(lists_[0], 1); }

private:
    HWY_INLINE void follow(const Groups& first, std::uint64_t steps) {
        const Groups* now = &first;
        for (; now->size > 0 && steps < scene_.cells.count + 16; ++steps) {
            next_ = &lists_[steps & 1];
            next_->size = 0;
            for (int g = 0; g < now->size; ++g) {
                const Group group = now->of[g];
                for (Bits left = group.rays; left != 0; left &= left - 1)
                    events_.entered_cell(scene_.cells[group.cell].section_count);
                alone_ |= leave_cell_together(scene_, rays_, group.cell, group.rays,
                                              [&](const Way& way, const auto&... at)
                                                  HWY_ATTR { take(group.cell, way, at...); });
            }
            now = next_;
        }
        // A circle about a vertical line: the scalar walk knows how to leave it.
        for (int g = 0; g < now->size; ++g) alone_ |= now->of[g].rays;
        for (; HWY_UNLIKELY(alone_ != 0); alone_ &= alone_ - 1) {
            const int ray = static_cast<int>(lowest_bit(alone_));
            tints_.restore(ray, tints_before_);
            walk_by_itself(scene_, rays_, ray, start_.cell_of(ray), limits_, tints_, sink_, events_);
        }
    }

    const accel::SceneView& scene_;
    const SomeRays& rays_;
    const Groups& start_;
    const Limiting& limits_;
    Tints<N>& tints_;
    Tints<N> tints_before_;
    Sink& sink_;
    Events& events_;
    Groups lists_[2];
    Groups* next_ = &lists_[0];
    Bits alone_ = 0;
};

template <int N, class SomeRays, class Limiting, class Sink, class Events>
HWY_INLINE void walk_together(const accel::SceneView& scene, const SomeRays& rays, const Groups& start,
                              const Limiting& limits, Tints<N>& tints, Sink& sink, Events& events) {
    Walk<N, SomeRays, Limiting, Sink, Events>(scene, rays, start, limits, tints, sink, events).run();
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
