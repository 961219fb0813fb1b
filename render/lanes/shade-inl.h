// What rays see: the faces of shade.h in sixteen lanes, or for a rectangle.

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
    return job.mirror_floor > 0 && way.exit == Exit::Floor && face.surface == accel::Surface::Floor;
}

/// The rays as a level floor mirrors them: the same line in plan, from the mirrored origin.
HWY_INLINE Rays16 mirrored(Rays16 rays, const F16& floor) {
    rays.origin.z = floor + (floor - rays.origin.z);
    rays.direction.z = -rays.direction.z;
    const Bits descends = rays.descends;
    rays.descends = rays.climbs;
    rays.climbs = descends;
    return rays;
}

/// What sixteen rays have met.
struct Seen16 {
    const detail::TileJob& job;
    const accel::SceneView& scene;
    const Rays16* rays;
    F16 cosine;  ///< times the direction's length
    F16 red, green, blue;
    Bits sky = 0;
    Bits leaked_rays = 0;
    Bits mirrors = 0;  ///< end at a floor that mirrors
    Groups mirror_groups;
    float mirror_level[rays_at_once];
    bool is_mirrored = false;

    HWY_INLINE void hit(const Way& way, std::uint32_t cell, const Crossings16&) {
        const accel::SourceFace& face = scene.source_faces[way.target.bits];
        if (face.surface == accel::Surface::Sky) {
            sky |= way.rays;
            return;
        }
        const Vec3f colour = colour_of(scene, face);
        const Vec3f n = outward_normal(scene, way);
        const F16 facing = way.exit == Exit::Side
                               ? fused_lanes(broadcast(n.x), rays->direction.x, broadcast(n.y) * rays->direction.y)
                               : magnitude_of(rays->direction.z);
        cosine = choose(way.rays, facing, cosine);
        red = choose(way.rays, broadcast(colour.x), red);
        green = choose(way.rays, broadcast(colour.y), green);
        blue = choose(way.rays, broadcast(colour.z), blue);
        if (!is_mirrored && is_mirror(job, way, face)) {
            mirrors |= way.rays;
            mirror_groups.add(cell, way.rays);
            for (Bits left = way.rays; left != 0; left &= left - 1)
                mirror_level[lowest_bit(left)] = scene.cells[cell].z_floor;
        }
    }
    HWY_INLINE void reached(Bits, std::uint32_t) {}
    HWY_INLINE void leaked(Bits which, std::uint32_t) { leaked_rays |= which; }
    HWY_INLINE Bits enter(Bits, std::uint32_t) { return 0; }
};

struct Light16 {
    F16 r, g, b;
};

/// Their light, glass included.
HWY_INLINE Light16 light_of(const Seen16& seen, const F16& inverse_length, const Tints& tints) {
    const F16 lit = largest(seen.cosine, broadcast(0)) * inverse_length;
    Light16 light = {lit * seen.red, lit * seen.green, lit * seen.blue};
    if (HWY_UNLIKELY(seen.sky != 0)) {
        const Look& look = *seen.job.look;
        const F16 blend = root_of(largest(seen.rays->direction.z * inverse_length, broadcast(0)));
        const F16 rest = broadcast(1) - blend;
        const auto channel = [&](float horizon, float zenith)
                                 HWY_ATTR { return rest * broadcast(horizon) + blend * broadcast(zenith); };
        light.r = choose(seen.sky, channel(look.sky_horizon.x, look.sky_zenith.x), light.r);
        light.g = choose(seen.sky, channel(look.sky_horizon.y, look.sky_zenith.y), light.g);
        light.b = choose(seen.sky, channel(look.sky_horizon.z, look.sky_zenith.z), light.b);
    }
    if (HWY_UNLIKELY(seen.leaked_rays != 0)) {
        light.r = choose(seen.leaked_rays, broadcast(1), light.r);
        light.g = choose(seen.leaked_rays, broadcast(0), light.g);
        light.b = choose(seen.leaked_rays, broadcast(1), light.b);
    }
    if (HWY_UNLIKELY(tints.any)) {
        light.r = light.r * load(tints.rgb[0]);
        light.g = light.g * load(tints.rgb[1]);
        light.b = light.b * load(tints.rgb[2]);
    }
    return light;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
