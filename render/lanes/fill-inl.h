// Rectangles of the image that one face fills: Lambert's cosine is affine over the image, over the length of the
// direction. Sixteen pixels an instruction.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Light that adds to the pixels of a rectangle: of a face, or of the sky.
struct Layer {
    bool is_sky;
    float turn;    ///< -1 where the rays were mirrored at a floor: their z is the camera's, negated
    Vec3f normal;  ///< unit; against the light: normal . direction >= 0 for the directions of the camera
    Vec3f scale;   ///< colour, tints and share; for the sky tints and share
};

/// At most: what is seen, and what a floor mirrors.
struct Layers {
    Layer layer[2];
    int count = 0;
};

/// An affine function over the image.
struct Affine {
    float at_corner, by_x, by_y;
    [[nodiscard]] HWY_INLINE float row(int y) const { return at_corner + (static_cast<float>(y) + 0.5f) * by_y; }
};
HWY_INLINE Affine along(const CameraFrame& camera, Vec3f normal) {
    return {dot(normal, camera.corner), dot(normal, camera.du), dot(normal, camera.dv)};
}

/// d . d of the camera's directions: a polynomial over the image, and in a row a + x (b + x c).
struct Lengths {
    float of_corner, by_x, by_y, by_xx, by_xy, by_yy;

    explicit Lengths(const CameraFrame& camera)
        : of_corner(dot(camera.corner, camera.corner)),
          by_x(2 * dot(camera.corner, camera.du)),
          by_y(2 * dot(camera.corner, camera.dv)),
          by_xx(dot(camera.du, camera.du)),
          by_xy(2 * dot(camera.du, camera.dv)),
          by_yy(dot(camera.dv, camera.dv)) {}
    [[nodiscard]] HWY_INLINE float a(int row) const {
        const float y = static_cast<float>(row) + 0.5f;
        return of_corner + y * (by_y + y * by_yy);
    }
    [[nodiscard]] HWY_INLINE float b(int row) const { return by_x + (static_cast<float>(row) + 0.5f) * by_xy; }
    [[nodiscard]] HWY_INLINE float c() const { return by_xx; }
};

/// What is drawn on: a job's picture, and what all its tiles share.
struct Canvas {
    const detail::TileJob& job;
    Lengths lengths;
    explicit Canvas(const detail::TileJob& job_) : job(job_), lengths(*job_.camera) {}
};

/// Adding it to a number below 2^22 rounds that to an integer and leaves it in the lowest bits.
inline constexpr float rounds_to_integer = 0x1p23f;

/// Channels of up to 255, each with `rounds_to_integer` added, as pixels. What that number leaves in the highest byte
/// is lost in the shifts and in the 255 there.
template <class F>
HWY_INLINE auto packed(F du, hn::Vec<hn::RebindToFloat<F>> r, hn::Vec<hn::RebindToFloat<F>> g,
                       hn::Vec<hn::RebindToFloat<F>> b) {
    const auto red = hn::BitCast(du, r);
    const auto green = hn::ShiftLeft<8>(hn::BitCast(du, g));
    const auto blue = hn::ShiftLeft<16>(hn::BitCast(du, b));
    return hn::Or3(hn::Or(red, hn::Set(du, 0xff000000u)), green, blue);
}

/// The root of what is not negative, to 12 bits or better.
template <class VF>
HWY_INLINE VF quick_root(VF v) {
    const hn::DFromV<VF> d;
    const auto positive = hn::Max(v, hn::Set(d, 1e-20f));
    return hn::Mul(positive, hn::ApproximateReciprocalSqrt(positive));
}

/// As `encoded`, to a unit of 255.
template <class VF>
HWY_INLINE auto encoded_lanes(VF r, VF g, VF b) {
    const hn::DFromV<VF> d;
    const auto channel = [&](VF v) HWY_ATTR {
        return hn::MulAdd(hn::Min(quick_root(v), hn::Set(d, 1.0f)), hn::Set(d, 255.0f), hn::Set(d, rounds_to_integer));
    };
    return packed(hn::RebindToUnsigned<hn::DFromV<VF>>(), channel(r), channel(g), channel(b));
}

