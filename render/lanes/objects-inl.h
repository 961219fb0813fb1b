// Rays among objects: N rays that are in one cell ask for the nearest triangle of each object in it, sixteen at a time
// in the object's own space; then those that hit nothing leave the cell.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// The triangles at which rays end.
template <int N>
struct ObjectHits {
    Bits rays = 0;
    alignas(64) float far[N];  ///< parameter of the hit, of rays that have one
    alignas(64) float normal[3][N];
    std::uint32_t object[N];
    std::uint32_t triangle[N];
    std::uint32_t cell[N];

    ObjectHits() {}  // numbers are written with the hits
    HWY_INLINE void take(int ray, accel::ObjectId id, const accel::PlacedObject& at, const ObjectRays& from, int lane) {
        rays |= Bits(1) << ray;
        far[ray] = from.far[lane];
        object[ray] = static_cast<std::uint32_t>(id);
        triangle[ray] = from.triangle[lane];
        const float* m = at.object_from_scene.rows.data();
        for (int k = 0; k < 3; ++k)
            normal[k][ray] =
                m[k] * from.normal_x[lane] + m[4 + k] * from.normal_y[lane] + m[8 + k] * from.normal_z[lane];
    }
};

/// The part of each ray in a cell.
template <int N>
struct Stretch {
    Floats<N> from, to;
};

/// As `turned`: the same numbers.
template <int N>
HWY_INLINE Points<N> turned_lanes(const float* HWY_RESTRICT m, const Points<N>& d) {
    using F = Floats<N>;
    const auto row = [&](const float* r) HWY_ATTR { return F(r[0]) * d.x + F(r[1]) * d.y + F(r[2]) * d.z; };
    return {row(m), row(m + 4), row(m + 8)};
}

/// Rays' origins in an object's space: one for all rays of an eye, else one each.
template <int N>
HWY_INLINE Vec3f origin_in(const accel::PlacedObject& object, const EyeRays<N>& rays) {
    const auto& at = object.scene_from_object.rows;
    return turned(object.object_from_scene, Vec3f{rays.eye.x - at[3], rays.eye.y - at[7], rays.eye.z - at[11]});
}
template <int N>
HWY_INLINE Points<N> origin_in(const accel::PlacedObject& object, const Rays<N>& rays) {
    using F = Floats<N>;
    const auto& at = object.scene_from_object.rows;
    return turned_lanes(object.object_from_scene.rows.data(),
                        Points<N>{rays.origin.x - F(at[3]), rays.origin.y - F(at[7]), rays.origin.z - F(at[11])});
}
template <int N>
HWY_INLINE const Floats<N>& in_lanes(const Floats<N>& a) {
    return a;
}
template <int N>
HWY_INLINE Floats<N> in_lanes(float a) {
    return Floats<N>(a);
}

/// Which rays pass the mesh's box within their stretches; rather more than fewer.
template <int N, class Origin>
HWY_INLINE Bits pass_box(const accel::ObjectMesh& mesh, const Origin& o, const Points<N>& d,
                         const Stretch<N>& stretch) {
    using F = Floats<N>;
    F in = stretch.from, out = stretch.to;
    const auto slab = [&](float low, float high, const auto& origin, const F& way) HWY_ATTR {
        const F tiny(1e-18f);
        const F inverse = quick_inverse(choose(is_less(magnitude_of(way), tiny), tiny, way));
        const F a = (F(low) - in_lanes<N>(origin)) * inverse, b = (F(high) - in_lanes<N>(origin)) * inverse;
        in = largest(in, least(a, b));
        out = least(out, largest(a, b));
    };
    slab(mesh.low[0], mesh.high[0], o.x, d.x);
    slab(mesh.low[1], mesh.high[1], o.y, d.y);
    slab(mesh.low[2], mesh.high[2], o.z, d.z);
    const F wider(0x1p-10f);  // more than quick_inverse may be wrong by, twice
    return is_at_most(in - wider * magnitude_of(in), out + wider * magnitude_of(out) + F(1e-6f));
}

/// Sixteen of N lanes.
template <int N>
HWY_INLINE void store_sixteen(const Floats<N>& a, int sixteen, float* HWY_RESTRICT p) {
    constexpr int vectors = ObjectRays::count / lane_count;
    for (int k = 0; k < vectors; ++k) hn::Store(a.v[sixteen * vectors + k], D(), p + k * lane_count);
}

/// Sixteen rays as objects are asked, with what is the same for all objects.
struct Asked {
    ObjectRays rays;
    alignas(64) std::int32_t valid[ObjectRays::count];

