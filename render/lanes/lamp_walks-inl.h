// Walks from places to a lamp: N neighbours go through the cells together.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

HWY_INLINE Vec3f place_of(const accel::Light& lamp) { return {lamp.position[0], lamp.position[1], lamp.position[2]}; }
HWY_INLINE Vec3f intensity_of(const accel::Light& lamp) {
    return {lamp.intensity[0], lamp.intensity[1], lamp.intensity[2]};
}

/// Whether a place in a cell sees a lamp, as lamp_light.h walks to it.
template <class Events>
HWY_INLINE bool sees_lamp(const accel::SceneView& scene, const ObjectTracer* objects, Vec3f p, std::uint32_t cell,
                          const accel::Light& lamp, Vec3f& throughput, Events& events) {
    const Vec3f place = place_of(lamp);
    const auto to_cell = static_cast<std::uint32_t>(lamp.cell), carrier = static_cast<std::uint32_t>(lamp.carrier);
    if (objects == nullptr)
        return sees_through(scene, BareRooms{}, p, place, cell, to_cell, throughput, events, carrier);
    return sees_through(scene, FurnishedRooms{*objects}, p, place, cell, to_cell, throughput, events, carrier);
}

/// Which places in a cell see a lamp, by walks one by one; multiplies tints by those of the glass on the way. objects:
/// nullptr in bare rooms
template <int N>
HWY_NOINLINE Bits seen_by_walks(const accel::SceneView& scene, const ObjectTracer* objects, const Points<N>& point,
                                const accel::Light& lamp, std::uint32_t cell, Bits some, Light<N>& tints) {
    if (static_cast<std::uint32_t>(lamp.cell) == no_cell) return 0;
    float at[3][N], tint[3][N];
    store(point.x, at[0]);
    store(point.y, at[1]);
    store(point.z, at[2]);
    NoEvents events;
    Bits seen = 0;
    for (auto& channel : tint)
        for (float& value : channel) value = 1;
    for (; some != 0; some &= some - 1) {
        const int i = static_cast<int>(lowest_bit(some));
        Vec3f throughput = {1, 1, 1};
        if (!sees_lamp(scene, objects, {at[0][i], at[1][i], at[2][i]}, cell, lamp, throughput, events)) continue;
        seen |= Bits(1) << i;
        tint[0][i] = throughput.x;
        tint[1][i] = throughput.y;
        tint[2][i] = throughput.z;
    }
    tints = {tints.r * load<N>(tint[0]), tints.g * load<N>(tint[1]), tints.b * load<N>(tint[2])};
    return seen;
}

/// The same by one walk through bare rooms for all of them; rays that rounding leaves no single way walk alone.
template <int N>
HWY_NOINLINE Bits seen_through_rooms(const accel::SceneView& scene, const Points<N>& point, const accel::Light& lamp,
                                     std::uint32_t cell, Bits some, Light<N>& tints) {
    using F = Floats<N>;
    const auto to_cell = static_cast<std::uint32_t>(lamp.cell);
    if (to_cell == no_cell) return 0;
    if (cell == to_cell) return some;
    const Vec3f place = place_of(lamp);
    const Rays<N> rays = make_rays(point, Points<N>{F(place.x) - point.x, F(place.y) - point.y, F(place.z) - point.z});
    Bits seen = 0, alone = 0;
    Light<N> through = tints;
    Groups lists[2];
    lists[0].add(cell, some);
    constexpr int most_steps = 256;  // the others walk alone
    for (int step = 0;; ++step) {
        const Groups& now = lists[step & 1];
        Groups& next = lists[~step & 1];
        next.size = 0;
        if (now.size == 0) break;
        for (int g = 0; g < now.size; ++g) {
            const Group group = now.of[g];
            if (step == most_steps) {
                alone |= group.rays;
                continue;
            }
            Ways<N> ways;
            leave_together(scene, rays, group.cell, group.rays, ways);
            alone |= ways.alone;
            for (int i = 0; i < ways.size; ++i) {
                const Way& way = ways.of[i];
                if (!way.target().is_portal()) {  // the lamp may lie on this very wall
                    seen |= way.rays & is_at_most(F(1), parameter_of(scene, rays, group.cell, way));
                    continue;
                }
                if (way.target().is_glass()) {
                    const Vec3f tint = tint_of(scene, group.cell, way.exit, way.face);
                    through = choose_light(
                        way.rays, Light<N>{through.r * F(tint.x), through.g * F(tint.y), through.b * F(tint.z)},
                        through);
                }
                const auto neighbour = static_cast<std::uint32_t>(way.target().neighbour());
                if (neighbour == to_cell) seen |= way.rays;
                else next.add(neighbour, way.rays);
            }
        }
        if (step == most_steps) break;
    }
    tints = choose_light(seen, through, tints);
    if (HWY_UNLIKELY(alone != 0)) seen |= seen_by_walks(scene, nullptr, point, lamp, cell, alone, tints);
    return seen;
}

/// As lamp_light.h walks.
template <int N>
HWY_NOINLINE Bits walk_to_lamp(const accel::SceneView& scene, const ObjectTracer* objects, const Points<N>& point,
                               const accel::Light& lamp, std::uint32_t cell, Bits some, Light<N>& tints) {
    if (objects == nullptr) return seen_through_rooms(scene, point, lamp, cell, some, tints);
    Light<N> bare = tints;
    some = seen_through_rooms(scene, point, lamp, cell, some, bare);
    return some != 0 ? seen_by_walks(scene, objects, point, lamp, cell, some, tints) : 0;
}

/// Which of the places that a beam holds have an object in their way to its lamp.
template <int N>
HWY_NOINLINE Bits in_shade_of(const accel::SceneView& scene, const ObjectTracer& tracer,
                              const accel::ObjectsOfBeam& objects, const Points<N>& point, const accel::Light& lamp,
                              std::uint32_t cell, Bits some) {
    const Bits blocked = blocked_by(scene, tracer, objects.first, objects.count, point, place_of(lamp), some);
    if (HWY_LIKELY(blocked == 0 || !objects.must_walk)) return blocked;
    Light<N> tints = {Floats<N>(1), Floats<N>(1), Floats<N>(1)};
    return blocked & ~seen_by_walks(scene, &tracer, point, lamp, cell, blocked, tints);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
