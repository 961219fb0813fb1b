// The light of lamps at N places, as lamp_light.h gathers it at one: those of a cell meet a lamp together.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

HWY_INLINE Vec3f tint_of(const accel::LightTreesView& trees, std::uint32_t beam) {
    const accel::Vertex& tint = trees.tints[trees.beams[beam].tint];
    return {tint.x, tint.y, tint.z};
}
/// Of lux on a white surface: what it becomes in the picture.
HWY_INLINE float lamp_scale(const Lamps& lamps) { return 0.318309886f * lamps.exposure; }

/// As lamp_light.h: 1 / m2, that no picture holds an infinity.
inline constexpr float largest_share = 1e12f;

/// Lights of one lamp in a cell's list: [k, end).
HWY_INLINE std::uint32_t end_of_lamp(const accel::LightTreesView& trees, std::uint32_t k, std::uint32_t end) {
    const accel::LightId lamp = trees.cell_lights[k].light;
    while (k < end && trees.cell_lights[k].light == lamp) ++k;
    return k;
}

/// Which of the places at `way` from a lamp its beam holds.
template <int N>
HWY_INLINE Bits held_by(const accel::PlanesOfBeam& planes, const Points<N>& way, Bits some) {
    using F = Floats<N>;
    for (std::uint32_t p = 0; p < planes.count && some != 0; ++p) {
        const accel::BeamPlane& plane = planes.first[p];
        some &= is_at_most(F(0), F(plane.x) * way.x + F(plane.y) * way.y + F(plane.z) * way.z);
    }
    return some;
}

/// Cosine over squared distance, from lamps that are at `way` in front of the places. is_exact: for pictures of floats.
template <int N>
HWY_INLINE Floats<N> share_of_lamp(const Points<N>& way, const Floats<N>& towards, bool is_exact) {
    const Floats<N> d2 = dot_lanes(way, way), most(largest_share);
    if (is_exact) return least(towards / (d2 * root_of(d2)), most);
    const Floats<N> inverse = quick_inverse_root(d2);
    return least(towards * (inverse * inverse * inverse), most);
}

/// Places in one cell where light is gathered.
template <int N>
struct LitLanes {
    Bits rays;
    std::uint32_t cell;
    Points<N> point;
    Points<N> normal;  ///< of length 1, on the light's side
};

/// Adds the light of a lamp to which it takes a walk.
template <int N>
HWY_NOINLINE void add_walked(const detail::TileJob& job, const accel::SceneView& scene, const LitLanes<N>& at,
                             const accel::Light& lamp, const Floats<N>& share, Bits some, Light<N>& sum) {
    using F = Floats<N>;
    const Vec3f light = intensity_of(lamp);
    Light<N> tints = {F(light.x), F(light.y), F(light.z)};
    const Bits seen = walk_to_lamp(scene, job.objects, at.point, lamp, at.cell, some, tints);
    const F weight = choose(seen, share, F(0));
    sum = {fused_lanes(weight, tints.r, sum.r), fused_lanes(weight, tints.g, sum.g),
           fused_lanes(weight, tints.b, sum.b)};
}

/// A lamp and places before and behind it.
template <int N>
struct LampAt {
    const accel::Light& lamp;
    Points<N> way;  ///< from the lamp to the places
    Floats<N> towards;
    Bits before;  ///< places that face it

    HWY_INLINE LampAt(const LitLanes<N>& at, const accel::Light& lamp_) : lamp(lamp_) {
        using F = Floats<N>;
        const Vec3f place = place_of(lamp);
        way = {at.point.x - F(place.x), at.point.y - F(place.y), at.point.z - F(place.z)};
        towards = -dot_lanes(way, at.normal);
        before = at.rays & is_less(F(0), towards);
    }
};

/// Adds what a lamp gives through the beams [k, end) of a cell's list.
template <int N>
HWY_INLINE void add_through_beams(const detail::TileJob& job, const accel::SceneView& scene, const LitLanes<N>& at,
                                  const LampAt<N>& from, std::uint32_t k, std::uint32_t end, Light<N>& sum) {
    using F = Floats<N>;
    const accel::LightTreesView& trees = job.lamps->trees;
    Bits left = from.before;
    for (; k < end && left != 0; ++k) {
        const std::uint32_t beam = trees.cell_lights[k].beam;
        Bits held = held_by(trees.planes_of(beam), from.way, left);
        left &= ~held;
        if (job.objects != nullptr && held != 0) {
            const accel::ObjectsOfBeam objects = trees.objects_of(beam);
            if (objects.count != 0)
                held &= ~in_shade_of(scene, *job.objects, objects, at.point, from.lamp, at.cell, held);
        }
        if (held == 0) continue;
        const F share = choose(held, share_of_lamp(from.way, from.towards, job.rgb != nullptr), F(0));
        const Vec3f light = tint_of(trees, beam) * intensity_of(from.lamp);
        sum = {fused_lanes(share, F(light.x), sum.r), fused_lanes(share, F(light.y), sum.g),
               fused_lanes(share, F(light.z), sum.b)};
    }
}