    HWY_INLINE Asked() {
        const auto zero = hn::Zero(DU()), ones = hn::Set(DU(), ~0u);
        for (int k = 0; k < ObjectRays::count; k += lane_count) {
            hn::Store(hn::Zero(D()), D(), rays.time + k);
            hn::Store(ones, DU(), rays.mask + k);
            hn::Store(zero, DU(), rays.id + k);
            hn::Store(zero, DU(), rays.flags + k);
            hn::Store(ones, DU(), rays.triangle + k);
            hn::Store(ones, DU(), rays.geometry + k);
            hn::Store(ones, DU(), rays.instance + k);
        }
    }
    HWY_INLINE void choose_lanes(Bits some) {
        const auto ones = hn::BitCast(D(), hn::Set(DI(), -1));
        for (int k = 0; k < ObjectRays::count / lane_count; ++k)
            hn::Store(hn::BitCast(DI(), hn::IfThenElseZero(mask_of(some, k), ones)), DI(), valid + k * lane_count);
    }
};

/// Asks an object for the nearest triangles of `rays` within their stretches.
template <int N, class SomeRays>
HWY_NOINLINE void meet_object(const accel::SceneView& scene, const ObjectTracer& tracer, accel::ObjectId id,
                              const SomeRays& lines, Bits rays, Asked& asked, Stretch<N>& stretch,
                              ObjectHits<N>& hits) {
    static_assert(N % ObjectRays::count == 0);
    const accel::PlacedObject& object = scene.objects[index(id)];
    const auto o = origin_in(object, lines);
    const Points<N> d = turned_lanes(object.object_from_scene.rows.data(), lines.direction);
    rays &= pass_box(scene.meshes[index(object.mesh)], o, d, stretch);
    if (rays == 0) return;
    Bits hit = 0;
    for (int sixteen = 0; sixteen < N / ObjectRays::count; ++sixteen) {
        const Bits some = rays >> (sixteen * ObjectRays::count) & 0xffffu;
        if (some == 0) continue;
        ObjectRays& to = asked.rays;
        store_sixteen(in_lanes<N>(o.x), sixteen, to.origin_x);
        store_sixteen(in_lanes<N>(o.y), sixteen, to.origin_y);
        store_sixteen(in_lanes<N>(o.z), sixteen, to.origin_z);
        store_sixteen(d.x, sixteen, to.direction_x);
        store_sixteen(d.y, sixteen, to.direction_y);
        store_sixteen(d.z, sixteen, to.direction_z);
        store_sixteen(stretch.from, sixteen, to.near);
        store_sixteen(stretch.to, sixteen, to.far);
        asked.choose_lanes(some);
        tracer.nearest16(tracer.state, object.mesh, asked.valid, to);
        for (Bits left = some; left != 0; left &= left - 1) {
            const int lane = static_cast<int>(lowest_bit(left));
            if (to.triangle[lane] == no_triangle) continue;
            hits.take(sixteen * ObjectRays::count + lane, id, object, to, lane);
            hit |= Bits(1) << (sixteen * ObjectRays::count + lane);
            to.triangle[lane] = no_triangle;
        }
    }
    if (hit != 0) stretch.to = choose(hit, load<N>(hits.far), stretch.to);
}

/// Where rays leave their cell by one way, in units of their directions.
template <int N>
HWY_INLINE Floats<N> parameter_of(const accel::SceneView& scene, const Rays<N>& rays, std::uint32_t cell,
                                  const Way& way) {
    using F = Floats<N>;
    if (way.exit != Exit::Side) {
        const float level = way.exit == Exit::Floor ? scene.cells[cell].z_floor : scene.cells[cell].z_ceiling;
        return (F(level) - rays.origin.z) / rays.direction.z;
    }
    const float px = scene.section_x[way.section], py = scene.section_y[way.section];
    const float qx = scene.section_x[way.next_section], qy = scene.section_y[way.next_section];
    const F dx = rays.direction.x, dy = rays.direction.y, zero(0);
    const F p_side = least(sides_of(rays, px, py), zero), q_side = largest(sides_of(rays, qx, qy), zero);
    const F p_along = fused_lanes(F(px) - rays.origin.x, dx, (F(py) - rays.origin.y) * dy);
    const F q_along = fused_lanes(F(qx) - rays.origin.x, dx, (F(qy) - rays.origin.y) * dy);
    const F num = q_side * p_along - p_side * q_along, den = (q_side - p_side) * (dx * dx + dy * dy);
    return choose(is_less(zero, den), num / den, zero);
}