alignas(64) inline constexpr float centres_of_pixels[16] = {0.5f, 1.5f, 2.5f,  3.5f,  4.5f,  5.5f,  6.5f,  7.5f,
                                                            8.5f, 9.5f, 10.5f, 11.5f, 12.5f, 13.5f, 14.5f, 15.5f};

/// x of the pixels' centres, from x0 on.
template <class F>
HWY_INLINE hn::Vec<F> centres(F d, int x0) {
    return hn::Add(hn::Load(d, centres_of_pixels), hn::Set(d, static_cast<float>(x0)));
}

/// What one layer adds to pixels of a row.
template <class F>
HWY_INLINE void add_layer(F d, const detail::TileJob& job, const Layer& layer, int y, hn::Vec<F> x,
                          hn::Vec<F> inverse_length, hn::Vec<F>& r, hn::Vec<F>& g, hn::Vec<F>& b) {
    const CameraFrame& camera = *job.camera;
    if (!layer.is_sky) {
        const Affine cosine = along(camera, layer.normal);
        const auto value = hn::MulAdd(x, hn::Set(d, cosine.by_x), hn::Set(d, cosine.row(y)));
        const auto lit = hn::Mul(hn::Max(value, hn::Zero(d)), inverse_length);
        r = hn::MulAdd(lit, hn::Set(d, layer.scale.x), r);
        g = hn::MulAdd(lit, hn::Set(d, layer.scale.y), g);
        b = hn::MulAdd(lit, hn::Set(d, layer.scale.z), b);
        return;
    }
    const Look& look = *job.look;
    const Affine rise = along(camera, {0, 0, layer.turn});
    const auto up = hn::Mul(hn::MulAdd(x, hn::Set(d, rise.by_x), hn::Set(d, rise.row(y))), inverse_length);
    const auto blend = hn::Sqrt(hn::Max(up, hn::Zero(d)));
    const auto channel = [&](float horizon, float zenith, float scale, hn::Vec<F> sum) HWY_ATTR {
        return hn::MulAdd(hn::MulAdd(blend, hn::Set(d, zenith - horizon), hn::Set(d, horizon)), hn::Set(d, scale), sum);
    };
    r = channel(look.sky_horizon.x, look.sky_zenith.x, layer.scale.x, r);
    g = channel(look.sky_horizon.y, look.sky_zenith.y, layer.scale.y, g);
    b = channel(look.sky_horizon.z, look.sky_zenith.z, layer.scale.z, b);
}

HWY_INLINE float* pixel_rgb(const detail::TileJob& job, int x, int y) {
    return job.rgb + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x);
}
HWY_INLINE std::uint32_t* pixel_rgba(const detail::TileJob& job, int x, int y) {
    return job.rgba + static_cast<std::size_t>(y) * static_cast<std::size_t>(job.width) + x;
}

/// Stores the first n lanes and touches nothing behind them (a blended store may write what it has read there).
template <class F>
HWY_INLINE void store_first(int n, hn::Vec<F> v, F d, std::uint32_t* out) {
    if (n == static_cast<int>(hn::Lanes(d))) return hn::StoreU(v, d, out);
    HWY_ALIGN std::uint32_t part[16];
    hn::Store(v, d, part);
    std::memcpy(out, part, static_cast<std::size_t>(n) * sizeof *out);
}

