// Blocks of pixels, a ray each: the simd tracer, and what packets come down to.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Directions of rays through points of the image.
template <int N>
HWY_INLINE Points<N> directions(const CameraFrame& camera, const Floats<N>& x, const Floats<N>& y) {
    using F = Floats<N>;
    return {(F(camera.corner.x) + x * F(camera.du.x)) + y * F(camera.dv.x),
            (F(camera.corner.y) + x * F(camera.du.y)) + y * F(camera.dv.y),
            (F(camera.corner.z) + x * F(camera.du.z)) + y * F(camera.dv.z)};
}

/// Where a bundle of rays from the camera is: through which cell, glass and mirror it has come.
struct Bundle {
    std::uint32_t cell;
    bool is_mirrored = false;
    float mirror_level = 0;              ///< height of the floor that mirrored it
    Vec3f floor = {0, 0, 0};             ///< that floor's own light where it is lit straight
    std::uint32_t floor_cell = no_cell;  ///< whose floor it is
    Vec3f tint = {1, 1, 1};              ///< of what it meets
    std::uint32_t came_from = no_cell;   ///< the cell before; none where it began in this one, or at a mirror in it
    Exit came_by = Exit::Side;           ///< how it left that one
    std::uint32_t section = no_section, next_section = no_section;
};

/// The way to the floor that mirrored a bundle. \pre one did
HWY_INLINE Way floor_way(const accel::SceneView& scene, const Bundle& bundle) {
    return {~Bits(0), Exit::Floor, no_section, no_section, 0, scene.cells[bundle.floor_cell].floor.bits};
}

/// From where on objects count for rays of a bundle: where they came into its cell.
template <int N>
HWY_INLINE Floats<N> first_of(const accel::SceneView& scene, const Bundle& bundle, const EyeRays<N>& rays) {
    using F = Floats<N>;
    F first(0);
    if (bundle.is_mirrored) first = (F(bundle.mirror_level) - F(rays.eye.z)) / rays.direction.z;
    if (bundle.came_from == no_cell) return first;
    const Way way = {all_bits<N>, bundle.came_by, bundle.section, bundle.next_section, 0, 0};
    const F entered = parameter_of(scene, rays.all(), bundle.came_from, way);
    return stretch_of(entered, entered, first).from;
}

template <int N>
HWY_INLINE void store_pixels(const detail::TileJob& job, const Rectangle& at,
                             const std::uint32_t* HWY_RESTRICT pixels) {
    constexpr int block = block_width<N>;
    if (HWY_LIKELY(at.x1 - at.x0 == block && at.y1 - at.y0 == block_height)) {
        for (int y = 0; y < block_height; ++y)
            std::memcpy(pixel_rgba(job, at.x0, at.y0 + y), pixels + y * block, sizeof *pixels * block);
        return;
    }
    for (int y = at.y0; y < at.y1; ++y)
        std::memcpy(pixel_rgba(job, at.x0, y), pixels + (y - at.y0) * block,
                    static_cast<std::size_t>(at.x1 - at.x0) * sizeof *pixels);
}

template <int N>
HWY_INLINE void store_block(const detail::TileJob& job, const Rectangle& at, const Light<N>& light) {
    constexpr int block = block_width<N>;
    const int width = at.x1 - at.x0;
    if (job.rgb == nullptr) {
        HWY_ALIGN std::uint32_t pixels[N];
        for (int k = 0; k < light.r.vectors; ++k)
            hn::Store(encoded_lanes(light.r.v[k], light.g.v[k], light.b.v[k]), DU(), pixels + k * lane_count);
        return store_pixels<N>(job, at, pixels);
    }
    HWY_ALIGN float channels[3][N];
    store(light.r, channels[0]);
    store(light.g, channels[1]);
    store(light.b, channels[2]);
    for (int y = at.y0; y < at.y1; ++y) {
        float* p = pixel_rgb(job, at.x0, y);
        for (int x = 0; x < width; ++x)
            for (const auto& channel : channels) *p++ = channel[(y - at.y0) * block + x];
    }
}

