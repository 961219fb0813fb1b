// What rays see: the faces of shade.h in lanes, or for a rectangle.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// The unit normal against the light of the face by which rays leave: normal . direction >= 0.
HWY_INLINE Vec3f outward_normal(const accel::SceneView& scene, const Way& way) {
    if (way.exit == Exit::Floor) return {0, 0, -1};
    if (way.exit == Exit::Ceiling) return {0, 0, 1};
    const float ex = scene.section_x[way.next_section] - scene.section_x[way.section];
    const float ey = scene.section_y[way.next_section] - scene.section_y[way.section];
    const float inverse = 1.0f / root(ex * ex + ey * ey);
    return {ey * inverse, -ex * inverse, 0};
}

HWY_INLINE bool is_mirror(const detail::TileJob& job, const Way& way, const accel::SourceFace& face) {
    return job.mirror_floor > 0 && is_mirror(face, way.exit);
}

/// The rays as a level floor mirrors them: the same line in plan, from the mirrored origin.
template <int N>
HWY_INLINE Rays<N> mirrored(Rays<N> rays, const Floats<N>& floor) {
    rays.origin.z = floor + (floor - rays.origin.z);
    rays.direction.z = -rays.direction.z;
    const Bits descends = rays.descends;
    rays.descends = rays.climbs;
    rays.climbs = descends;
    return rays;
}

/// Faces at which rays have ended, for lamps to light.
template <int N>
struct Ends {
    static constexpr int most = 2 * N;  ///< each ray ends at one face, and what none leads to is not kept
    int size = 0;
    Way way[most];
    std::uint32_t cell[most];

    Ends() {}  // as many as are said
    HWY_INLINE void add(const Way& way_, std::uint32_t cell_) {
        way[size] = way_;
        cell[size++] = cell_;
    }
};

/// What rays have met.
template <int N>
struct Seen {
    const detail::TileJob& job;
    const accel::SceneView& scene;
    const Points<N>& direction;
    Floats<N> cosine{0};  ///< times the direction's length
    Floats<N> red{0}, green{0}, blue{0};
    Bits sky = 0;
    Bits leaks = 0;
    Bits mirrors = 0;  ///< end at a floor that mirrors
    Groups mirror_groups;
    Floats<N> mirror_level{0};
    Ends<N> ends;           ///< where there are lamps
    bool has_hits = false;  ///< where there are lamps, and rays end at objects
    ObjectHits<N> hits;
    bool is_mirrored;

    Seen(const detail::TileJob& job_, const accel::SceneView& scene_, const Points<N>& direction_, bool is_mirrored_)
        : job(job_), scene(scene_), direction(direction_), is_mirrored(is_mirrored_) {}