/// Any layers, to either kind of picture.
template <class F>
HWY_NOINLINE void fill_layers(F d, const Canvas& canvas, const Rectangle& at, const Layers& layers) {
    const detail::TileJob& job = canvas.job;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const hn::RebindToUnsigned<F> du;
    const auto lc = hn::Set(d, canvas.lengths.c());
    for (int y = at.y0; y < at.y1; ++y) {
        const auto la = hn::Set(d, canvas.lengths.a(y)), lb = hn::Set(d, canvas.lengths.b(y));
        for (int x0 = at.x0; x0 < at.x1; x0 += lanes) {
            const auto x = centres(d, x0);
            const auto squared = hn::MulAdd(x, hn::MulAdd(x, lc, lb), la);
            const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
            auto r = hn::Zero(d), g = hn::Zero(d), b = hn::Zero(d);
            for (int k = 0; k < layers.count; ++k) add_layer(d, job, layers.layer[k], y, x, inverse, r, g, b);
            const int n = at.x1 - x0 < lanes ? at.x1 - x0 : lanes;
            if (job.rgb == nullptr) {
                store_first(n, encoded_lanes(r, g, b), du, pixel_rgba(job, x0, y));
            } else if (n == lanes) {
                hn::StoreInterleaved3(r, g, b, d, pixel_rgb(job, x0, y));
            } else {
                HWY_ALIGN float part[3 * 16];
                hn::StoreInterleaved3(r, g, b, d, part);
                std::memcpy(pixel_rgb(job, x0, y), part, sizeof(float) * 3 * static_cast<std::size_t>(n));
            }
        }
    }
}

/// One face into a framebuffer: root(cosine) times the roots of its colour's channels.
template <class F>
HWY_INLINE void fill_face(F d, const Canvas& canvas, const Rectangle& at, const Layer& face) {
    const detail::TileJob& job = canvas.job;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const hn::RebindToUnsigned<F> du;
    const Affine cosine = along(*job.camera, face.normal);
    // The cosine's root is at most 1 by what is lost in approximating it, which rounding to 255 takes off.
    const auto full = [&](float colour) HWY_ATTR { return hn::Set(d, 255.0f * (colour < 1 ? root(colour) : 1.0f)); };
    const auto r = full(face.scale.x), g = full(face.scale.y), b = full(face.scale.z);
    const auto rounding = hn::Set(d, rounds_to_integer);
    const auto first = centres(d, at.x0);
    const auto by_x = hn::Set(d, cosine.by_x), lc = hn::Set(d, canvas.lengths.c());
    for (int y = at.y0; y < at.y1; ++y) {
        const auto la = hn::Set(d, canvas.lengths.a(y)), lb = hn::Set(d, canvas.lengths.b(y));
        const auto start = hn::Set(d, cosine.row(y));
        std::uint32_t* out = pixel_rgba(job, at.x0, y);
        auto x = first;
        const auto step = hn::Set(d, static_cast<float>(lanes));
        const auto pixels = [&]() HWY_ATTR {
            const auto squared = hn::MulAdd(x, hn::MulAdd(x, lc, lb), la);
            const auto lit = hn::Mul(hn::MulAdd(x, by_x, start), hn::ApproximateReciprocalSqrt(squared));
            const auto bright = quick_root(lit);
            return packed(du, hn::MulAdd(bright, r, rounding), hn::MulAdd(bright, g, rounding),
                          hn::MulAdd(bright, b, rounding));
        };
        int left = at.x1 - at.x0;
        for (; left >= lanes; left -= lanes) {
            hn::StoreU(pixels(), du, out);
            out += lanes;
            x = hn::Add(x, step);
        }
        if (left > 0) store_first(left, pixels(), du, out);
    }
}

/// Fills a rectangle.
HWY_INLINE void fill(const Canvas& canvas, const Rectangle& at, const Layers& layers) {
    const auto by_width = [&](const auto& body) HWY_ATTR {
        const int width = at.x1 - at.x0;
        if (width <= 4 || lane_count <= 4) body(hn::CappedTag<float, 4>());
        else if (width <= 8 || lane_count <= 8) body(hn::CappedTag<float, 8>());
        else body(D());
    };
    const bool is_plain = canvas.job.rgb == nullptr && layers.count == 1 && !layers.layer[0].is_sky;
    if (is_plain) by_width([&](auto d) HWY_ATTR { fill_face(d, canvas, at, layers.layer[0]); });
    else by_width([&](auto d) HWY_ATTR { fill_layers(d, canvas, at, layers); });
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