/// What the floors mirror, added to the light of the floors themselves.
template <int N, class Events>
HWY_NOINLINE void reflect_block(const Rays<N>& rays, const Seen<N>& seen, const Floats<N>& inverse_length,
                                Tints<N>& tints, Light<N>& light, Events& events) {
    for (Bits left = seen.mirrors; left != 0; left &= left - 1) events.began_walk();
    const Rays<N> turned = mirrored(rays, seen.mirror_level);
    Seen<N> reflected(seen.job, seen.scene, turned.direction, true);
    if (seen.job.objects != nullptr) {
        const auto all = [&](std::uint32_t cell) HWY_ATTR { return all_objects(seen.scene, cell); };
        const Floats<N> at_mirror = (seen.mirror_level - turned.origin.z) / turned.direction.z;
        walk_among(seen.scene, *seen.job.objects, turned, at_mirror, all, seen.mirror_groups, tints, reflected, events);
    } else {
        walk_together(seen.scene, turned, seen.mirror_groups, tints, reflected, events);
    }
    const Light<N> more = seen.job.lamps != nullptr ? lamp_light_of(reflected, turned, inverse_length, tints, nullptr,
                                                                    inverse_length, inverse_length)
                                                    : light_of(reflected, inverse_length, tints);
    const Floats<N> share(seen.job.mirror_floor), rest(1 - seen.job.mirror_floor);
    light = choose_light(
        seen.mirrors,
        Light<N>{rest * light.r + share * more.r, rest * light.g + share * more.g, rest * light.b + share * more.b},
        light);
}

/// Out of line, lest the compiler compute both and choose.
template <int N>
HWY_NOINLINE Floats<N> exact_inverse_root(const Floats<N>& a) {
    return Floats<N>(1) / root_of(a);
}

/// Three channels that all pixels of a face share, as its cosine's root multiplies them.
template <int N>
struct FaceColour {
    Floats<N> r, g, b;
    HWY_INLINE explicit FaceColour(Vec3f colour)
        : r(full_channel(colour.x)), g(full_channel(colour.y)), b(full_channel(colour.z)) {}
};

/// Stores a block lit by the lamp at the eye; facing: normal . direction, with the square of the normal's length
/// beside.
template <int N, class Colour>
HWY_INLINE void store_face(const detail::TileJob& job, const Rectangle& at, const Floats<N>& facing,
                           const Floats<N>& normal_squared, const Points<N>& d, const Colour& colour) {
    const V rounding = hn::Set(D(), rounds_to_integer);
    HWY_ALIGN std::uint32_t pixels[N];
    for (int k = 0; k < d.x.vectors; ++k) {
        const V squared = hn::MulAdd(d.x.v[k], d.x.v[k], hn::MulAdd(d.y.v[k], d.y.v[k], hn::Mul(d.z.v[k], d.z.v[k])));
        const V inverse = hn::ApproximateReciprocalSqrt(hn::Mul(squared, normal_squared.v[k]));
        const V bright = quick_root(hn::Mul(facing.v[k], inverse));
        hn::Store(packed(DU(), hn::MulAdd(bright, colour.r.v[k], rounding), hn::MulAdd(bright, colour.g.v[k], rounding),
                         hn::MulAdd(bright, colour.b.v[k], rounding)),
                  DU(), pixels + k * lane_count);
    }
    store_pixels<N>(job, at, pixels);
}

/// What each ray of a block meets, for store_face.
template <int N>
struct FaceLanes {
    Floats<N> facing, normal_squared, r, g, b;

    HWY_INLINE FaceLanes() : facing(0), normal_squared(1), r(0), g(0), b(0) {}

