// Rectangles of the image that one face fills: Lambert's cosine is affine over the image, over the length of the
// direction. Sixteen pixels an instruction.
// No include guard: lanes.cpp includes it once for every instruction set.

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

    Layers() {}  // written when they are added
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

/// A channel of a pixel that faces the light, of 255. The cosine's root, by which it is multiplied, is at most 1 by
/// what is lost in approximating it, which rounding takes off.
HWY_INLINE float full_channel(float colour) { return 255.0f * (colour < 1 ? root(colour) : 1.0f); }

/// One face into a framebuffer: root(cosine) times the roots of its colour's channels.
struct FaceFill {
    const Canvas& canvas;
    Affine cosine;
    V r, g, b;

    HWY_INLINE FaceFill(const Canvas& canvas_, const Layer& face)
        : canvas(canvas_),
          cosine(along(*canvas_.job.camera, face.normal)),
          r(hn::Set(D(), full_channel(face.scale.x))),
          g(hn::Set(D(), full_channel(face.scale.y))),
          b(hn::Set(D(), full_channel(face.scale.z))) {}
};

/// Centres of the pixels that one register holds: rows of C.
template <int C>
struct RegisterCentres {
    alignas(64) float x[lane_count];
    alignas(64) float y[lane_count];
    constexpr RegisterCentres() : x(), y() {
        for (int i = 0; i < lane_count; ++i) {
            x[i] = static_cast<float>(i % C) + 0.5f;
            y[i] = static_cast<float>(i / C) + 0.5f;
        }
    }
};
template <int C>
inline constexpr RegisterCentres<C> register_centres;

/// Stores a register of rows of C pixels, as far as they lie within x1 and y1.
template <int C>
HWY_INLINE void store_rows(const detail::TileJob& job, hn::Vec<DU> pixels, int x, int y, int x1, int y1) {
    constexpr int rows = lane_count / C;
    if (rows == 1 && x + C <= x1) return hn::StoreU(pixels, DU(), pixel_rgba(job, x, y));
    HWY_ALIGN std::uint32_t part[lane_count];
    hn::Store(pixels, DU(), part);
    const int width = x1 - x < C ? x1 - x : C;
    for (int row = 0; row < rows && y + row < y1; ++row) {
        if (HWY_LIKELY(width == C)) std::memcpy(pixel_rgba(job, x, y + row), part + row * C, sizeof *part * C);
        else std::memcpy(pixel_rgba(job, x, y + row), part + row * C, sizeof *part * static_cast<std::size_t>(width));
    }
}

/// M registers beside each other, each of rows of C pixels, from the top to the bottom: what depends on x alone is
/// computed once.
template <int C, int M>
HWY_INLINE void fill_columns(const FaceFill& face, int x0, int x1, int y0, int y1) {
    constexpr int rows = lane_count / C;
    const Lengths& lengths = face.canvas.lengths;
    V of_x[M], by_y[M], facing_of_x[M];
    for (int m = 0; m < M; ++m) {
        const V x = hn::Add(hn::Load(D(), register_centres<C>.x), hn::Set(D(), static_cast<float>(x0 + m * C)));
        of_x[m] = hn::MulAdd(x, hn::MulAdd(x, hn::Set(D(), lengths.by_xx), hn::Set(D(), lengths.by_x)),
                             hn::Set(D(), lengths.of_corner));
        by_y[m] = hn::MulAdd(x, hn::Set(D(), lengths.by_xy), hn::Set(D(), lengths.by_y));
        facing_of_x[m] = hn::MulAdd(x, hn::Set(D(), face.cosine.by_x), hn::Set(D(), face.cosine.at_corner));
    }
    const V by_yy = hn::Set(D(), lengths.by_yy), facing_by_y = hn::Set(D(), face.cosine.by_y);
    const V rounding = hn::Set(D(), rounds_to_integer), step = hn::Set(D(), static_cast<float>(rows));
    V y = hn::Add(hn::Load(D(), register_centres<C>.y), hn::Set(D(), static_cast<float>(y0)));
    for (int row = y0; row < y1; row += rows, y = hn::Add(y, step)) {
        for (int m = 0; m < M; ++m) {
            const V squared = hn::MulAdd(y, hn::MulAdd(y, by_yy, by_y[m]), of_x[m]);
            const V facing = hn::MulAdd(y, facing_by_y, facing_of_x[m]);
            const V bright = quick_root(hn::Mul(facing, hn::ApproximateReciprocalSqrt(squared)));
            store_rows<C>(face.canvas.job,
                          packed(DU(), hn::MulAdd(bright, face.r, rounding), hn::MulAdd(bright, face.g, rounding),
                                 hn::MulAdd(bright, face.b, rounding)),
                          x0 + m * C, row, x1, y1);
        }
    }
}

HWY_INLINE void fill_face(const Canvas& canvas, const Rectangle& at, const Layer& layer) {
    const FaceFill face(canvas, layer);
    int x = at.x0;
    for (; at.x1 - x >= 4 * lane_count; x += 4 * lane_count) fill_columns<lane_count, 4>(face, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x >= 2 * lane_count; x += 2 * lane_count) fill_columns<lane_count, 2>(face, x, at.x1, at.y0, at.y1);
    constexpr int half = lane_count < 8 ? lane_count : lane_count / 2;
    for (; at.x1 - x > half; x += lane_count) fill_columns<lane_count, 1>(face, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x > 4; x += half) fill_columns<half, 1>(face, x, at.x1, at.y0, at.y1);
    if (x < at.x1) fill_columns<4, 1>(face, x, at.x1, at.y0, at.y1);
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
    if (is_plain) fill_face(canvas, at, layers.layer[0]);
    else by_width([&](auto d) HWY_ATTR { fill_layers(d, canvas, at, layers); });
}

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

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
