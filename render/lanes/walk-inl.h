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

/// A ray that rounding has left several exits or none is walked by itself from where it began, to its end: in one
/// arithmetic, for a walk that mixes two may go round a vertical line for ever.
template <int N, class SomeRays, class Sink, class Events>
HWY_NOINLINE void walk_by_itself(const accel::SceneView& scene, const SomeRays& rays, int ray, std::uint32_t cell,
                                 Tints<N>& tints, Sink& sink, Events& events) {
    Vec3f throughput = {1, 1, 1};
    const Bits bit = Bits(1) << ray;
    const WalkEnd<float> end = walk(scene, rays.ray(ray), cell, NoLimit{}, throughput, events);
    if (!(throughput == Vec3f{1, 1, 1}) || tints.any) tints.multiply(bit, throughput);
    if (end.status == WalkStatus::Leak) return sink.leaked(bit);
    sink.hit(Way{bit, end.exit, end.section, end.next_section, end.face, end.target.bits}, end.cell);
}

/// Rays that leave a cell by one way end there, or are among those that go on.
template <int N, class Sink, class Events>
HWY_INLINE void take(const accel::SceneView& scene, std::uint32_t cell, const Way& way, Tints<N>& tints, Sink& sink,
                     Groups& next, Events& events) {
    if (!way.target().is_portal()) return sink.hit(way, cell);
    if (way.target().is_glass()) {
        tints.multiply(way.rays, tint_of(scene, cell, way.exit, way.face));
        for (Bits left = way.rays; left != 0; left &= left - 1) events.crossed_glass();
    }
    next.add(static_cast<std::uint32_t>(way.target().neighbour()), way.rays);
}

/// Follows rays from the cells in which they start until faces stop them. Calls sink.hit(way, cell) for those that end
/// together at a face; meet(group, ways) before rays leave their cell, which may take some out of the ways; and
/// alone(ray, cell) for those that are walked by themselves, from the cell in which they started.
template <int N, class SomeRays, class Sink, class Events, class Meet, class Alone>
HWY_INLINE void walk_groups(const accel::SceneView& scene, const SomeRays& rays, const Groups& start, Tints<N>& tints,
                            Sink& sink, Events& events, const Meet& meet, const Alone& walk_alone) {
    Tints<N> before;
    if (HWY_UNLIKELY(tints.any)) before = tints;
    Groups lists[2];
    const Groups* now = &start;
    Bits alone = 0;
    for (std::uint64_t steps = 0; now->size > 0 && steps < scene.cells.count + 16; ++steps) {
        Groups& next = lists[steps & 1];
        next.size = 0;
        for (int g = 0; g < now->size; ++g) {
            const Group group = now->of[g];
            for (Bits left = group.rays; left != 0; left &= left - 1)
                events.entered_cell(scene.cells[group.cell].section_count);
            Ways<N> ways;
            leave_together(scene, rays, group.cell, group.rays, ways);
            meet(group, ways);
            for (int i = 0; i < ways.size; ++i)
                if (ways.of[i].rays != 0) take(scene, group.cell, ways.of[i], tints, sink, next, events);
            alone |= ways.alone;
        }
        now = &next;
    }
    // A circle about a vertical line: the scalar walk knows how to leave it.
    for (int g = 0; g < now->size; ++g) alone |= now->of[g].rays;
    for (; HWY_UNLIKELY(alone != 0); alone &= alone - 1) {
        const int ray = static_cast<int>(lowest_bit(alone));
        tints.restore(ray, before);
        walk_alone(ray, start.cell_of(ray));
    }
}

/// Through bare rooms; sink.leaked(rays) is told of rays that do not end (walk.h).
template <int N, class SomeRays, class Sink, class Events>
HWY_INLINE void walk_together(const accel::SceneView& scene, const SomeRays& rays, const Groups& start, Tints<N>& tints,
                              Sink& sink, Events& events) {
    walk_groups(
        scene, rays, start, tints, sink, events, [](const Group&, const Ways<N>&) HWY_ATTR {},
        [&](int ray, std::uint32_t cell) HWY_ATTR { walk_by_itself(scene, rays, ray, cell, tints, sink, events); });
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