    HWY_INLINE void put(Bits rays, const Floats<N>& facing_, float normal_squared_, Vec3f colour) {
        facing = choose(rays, facing_, facing);
        normal_squared = choose(rays, Floats<N>(normal_squared_), normal_squared);
        r = choose(rays, Floats<N>(full_channel(colour.x)), r);
        g = choose(rays, Floats<N>(full_channel(colour.y)), g);
        b = choose(rays, Floats<N>(full_channel(colour.z)), b);
    }
};

/// A face that nothing but its own light comes from; nullptr for portals, the sky and mirrors.
HWY_INLINE const accel::SourceFace* plain_face(const detail::TileJob& job, const accel::SceneView& scene,
                                               const Way& way) {
    if (way.target().is_portal()) return nullptr;
    const accel::SourceFace& face = scene.source_faces[way.target_bits];
    return face.surface == accel::Surface::Sky || is_mirror(job, way, face) ? nullptr : &face;
}

/// Counts a block's walks, and how many cells they entered. Its sections were asked for by outlooks, not line by line.
template <int N, class Events>
HWY_INLINE void count_block(const Rectangle& at, std::uint64_t cells, Events& events) {
    for (Bits left = rays_within<N>(at); left != 0; left &= left - 1) events.began_walk();
    for (std::uint64_t i = 0; i < cells; ++i) events.entered_cell(0);
}

/// A block whose rays end at several faces, and may cross several clear portals before. Returns false, having done
/// nothing, where some cross glass, see the sky or a mirror, or are in doubt.
template <int N, class Events>
HWY_NOINLINE bool trace_mixed_block(const detail::TileJob& job, const accel::SceneView& scene, std::uint32_t start,
                                    Outlooks& outlooks, Vec3f tint, const Rectangle& at, const Points<N>& d,
                                    std::uint64_t cells, Events& events) {
    using F = Floats<N>;
    if (job.lamps != nullptr) return false;
    const EyeRays<N> rays(outlooks, job.camera->origin, d);
    FaceLanes<N> lanes;
    Groups lists[2];
    lists[0].add(start, all_bits<N>);
    const Bits within = rays_within<N>(at);
    constexpr int most_steps = 64;  // the others are walked as any
    for (int step = 0; step < most_steps; ++step) {
        const Groups& now = lists[step & 1];
        Groups& next = lists[~step & 1];
        next.size = 0;
        for (int g = 0; g < now.size; ++g) {
            const Group group = now.of[g];
            if (job.objects != nullptr && outlooks.objects.on(group.cell).size != 0) return false;
            for (Bits left = group.rays & within; left != 0; left &= left - 1) ++cells;
            Ways<N> ways;
            leave_cell_by(scene, rays, outlooks.on(group.cell), group.rays, ways);
            if (ways.alone != 0) return false;
            for (int i = 0; i < ways.size; ++i) {
                const Way& way = ways.of[i];
                const accel::Target target = way.target();
                if (target.is_portal()) {
                    if (target.is_glass()) return false;
                    next.add(static_cast<std::uint32_t>(target.neighbour()), way.rays);
                    continue;
                }
                const accel::SourceFace* face = plain_face(job, scene, way);
                if (face == nullptr) return false;
                const Vec3f colour = tint * colour_of(scene, *face);
                if (way.exit == Exit::Side) {
                    const float nx = scene.section_y[way.next_section] - scene.section_y[way.section];
                    const float ny = scene.section_x[way.section] - scene.section_x[way.next_section];
                    lanes.put(way.rays, fused_lanes(F(nx), d.x, F(ny) * d.y), nx * nx + ny * ny, colour);
                } else {
                    lanes.put(way.rays, magnitude_of(d.z), 1, colour);
                }
            }
        }
        if (next.size == 0) {
            count_block<N>(at, cells, events);
            store_face(job, at, lanes.facing, lanes.normal_squared, d, lanes);
            return true;
        }
    }
    return false;
}

