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

struct Rectangle {
    int x0, y0, x1, y1;
};

/// An affine function over the image.
struct Affine {
    float at_corner, by_x, by_y;
    [[nodiscard]] HWY_INLINE float row(int y) const { return at_corner + (static_cast<float>(y) + 0.5f) * by_y; }
};
HWY_INLINE Affine along(const CameraFrame& camera, Vec3f normal) {
    return {dot(normal, camera.corner), dot(normal, camera.du), dot(normal, camera.dv)};
}

/// Of directions in a row: d . d = a + x (b + x c), x in pixels.
struct RowLength {
    float a, b, c;
};
HWY_INLINE RowLength row_length(const CameraFrame& camera, int y) {
    const Vec3f d = camera.corner + (static_cast<float>(y) + 0.5f) * camera.dv;
    return {dot(d, d), 2 * dot(d, camera.du), dot(camera.du, camera.du)};
}

/// 255 times the square roots of three channels as pixels. What comes in is not negative.
template <class F>
HWY_INLINE auto packed(F du, hn::Vec<hn::RebindToFloat<F>> r, hn::Vec<hn::RebindToFloat<F>> g,
                       hn::Vec<hn::RebindToFloat<F>> b) {
    const hn::RebindToSigned<F> di;
    const auto red = hn::BitCast(du, hn::ConvertTo(di, r));
    const auto green = hn::ShiftLeft<8>(hn::BitCast(du, hn::ConvertTo(di, g)));
    const auto blue = hn::ShiftLeft<16>(hn::BitCast(du, hn::ConvertTo(di, b)));
    return hn::Or(hn::Or(red, green), hn::Or(blue, hn::Set(du, 0xff000000u)));
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
        return hn::MulAdd(hn::Min(quick_root(v), hn::Set(d, 1.0f)), hn::Set(d, 255.0f), hn::Set(d, 0.5f));
    };
    return packed(hn::RebindToUnsigned<hn::DFromV<VF>>(), channel(r), channel(g), channel(b));
}

/// x of the pixels' centres, from x0 on.
template <class F>
HWY_INLINE hn::Vec<F> centres(F d, int x0) {
    return hn::Add(hn::ConvertTo(d, hn::Iota(hn::RebindToSigned<F>(), x0)), hn::Set(d, 0.5f));
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

/// Any layers, to either kind of picture.
template <class F>
HWY_NOINLINE void fill_layers(F d, const detail::TileJob& job, const Rectangle& at, const Layers& layers) {
    const int lanes = static_cast<int>(hn::Lanes(d));
    const hn::RebindToUnsigned<F> du;
    for (int y = at.y0; y < at.y1; ++y) {
        const RowLength length = row_length(*job.camera, y);
        for (int x0 = at.x0; x0 < at.x1; x0 += lanes) {
            const auto x = centres(d, x0);
            const auto squared =
                hn::MulAdd(x, hn::MulAdd(x, hn::Set(d, length.c), hn::Set(d, length.b)), hn::Set(d, length.a));
            const auto inverse = hn::Div(hn::Set(d, 1.0f), hn::Sqrt(squared));
            auto r = hn::Zero(d), g = hn::Zero(d), b = hn::Zero(d);
            for (int k = 0; k < layers.count; ++k) add_layer(d, job, layers.layer[k], y, x, inverse, r, g, b);
            const int n = at.x1 - x0 < lanes ? at.x1 - x0 : lanes;
            if (job.rgb == nullptr) {
                const auto mask = hn::FirstN(du, static_cast<std::size_t>(n));
                hn::BlendedStore(encoded_lanes(r, g, b), mask, du, pixel_rgba(job, x0, y));
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
HWY_INLINE void fill_face(F d, const detail::TileJob& job, const Rectangle& at, const Layer& face) {
    const int lanes = static_cast<int>(hn::Lanes(d));
    const hn::RebindToUnsigned<F> du;
    const Affine cosine = along(*job.camera, face.normal);
    const auto r = hn::Set(d, 255.0f * root(face.scale.x));
    const auto g = hn::Set(d, 255.0f * root(face.scale.y));
    const auto b = hn::Set(d, 255.0f * root(face.scale.z));
    const auto half = hn::Set(d, 0.5f), one = hn::Set(d, 1.0f);
    const auto by_x = hn::Set(d, cosine.by_x);
    for (int y = at.y0; y < at.y1; ++y) {
        const RowLength length = row_length(*job.camera, y);
        const auto la = hn::Set(d, length.a), lb = hn::Set(d, length.b), lc = hn::Set(d, length.c);
        const auto start = hn::Set(d, cosine.row(y));
        std::uint32_t* out = pixel_rgba(job, at.x0, y);
        auto x = centres(d, at.x0);
        const auto step = hn::Set(d, static_cast<float>(lanes));
        const auto pixels = [&]() HWY_ATTR {
            const auto squared = hn::MulAdd(x, hn::MulAdd(x, lc, lb), la);
            const auto lit = hn::Mul(hn::MulAdd(x, by_x, start), hn::ApproximateReciprocalSqrt(squared));
            const auto bright = hn::Min(quick_root(lit), one);
            return packed(du, hn::MulAdd(bright, r, half), hn::MulAdd(bright, g, half), hn::MulAdd(bright, b, half));
        };
        int left = at.x1 - at.x0;
        for (; left >= lanes; left -= lanes) {
            hn::StoreU(pixels(), du, out);
            out += lanes;
            x = hn::Add(x, step);
        }
        if (left > 0) hn::BlendedStore(pixels(), hn::FirstN(du, static_cast<std::size_t>(left)), du, out);
    }
}

/// Fills a rectangle.
HWY_INLINE void fill(const detail::TileJob& job, const Rectangle& at, const Layers& layers) {
    const bool is_plain = job.rgb == nullptr && layers.count == 1 && !layers.layer[0].is_sky;
    const int width = at.x1 - at.x0;
    if (is_plain && (width <= 4 || lane_count <= 4)) fill_face(hn::CappedTag<float, 4>(), job, at, layers.layer[0]);
    else if (is_plain && (width <= 8 || lane_count <= 8))
        fill_face(hn::CappedTag<float, 8>(), job, at, layers.layer[0]);
    else if (is_plain) fill_face(D(), job, at, layers.layer[0]);
    else fill_layers(hn::CappedTag<float, 4>(), job, at, layers);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