/// As stretch_start and stretch_end (object_walk.h).
template <int N>
HWY_INLINE Stretch<N> stretch_of(const Floats<N>& entered, const Floats<N>& leaves, const Floats<N>& first) {
    using F = Floats<N>;
    const F slack(stretch_slack);
    return {largest(entered - (slack + slack * entered), first), leaves + (slack + slack * leaves)};
}

/// The rays of a group in their cell, before they leave it: those that meet an object there are taken out of `ways`.
/// entered: where they came into the cell; is moved on to where they leave it. first: from where on objects count.
template <int N, class SomeRays>
HWY_INLINE void meet_objects(const accel::SceneView& scene, const ObjectTracer& tracer, const ObjectList& objects,
                             const SomeRays& own, const Rays<N>& rays, const Floats<N>& first, const Group& group,
                             Asked& asked, Ways<N>& ways, Floats<N>& entered, ObjectHits<N>& hits) {
    using F = Floats<N>;
    F leaves = entered;
    for (int i = 0; i < ways.size; ++i)
        leaves = choose(ways.of[i].rays, parameter_of(scene, rays, group.cell, ways.of[i]), leaves);
    const Bits here = group.rays & ~ways.alone;
    if (objects.size != 0 && here != 0) {
        const Bits hit_before = hits.rays;
        Stretch<N> stretch = stretch_of(entered, leaves, first);
        for (std::uint32_t k = 0; k < objects.size; ++k)
            meet_object(scene, tracer, objects.first[k], own, here, asked, stretch, hits);
        const Bits hit = hits.rays & ~hit_before;
        if (hit != 0)
            for (int i = 0; i < ways.size; ++i) ways.of[i].rays &= ~hit;
        for (Bits left = hit; left != 0; left &= left - 1) hits.cell[lowest_bit(left)] = group.cell;
    }
    entered = leaves;
}

/// As walk_by_itself.
template <int N, class Sink, class Events>
HWY_NOINLINE void walk_alone_among(const accel::SceneView& scene, const ObjectTracer& tracer, const Rays<N>& rays,
                                   const Floats<N>& first, int ray, std::uint32_t cell, Tints<N>& tints, Sink& sink,
                                   ObjectHits<N>& hits, Events& events) {
    Vec3f throughput = {1, 1, 1};
    const Bits bit = Bits(1) << ray;
    float firsts[N];
    store(first, firsts);
    ObjectHit<float> hit;
    const WalkEnd<float> end =
        walk_furnished(scene, tracer, rays.ray(ray), cell, NoLimit{}, throughput, events, hit, firsts[ray]);
    if (!(throughput == Vec3f{1, 1, 1}) || tints.any) tints.multiply(bit, throughput);
    if (end.status == WalkStatus::Leak) return sink.leaked(bit);
    if (end.status != WalkStatus::Object)
        return sink.hit(Way{bit, end.exit, end.section, end.next_section, end.face, end.target.bits}, end.cell);
    hits.rays |= bit;
    hits.object[ray] = hit.object;
    hits.triangle[ray] = hit.triangle;
    hits.far[ray] = static_cast<float>(hit.t);
    hits.cell[ray] = end.cell;
    hits.normal[0][ray] = hit.normal.x;
    hits.normal[1][ray] = hit.normal.y;
    hits.normal[2][ray] = hit.normal.z;
}

/// As walk_together, in rooms that are furnished. `objects(cell)` names those that the rays may meet there, from
/// `first` on; of rays that end at one sink.met(hits) is told.
template <int N, class SomeRays, class Objects, class Sink, class Events>
HWY_NOINLINE void walk_among(const accel::SceneView& scene, const ObjectTracer& tracer, const SomeRays& rays,
                             const Floats<N>& first, const Objects& objects, const Groups& start, Tints<N>& tints,
                             Sink& sink, Events& events) {
    const Rays<N> lines = rays.all();
    Floats<N> entered = first;
    ObjectHits<N> hits;
    Asked asked;
    walk_groups(
        scene, rays, start, tints, sink, events,
        [&](const Group& group, Ways<N>& ways) HWY_ATTR {
            meet_objects(scene, tracer, objects(group.cell), rays, lines, first, group, asked, ways, entered, hits);
        },
        [&](int ray, std::uint32_t cell)
            HWY_ATTR { walk_alone_among(scene, tracer, lines, first, ray, cell, tints, sink, hits, events); });
    if (hits.rays != 0) sink.met(hits);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