/// A block all of whose rays go one way until they end, perhaps at several faces of one cell: most do. Returns false,
/// having done nothing, where it is none.
template <int N, class Events>
HWY_INLINE bool trace_plain_block(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                                  Outlooks& outlooks, const Rectangle& at, const Points<N>& d, Events& events) {
    using F = Floats<N>;
    Vec3f tint = bundle.tint;
    std::uint32_t id = bundle.cell;
    const float eye_z = job.camera->origin.z;
    const Bits descends = is_less(d.z, F(0)), climbs = is_less(F(0), d.z);
    constexpr std::uint64_t most_cells = 64;  // the others are walked as any
    for (std::uint64_t cells = 1; cells <= most_cells; ++cells) {
        if (job.objects != nullptr && outlooks.objects.on(id).size != 0) return false;
        const Outlook& outlook = outlooks.on(id);
        const auto try_mixed = [&]() HWY_ATTR {
            return trace_mixed_block(job, scene, id, outlooks, tint, at, d, N * (cells - 1), events);
        };
        if (!outlook.is_plain()) return try_mixed();
        const Outlook::Section& s = outlook.section[0];
        const accel::Cell& cell = scene.cells[id];
        const F den = fused_lanes(F(s.nx), d.x, F(s.ny) * d.y);
        const F rise = F(s.away) * d.z;
        const Bits down = descends & is_less(rise, F(cell.z_floor - eye_z) * den);
        const Bits up = climbs & ~is_less(rise, F(cell.z_ceiling - eye_z) * den);
        Way way;
        way.section = s.index;
        way.next_section = s.next;
        way.face = s.top_face;
        if (down == all_bits<N>) {
            way.exit = Exit::Floor;
            way.target_bits = cell.floor.bits;
        } else if (up == all_bits<N>) {
            way.exit = Exit::Ceiling;
            way.target_bits = cell.ceiling.bits;
        } else {
            if ((down | up) != 0) return try_mixed();
            way.exit = Exit::Side;
            for (std::uint32_t face = s.first_face; face < s.top_face; ++face) {
                const Bits here = is_less(rise, F(scene.side_faces[face].z_top - eye_z) * den);
                if (here == 0) continue;
                if (here != all_bits<N>) return try_mixed();
                way.face = face;
                break;
            }
            way.target_bits = scene.side_faces[way.face].target.bits;
        }
        if (way.target().is_portal()) {
            if (way.target().is_glass()) {
                tint = tint * tint_of(scene, id, way.exit, way.face);
                for (int i = 0; i < N; ++i) events.crossed_glass();
            }
            id = static_cast<std::uint32_t>(way.target().neighbour());
            continue;
        }
        const accel::SourceFace* face = plain_face(job, scene, way);
        if (face == nullptr) return false;
        if (job.lamps != nullptr) {
            if (!outlooks.lit->light(way, id, tint, at)) return false;
            count_block<N>(at, N * cells, events);
            return true;
        }
        const FaceColour<N> colour(tint * colour_of(scene, *face));
        count_block<N>(at, N * cells, events);
        if (way.exit == Exit::Side) store_face(job, at, den, F(s.squared), d, colour);
        else store_face(job, at, magnitude_of(d.z), F(1), d, colour);
        return true;
    }
    return false;
}