    HWY_INLINE void hit(const Way& way, std::uint32_t cell) {
        const accel::SourceFace& face = scene.source_faces[way.target_bits];
        if (face.surface == accel::Surface::Sky) {
            sky |= way.rays;
            return;
        }
        if (HWY_UNLIKELY(job.lamps != nullptr)) {
            if (way.rays != 0) ends.add(way, cell);
            return note_mirror(way, cell, face);
        }
        const Vec3f colour = colour_of(scene, face);
        const Vec3f n = outward_normal(scene, way);
        // Of a level face n.x and n.y are 0, of an upright one n.z is.
        const Floats<N> facing = fused_lanes(Floats<N>(n.x), direction.x,
                                             fused_lanes(Floats<N>(n.y), direction.y, Floats<N>(n.z) * direction.z));
        cosine = choose(way.rays, facing, cosine);
        red = choose(way.rays, Floats<N>(colour.x), red);
        green = choose(way.rays, Floats<N>(colour.y), green);
        blue = choose(way.rays, Floats<N>(colour.z), blue);
        note_mirror(way, cell, face);
    }
    HWY_INLINE void note_mirror(const Way& way, std::uint32_t cell, const accel::SourceFace& face) {
        if (HWY_LIKELY(is_mirrored || !is_mirror(job, way, face))) return;
        mirrors |= way.rays;
        mirror_groups.add(cell, way.rays);
        mirror_level = choose(way.rays, Floats<N>(scene.cells[cell].z_floor), mirror_level);
    }
    /// Both sides of a triangle are lit.
    HWY_NOINLINE void met(const ObjectHits<N>& met_hits) {
        if (job.lamps != nullptr) {
            has_hits = true;
            hits = met_hits;
        }
        using F = Floats<N>;
        const F nx = load<N>(met_hits.normal[0]), ny = load<N>(met_hits.normal[1]), nz = load<N>(met_hits.normal[2]);
        const F facing = fused_lanes(nx, direction.x, fused_lanes(ny, direction.y, nz * direction.z));
        const F inverse = F(1) / root_of(fused_lanes(nx, nx, fused_lanes(ny, ny, nz * nz)));
        cosine = choose(met_hits.rays, magnitude_of(facing) * inverse, cosine);
        alignas(64) float channels[3][N];
        for (Bits left = met_hits.rays; left != 0; left &= left - 1) {
            const int ray = static_cast<int>(lowest_bit(left));
            const Vec3f colour = object_colour(scene, met_hits.object[ray], met_hits.triangle[ray]);
            channels[0][ray] = colour.x;
            channels[1][ray] = colour.y;
            channels[2][ray] = colour.z;
        }
        red = choose(met_hits.rays, load<N>(channels[0]), red);
        green = choose(met_hits.rays, load<N>(channels[1]), green);
        blue = choose(met_hits.rays, load<N>(channels[2]), blue);
    }
    HWY_INLINE void leaked(Bits which) { leaks |= which; }
};

template <int N>
struct Light {
    Floats<N> r, g, b;
};

template <int N>
HWY_INLINE Light<N> choose_light(Bits bits, const Light<N>& a, const Light<N>& b) {
    return {choose(bits, a.r, b.r), choose(bits, a.g, b.g), choose(bits, a.b, b.b)};
}

template <int N>
HWY_NOINLINE void add_sky(const Look& look, Bits bits, const Floats<N>& dz, const Floats<N>& inverse_length,
                          Light<N>& light) {
    const Floats<N> blend = root_of(largest(dz * inverse_length, Floats<N>(0)));
    const Floats<N> rest = Floats<N>(1) - blend;
    const auto channel = [&](float horizon, float zenith)
                             HWY_ATTR { return rest * Floats<N>(horizon) + blend * Floats<N>(zenith); };
    light = choose_light(
        bits,
        Light<N>{channel(look.sky_horizon.x, look.sky_zenith.x), channel(look.sky_horizon.y, look.sky_zenith.y),
                 channel(look.sky_horizon.z, look.sky_zenith.z)},
        light);
}

/// Light of faces, and that of the sky, through glass.
template <int N>
HWY_INLINE Light<N> with_sky_and_glass(const Seen<N>& seen, const Floats<N>& inverse_length, const Tints<N>& tints,
                                       Light<N> light) {
    if (seen.sky != 0) add_sky(*seen.job.look, seen.sky, seen.direction.z, inverse_length, light);
    if (HWY_UNLIKELY(seen.leaks != 0))
        light = choose_light(seen.leaks, Light<N>{Floats<N>(1), Floats<N>(0), Floats<N>(1)}, light);
    if (HWY_UNLIKELY(tints.any))
        light = {light.r * load<N>(tints.rgb[0]), light.g * load<N>(tints.rgb[1]), light.b * load<N>(tints.rgb[2])};
    return light;
}

/// Their light, glass included.
template <int N>
HWY_INLINE Light<N> light_of(const Seen<N>& seen, const Floats<N>& inverse_length, const Tints<N>& tints) {
    const Floats<N> lit = largest(seen.cosine, Floats<N>(0)) * inverse_length;
    return with_sky_and_glass(seen, inverse_length, tints, Light<N>{lit * seen.red, lit * seen.green, lit * seen.blue});
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
