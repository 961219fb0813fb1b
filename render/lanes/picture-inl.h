// Blocks of pixels, a ray each: the simd tracer, and what packets come down to.

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

template <int N>
HWY_INLINE Points<N> everywhere(Vec3f p) {
    return {Floats<N>(p.x), Floats<N>(p.y), Floats<N>(p.z)};
}

/// Where a bundle of rays from the camera is: through which cell, glass and mirror it has come.
struct Bundle {
    std::uint32_t cell;
    Vec3f tint = {1, 1, 1};
    bool is_mirrored = false;
    float mirror_level = 0;  ///< height of the floor that mirrored it
    Layers layers;           ///< what it has gathered: the floor's own light
};

/// A block is four pixels high, and as wide as its rays ask for; its rays go row by row.
inline constexpr int block_height = 4;
template <int N>
inline constexpr int block_width = N / block_height;

/// Centres of a block's pixels, from its corner.
template <int N>
struct BlockCentres {
    alignas(64) float x[N];
    alignas(64) float y[N];
    constexpr BlockCentres() : x(), y() {
        for (int i = 0; i < N; ++i) {
            x[i] = static_cast<float>(i % block_width<N>) + 0.5f;
            y[i] = static_cast<float>(i / block_width<N>) + 0.5f;
        }
    }
};
template <int N>
inline constexpr BlockCentres<N> block_centres;

template <int N>
HWY_INLINE void store_block(const detail::TileJob& job, const Rectangle& at, const Light<N>& light) {
    constexpr int block = block_width<N>;
    const int width = at.x1 - at.x0;
    if (job.rgb == nullptr) {
        HWY_ALIGN std::uint32_t pixels[N];
        for (int k = 0; k < light.r.vectors; ++k)
            hn::Store(encoded_lanes(light.r.v[k], light.g.v[k], light.b.v[k]), DU(), pixels + k * lane_count);
        if (HWY_LIKELY(width == block && at.y1 - at.y0 == block_height)) {
            for (int y = 0; y < block_height; ++y)
                std::memcpy(pixel_rgba(job, at.x0, at.y0 + y), pixels + y * block, sizeof *pixels * block);
            return;
        }
        for (int y = at.y0; y < at.y1; ++y)
            std::memcpy(pixel_rgba(job, at.x0, y), pixels + (y - at.y0) * block,
                        static_cast<std::size_t>(width) * sizeof *pixels);
        return;
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

/// Rays of a block that is cut off by the image's end.
template <int N>
HWY_INLINE Bits rays_within(const Rectangle& at) {
    constexpr int block = block_width<N>;
    if (HWY_LIKELY(at.x1 - at.x0 == block && at.y1 - at.y0 == block_height)) return all_bits<N>;
    const Bits row = (Bits(1) << (at.x1 - at.x0)) - 1;
    Bits rays = 0;
    for (int y = 0; y < at.y1 - at.y0; ++y) rays |= row << (y * block);
    return rays;
}

/// What the floors mirror, added to the light of the floors themselves.
template <int N, class Events>
HWY_NOINLINE void reflect_block(const Rays<N>& rays, const Seen<N>& seen, const Floats<N>& inverse_length, Tints<N>& tints, Light<N>& light,
                                Events& events) {
    for (Bits left = seen.mirrors; left != 0; left &= left - 1) events.began_walk();
    const Rays<N> turned = mirrored(rays, seen.mirror_level);
    Seen<N> reflected(seen.job, seen.scene, turned.direction, true);
    walk_together(seen.scene, turned, seen.mirror_groups, Unlimited{}, tints, reflected, events);
    const Light<N> more = light_of(reflected, inverse_length, tints);
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

/// Traces a block's rays from the bundle's cell and writes their light.
template <int N, class Events>
HWY_INLINE void trace_block(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                            const Rectangle& at, Events& events) {
    using F = Floats<N>;
    const F x = F(static_cast<float>(at.x0)) + load<N>(block_centres<N>.x);
    const F y = F(static_cast<float>(at.y0)) + load<N>(block_centres<N>.y);
    const Corners4 corners(*job.camera, static_cast<float>(at.x0) + 0.5f, static_cast<float>(at.y0) + 0.5f,
                           static_cast<float>(at.x0 + block_width<N>) - 0.5f,
                           static_cast<float>(at.y0 + block_height) - 0.5f);
    EyeRays<N> rays(job.camera->origin, directions(*job.camera, x, y), corners);
    if (HWY_UNLIKELY(bundle.is_mirrored)) rays.mirror(bundle.mirror_level);
    Seen<N> seen(job, scene, rays.direction, bundle.is_mirrored);
    Tints<N> tints;
    Groups groups;
    const Bits active = rays_within<N>(at);
    groups.add(bundle.cell, active);
    for (Bits left = active; left != 0; left &= left - 1) events.began_walk();
    walk_together(scene, rays, groups, Unlimited{}, tints, seen, events);

    const F squared = dot_lanes(rays.direction, rays.direction);
    F inverse_length = quick_inverse_root(squared);
    if (job.rgb != nullptr) inverse_length = exact_inverse_root(squared);
    Light<N> light = light_of(seen, inverse_length, tints);
    if (HWY_UNLIKELY(seen.mirrors != 0)) reflect_block(rays.all(), seen, inverse_length, tints, light, events);
    if (HWY_UNLIKELY(!(bundle.tint == Vec3f{1, 1, 1})))
        light = {light.r * F(bundle.tint.x), light.g * F(bundle.tint.y), light.b * F(bundle.tint.z)};
    for (int k = 0; k < bundle.layers.count; ++k) {
        // Only a floor lies before a mirrored bundle.
        const Layer& floor = bundle.layers.layer[k];
        const F lit = magnitude_of(rays.direction.z) * inverse_length;
        light.r = light.r + lit * F(floor.scale.x);
        light.g = light.g + lit * F(floor.scale.y);
        light.b = light.b + lit * F(floor.scale.z);
    }
    store_block(job, at, light);
}

/// A rectangle by blocks of N pixels.
template <int N, class Events>
HWY_NOINLINE void trace_blocks(const detail::TileJob& job, const accel::SceneView& scene, const Bundle& bundle,
                               const Rectangle& at, Events& events) {
    constexpr int block = block_width<N>;
    for (int y = at.y0; y < at.y1; y += block_height)
        for (int x = at.x0; x < at.x1; x += block)
            trace_block<N>(
                job, scene, bundle,
                {x, y, at.x1 - x < block ? at.x1 : x + block, at.y1 - y < block_height ? at.y1 : y + block_height},
                events);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