/// The light of a block whose rays may go different ways, followed to their ends.
template <int N, class Events>
HWY_NOINLINE void follow_block(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                               Outlooks& outlooks, const Rectangle& at, const Floats<N>& x, const Floats<N>& y,
                               const Points<N>& directions, Events& events) {
    using F = Floats<N>;
    EyeRays<N> rays(outlooks, job.camera->origin, directions);
    if (HWY_UNLIKELY(bundle.is_mirrored)) rays.mirror(bundle.mirror_level);
    const Bits active = rays_within<N>(at);
    for (Bits left = active; left != 0; left &= left - 1) events.began_walk();
    Seen<N> seen(job, scene, rays.direction, bundle.is_mirrored);
    Tints<N> tints;
    Groups start;
    start.add(bundle.cell, active);
    if (job.objects != nullptr) {
        const auto in_view = [&](std::uint32_t cell) HWY_ATTR {
            return rays.is_mirrored ? outlooks.objects.in_mirror(cell, bundle.mirror_level) : outlooks.objects.on(cell);
        };
        walk_among(scene, *job.objects, rays, first_of(scene, bundle, rays), in_view, start, tints, seen, events);
    } else {
        walk_together(scene, rays, start, tints, seen, events);
    }

    const F squared = dot_lanes(rays.direction, rays.direction);
    F inverse_length = quick_inverse_root(squared);
    if (job.rgb != nullptr) inverse_length = exact_inverse_root(squared);
    Light<N> light = job.lamps != nullptr ? lamp_light_of(seen, rays.all(), inverse_length, tints,
                                                          bundle.is_mirrored ? nullptr : outlooks.lit, x, y)
                                          : light_of(seen, inverse_length, tints);
    if (HWY_UNLIKELY(seen.mirrors != 0)) reflect_block(rays.all(), seen, inverse_length, tints, light, events);
    if (HWY_UNLIKELY(!(bundle.tint == Vec3f{1, 1, 1})))
        light = {light.r * F(bundle.tint.x), light.g * F(bundle.tint.y), light.b * F(bundle.tint.z)};
    if (HWY_UNLIKELY(bundle.is_mirrored && job.lamps != nullptr)) {
        const EyeRays<N> straight(outlooks, job.camera->origin, directions);
        Light<N> floor = {F(0), F(0), F(0)};
        add_lit_face(job, scene, straight.all(), floor_way(scene, bundle), bundle.floor_cell, bundle.floor, floor);
        light = {light.r + floor.r, light.g + floor.g, light.b + floor.b};
    } else if (HWY_UNLIKELY(bundle.is_mirrored)) {
        const F lit = magnitude_of(rays.direction.z) * inverse_length;
        light = {light.r + lit * F(bundle.floor.x), light.g + lit * F(bundle.floor.y),
                 light.b + lit * F(bundle.floor.z)};
    }
    store_block(job, at, light);
}

/// Traces a block's rays from the bundle's cell and writes their light.
template <int N, class Events>
HWY_INLINE void trace_block(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                            Outlooks& outlooks, const Rectangle& at, Events& events) {
    using F = Floats<N>;
    const F x = F(static_cast<float>(at.x0)) + load<N>(block_centres<N>.x);
    const F y = F(static_cast<float>(at.y0)) + load<N>(block_centres<N>.y);
    const Points<N> d = directions(*job.camera, x, y);
    const bool is_plain =
        job.rgb == nullptr && !bundle.is_mirrored && (job.lamps == nullptr || outlooks.lit != nullptr);
    if (is_plain && trace_plain_block(job, scene, bundle, outlooks, at, d, events)) return;
    follow_block(job, scene, bundle, outlooks, at, x, y, d, events);
}

/// Stores wait in line, and what waits for memory holds all behind it up: the picture's lines are asked for before.
HWY_INLINE void ask_for_lines(const detail::TileJob& job, const Rectangle& at) {
    constexpr int pixels_a_line = 16;
    for (int y = at.y0; y < at.y1; ++y)
        for (int x = at.x0; x < at.x1; x += pixels_a_line) __builtin_prefetch(pixel_rgba(job, x, y), 1, 3);
}

/// A rectangle by blocks of N pixels.
template <int N, class Events>
HWY_NOINLINE void trace_blocks(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                               Outlooks& outlooks, const Rectangle& at, Events& events) {
    constexpr int block = block_width<N>;
    if (job.rgb == nullptr) ask_for_lines(job, at);
    for (int y = at.y0; y < at.y1; y += block_height)
        for (int x = at.x0; x < at.x1; x += block)
            trace_block<N>(
                job, scene, bundle, outlooks,
                {x, y, at.x1 - x < block ? at.x1 : x + block, at.y1 - y < block_height ? at.y1 : y + block_height},
                events);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
