// Blocks of 4 x 4 pixels, a ray each: the simd tracer, and what packets come down to.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

inline constexpr int block_side = 4;

/// Directions of rays through points of the image.
HWY_INLINE Vec16 directions(const CameraFrame& camera, const F16& x, const F16& y) {
    return {(broadcast(camera.corner.x) + x * broadcast(camera.du.x)) + y * broadcast(camera.dv.x),
            (broadcast(camera.corner.y) + x * broadcast(camera.du.y)) + y * broadcast(camera.dv.y),
            (broadcast(camera.corner.z) + x * broadcast(camera.du.z)) + y * broadcast(camera.dv.z)};
}

/// Where a bundle of rays from the camera is: through which cell, glass and mirror it has come.
struct Bundle {
    std::uint32_t cell;
    Vec3f tint = {1, 1, 1};
    bool is_mirrored = false;
    float mirror_level = 0;  ///< height of the floor that mirrored it
    Layers layers;           ///< what it has gathered: the floor's own light
};

HWY_ALIGN inline constexpr float block_x[rays_at_once] = {0.5f, 1.5f, 2.5f, 3.5f, 0.5f, 1.5f, 2.5f, 3.5f,
                                                          0.5f, 1.5f, 2.5f, 3.5f, 0.5f, 1.5f, 2.5f, 3.5f};
HWY_ALIGN inline constexpr float block_y[rays_at_once] = {0.5f, 0.5f, 0.5f, 0.5f, 1.5f, 1.5f, 1.5f, 1.5f,
                                                          2.5f, 2.5f, 2.5f, 2.5f, 3.5f, 3.5f, 3.5f, 3.5f};

HWY_INLINE void store_block(const detail::TileJob& job, int x0, int y0, int width, int height, const Light16& light) {
    if (job.rgb == nullptr) {
        HWY_ALIGN std::uint32_t pixels[rays_at_once];
        for (int k = 0; k < vector_count; ++k)
            hn::Store(encoded_lanes(light.r.v[k], light.g.v[k], light.b.v[k]), DU(), pixels + k * lane_count);
        if (HWY_LIKELY(width == block_side && height == block_side)) {
            for (int y = 0; y < block_side; ++y)
                std::memcpy(pixel_rgba(job, x0, y0 + y), pixels + y * block_side, block_side * sizeof *pixels);
            return;
        }
        for (int y = 0; y < height; ++y)
            std::memcpy(pixel_rgba(job, x0, y0 + y), pixels + y * block_side,
                        static_cast<std::size_t>(width) * sizeof *pixels);
        return;
    }
    HWY_ALIGN float channels[3][rays_at_once];
    store(light.r, channels[0]);
    store(light.g, channels[1]);
    store(light.b, channels[2]);
    for (int y = 0; y < height; ++y) {
        float* p = pixel_rgb(job, x0, y0 + y);
        for (int x = 0; x < width; ++x)
            for (const auto& channel : channels) *p++ = channel[y * block_side + x];
    }
}

/// Traces the block's rays from the bundle's cell and writes their light.
template <class Events>
HWY_INLINE void trace_block(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle, int x0,
                            int y0, int width, int height, Events& events) {
    const F16 x = broadcast(static_cast<float>(x0)) + load(block_x);
    const F16 y = broadcast(static_cast<float>(y0)) + load(block_y);
    Bits active = all_bits;
    if (width < block_side || height < block_side) {
        active = 0;
        for (int i = 0; i < rays_at_once; ++i)
            if (i % block_side < width && i / block_side < height) active |= 1u << i;
    }
    const Vec3f o = job.camera->origin;
    const Vec16 d = directions(*job.camera, x, y);
    Rays16 rays = make_rays({broadcast(o.x), broadcast(o.y), broadcast(o.z)}, d);
    if (bundle.is_mirrored) rays = mirrored(rays, broadcast(bundle.mirror_level));
    const F16 squared = dot16(d, d);
    F16 inverse_length;
    if (job.rgb == nullptr) {
        for (int k = 0; k < vector_count; ++k) inverse_length.v[k] = hn::ApproximateReciprocalSqrt(squared.v[k]);
    } else {
        inverse_length = broadcast(1) / root_of(squared);
    }
    Seen16 seen{job, scene, &rays, broadcast(0), broadcast(0), broadcast(0), broadcast(0)};
    seen.is_mirrored = bundle.is_mirrored;
    Tints tints;
    Groups groups;
    groups.add(bundle.cell, active);
    for (Bits left = active; left != 0; left &= left - 1) events.began_walk();
    walk16(scene, rays, groups, Unlimited{}, tints, seen, events);
    Light16 light = light_of(seen, inverse_length, tints);
    if (HWY_UNLIKELY(seen.mirrors != 0)) {
        const F16 share = broadcast(job.mirror_floor), rest = broadcast(1 - job.mirror_floor);
        const Light16 own = {rest * light.r, rest * light.g, rest * light.b};
        const Bits which = seen.mirrors;
        for (Bits left = which; left != 0; left &= left - 1) events.began_walk();
        const Rays16 turned = mirrored(rays, load(seen.mirror_level));
        Seen16 reflected{job, scene, &turned, broadcast(0), broadcast(0), broadcast(0), broadcast(0)};
        reflected.is_mirrored = true;
        Groups again = seen.mirror_groups;
        walk16(scene, turned, again, Unlimited{}, tints, reflected, events);
        const Light16 more = light_of(reflected, inverse_length, tints);
        light.r = choose(which, own.r + share * more.r, light.r);
        light.g = choose(which, own.g + share * more.g, light.g);
        light.b = choose(which, own.b + share * more.b, light.b);
    }
    if (HWY_UNLIKELY(!(bundle.tint == Vec3f{1, 1, 1}))) {
        light.r = light.r * broadcast(bundle.tint.x);
        light.g = light.g * broadcast(bundle.tint.y);
        light.b = light.b * broadcast(bundle.tint.z);
    }
    for (int k = 0; k < bundle.layers.count; ++k) {
        // Only a floor lies before a mirrored bundle.
        const Layer& floor = bundle.layers.layer[k];
        const F16 lit = magnitude_of(rays.direction.z) * inverse_length;
        light.r = light.r + lit * broadcast(floor.scale.x);
        light.g = light.g + lit * broadcast(floor.scale.y);
        light.b = light.b + lit * broadcast(floor.scale.z);
    }
    store_block(job, x0, y0, width, height, light);
}

template <class Events>
HWY_INLINE void trace_blocks(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                             const Rectangle& at, Events& events) {
    for (int y = at.y0; y < at.y1; y += block_side)
        for (int x = at.x0; x < at.x1; x += block_side)
            trace_block(job, scene, bundle, x, y, at.x1 - x < block_side ? at.x1 - x : block_side,
                        at.y1 - y < block_side ? at.y1 - y : block_side, events);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