/// Lux of the lamps that they see; zeros in other lanes.
template <int N>
HWY_NOINLINE Light<N> lamp_light(const detail::TileJob& job, const accel::SceneView& scene, const LitLanes<N>& at) {
    using F = Floats<N>;
    Light<N> sum = {F(0), F(0), F(0)};
    const auto walk_to = [&](const LampAt<N>& from) HWY_ATTR {
        if (from.before == 0) return;
        add_walked(job, scene, at, from.lamp, share_of_lamp(from.way, from.towards, job.rgb != nullptr), from.before,
                   sum);
    };
    if (job.lamps->search == LampSearch::Naive) {
        for (const accel::Light& lamp : scene.lights) walk_to(LampAt<N>(at, lamp));
        return sum;
    }
    const accel::LightTreesView& trees = job.lamps->trees;
    const bool has_trees = job.lamps->search == LampSearch::Tree;
    const std::uint32_t end = trees.cell_offsets[at.cell + 1];
    std::uint32_t next = trees.cell_offsets[at.cell];
    for (std::uint32_t k = next; k < end; k = next) {
        next = end_of_lamp(trees, k, end);
        const LampAt<N> from(at, scene.lights[index(trees.cell_lights[k].light)]);
        if (has_trees && trees.cell_lights[k].beam != accel::no_beam)
            add_through_beams(job, scene, at, from, k, next, sum);
        else walk_to(from);
    }
    return sum;
}

/// The same number in all lanes.
template <int N>
HWY_INLINE Points<N> in_all_lanes(Vec3f v) {
    return {Floats<N>(v.x), Floats<N>(v.y), Floats<N>(v.z)};
}

/// The light that a face of that colour shows to rays that end at it by `way`.
template <int N>
HWY_NOINLINE void add_lit_face(const detail::TileJob& job, const accel::SceneView& scene, const Rays<N>& rays,
                               const Way& way, std::uint32_t cell, Vec3f own, Light<N>& light) {
    using F = Floats<N>;
    const F t = parameter_of(scene, rays, cell, way);
    LitLanes<N> at = {way.rays & all_bits<N>, cell, {}, in_all_lanes<N>(-outward_normal(scene, way))};
    const accel::Cell& c = scene.cells[cell];
    const Points<N>&o = rays.origin, &d = rays.direction;
    at.point = {fused_lanes(t, d.x, o.x), fused_lanes(t, d.y, o.y), fused_lanes(t, d.z, o.z)};
    at.point.z = least(largest(at.point.z, F(c.z_floor)), F(c.z_ceiling));
    if (way.exit == Exit::Floor) at.point.z = F(c.z_floor);
    if (way.exit == Exit::Ceiling) at.point.z = F(c.z_ceiling);
    const Light<N> lux = lamp_light(job, scene, at);
    const Vec3f colour = lamp_scale(*job.lamps) * own;
    light = choose_light(way.rays, Light<N>{lux.r * F(colour.x), lux.g * F(colour.y), lux.b * F(colour.z)}, light);
}

/// The light that triangles show to rays that end at them.
template <int N>
HWY_NOINLINE void add_lit_objects(const Seen<N>& seen, const Rays<N>& rays, Light<N>& light) {
    using F = Floats<N>;
    const ObjectHits<N>& hits = seen.hits;
    const Points<N>&o = rays.origin, &d = rays.direction;
    Points<N> n = {load<N>(hits.normal[0]), load<N>(hits.normal[1]), load<N>(hits.normal[2])};
    F size = F(1) / root_of(dot_lanes(n, n));
    size = choose(is_less(F(0), dot_lanes(n, d)), -size, size);
    n = {n.x * size, n.y * size, n.z * size};
    const auto largest_part_of = [](const Points<N>& v) HWY_ATTR {
        return largest(magnitude_of(v.x), largest(magnitude_of(v.y), magnitude_of(v.z)));
    };
    // As off_object.
    const F t = load<N>(hits.far);
    const Points<N> way = {t * d.x, t * d.y, t * d.z};
    const F off = F(0x1p-18f) * (largest_part_of(o) + largest_part_of(way)) + F(0x1p-16f);
    LitLanes<N> at;
    at.point = {(o.x + way.x) + off * n.x, (o.y + way.y) + off * n.y, (o.z + way.z) + off * n.z};
    at.normal = n;
    const F scale(lamp_scale(*seen.job.lamps));
    for (Bits left = hits.rays; left != 0; left &= ~at.rays) {
        at.cell = hits.cell[lowest_bit(left)];
        at.rays = 0;
        for (Bits some = left; some != 0; some &= some - 1)
            if (hits.cell[lowest_bit(some)] == at.cell) at.rays |= some & -some;
        const Light<N> lux = lamp_light(seen.job, seen.scene, at);
        light = choose_light(
            at.rays, Light<N>{lux.r * (scale * seen.red), lux.g * (scale * seen.green), lux.b * (scale * seen.blue)},
            light);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
