// Rectangles of the image that one face fills, lit by lamps: a register of pixels meets one lamp after the other.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// A face, and what it is lit by over a rectangle.
struct LitLayer {
    const LitFace* face;
    const FaceLamps* lamps;
    LampSpan span;
};

/// What fills a rectangle: a face, or a floor that mirrors one.
struct LitLayers {
    LitLayer layer[2];
    int count = 0;

    LitLayers() {}  // written when they are added
};

/// 1 / distance^3.
template <bool exact>
HWY_INLINE V inverse_cube(V squared) {
    if constexpr (exact) return hn::Div(hn::Set(D(), 1.0f), hn::Mul(squared, hn::Sqrt(squared)));
    const V inverse = hn::ApproximateReciprocalSqrt(squared);
    return hn::Mul(hn::Mul(inverse, inverse), inverse);
}

/// Light of M registers of pixels, in one channel or three.
template <int M, int channels>
struct LampSums {
    V v[channels][M];

    HWY_INLINE LampSums() {
        for (auto& channel : v)
            for (V& value : channel) value = hn::Zero(D());
    }
    HWY_INLINE void add(const LampOnFace& lamp, int m, V share) {
        if constexpr (channels == 1) {
            v[0][m] = hn::MulAdd(share, hn::Set(D(), lamp.weight), v[0][m]);
        } else {
            v[0][m] = hn::MulAdd(share, hn::Set(D(), lamp.r), v[0][m]);
            v[1][m] = hn::MulAdd(share, hn::Set(D(), lamp.g), v[1][m]);
            v[2][m] = hn::MulAdd(share, hn::Set(D(), lamp.b), v[2][m]);
        }
    }
};

template <bool exact>
HWY_INLINE V share_at(const LampOnFace& lamp, V u, V v) {
    const V du = hn::Sub(u, hn::Set(D(), lamp.u)), dv = hn::Sub(v, hn::Set(D(), lamp.v));
    return inverse_cube<exact>(hn::MulAdd(du, du, hn::MulAdd(dv, dv, hn::Set(D(), lamp.height2))));
}

/// Adds the lamps of a layer to M registers of places on it.
template <bool exact, int M, int channels>
HWY_INLINE void add_lamps(const LitLayer& layer, const V (&u)[M], const V (&v)[M], LampSums<M, channels>& sums) {
    const FaceLamps& lamps = *layer.lamps;
    for (std::uint32_t k = 0; k < layer.span.lit_end; ++k)
        for (int m = 0; m < M; ++m) sums.add(lamps.lit[k], m, share_at<exact>(lamps.lit[k], u[m], v[m]));
    hn::Mask<D> had[M];  // by an earlier beam of the same lamp
    for (std::uint32_t k = layer.span.part_begin; k < layer.span.part_end; ++k) {
        const PartLamp& part = lamps.part[k];
        for (int m = 0; m < M; ++m) {
            const auto inside = [&](std::uint32_t e) HWY_ATTR {
                const V side =
                    hn::MulAdd(hn::Set(D(), lamps.edge_b[e]), u[m],
                               hn::MulAdd(hn::Set(D(), lamps.edge_c[e]), v[m], hn::Set(D(), lamps.edge_a[e])));
                return hn::Ge(side, hn::Zero(D()));
            };
            auto in = inside(part.first_edge);
            for (std::uint32_t e = part.first_edge + 1; e < part.end_edge; ++e) in = hn::And(in, inside(e));
            if (part.goes_on) in = hn::AndNot(had[m], in);
            had[m] = part.goes_on ? hn::Or(had[m], in) : in;
            if (hn::AllFalse(D(), in)) continue;
            sums.add(part.lamp, m, hn::IfThenElseZero(in, share_at<exact>(part.lamp, u[m], v[m])));
        }
    }
}

/// Where M registers of pixels see a face.
template <int M>
HWY_INLINE void places_on(const LitFace& face, const V (&x)[M], const V (&y)[M], V (&u)[M], V (&v)[M]) {
    for (int m = 0; m < M; ++m) {
        const auto value = [&](const Affine& a) HWY_ATTR {
            return hn::MulAdd(y[m], hn::Set(D(), a.by_y),
                              hn::MulAdd(x[m], hn::Set(D(), a.by_x), hn::Set(D(), a.at_corner)));
        };
        const V facing = value(face.facing);
        V inverse = hn::ApproximateReciprocal(facing);
        inverse = hn::Mul(inverse, hn::NegMulAdd(facing, inverse, hn::Set(D(), 2.0f)));
        u[m] = hn::Mul(value(face.over_u), inverse);
        v[m] = hn::Mul(value(face.over_v), inverse);
    }
}

/// What of that depends on x alone.
template <int M>
struct FaceColumns {
    V facing[M], over_u[M], over_v[M];

    HWY_INLINE FaceColumns(const LitFace& face, const V (&x)[M]) {
        for (int m = 0; m < M; ++m) {
            const auto value = [&](const Affine& a) HWY_ATTR {
                return hn::MulAdd(x[m], hn::Set(D(), a.by_x), hn::Set(D(), a.at_corner));
            };
            facing[m] = value(face.facing);
            over_u[m] = value(face.over_u);
            over_v[m] = value(face.over_v);
        }
    }
    HWY_INLINE void places(const LitFace& face, V y, V (&u)[M], V (&v)[M]) const {
        for (int m = 0; m < M; ++m) {
            const V down = hn::MulAdd(y, hn::Set(D(), face.facing.by_y), facing[m]);
            V inverse = hn::ApproximateReciprocal(down);
            inverse = hn::Mul(inverse, hn::NegMulAdd(down, inverse, hn::Set(D(), 2.0f)));
            u[m] = hn::Mul(hn::MulAdd(y, hn::Set(D(), face.over_u.by_y), over_u[m]), inverse);
            v[m] = hn::Mul(hn::MulAdd(y, hn::Set(D(), face.over_v.by_y), over_v[m]), inverse);
        }
    }
};

/// Stores a register of rows of C pixels as floats, as far as they lie within x1 and y1.
template <int C>
HWY_INLINE void store_float_rows(const detail::TileJob& job, V r, V g, V b, int x, int y, int x1, int y1) {
    HWY_ALIGN float part[3 * lane_count];
    hn::StoreInterleaved3(r, g, b, D(), part);
    const int width = x1 - x < C ? x1 - x : C;
    for (int row = 0; row < lane_count / C && y + row < y1; ++row)
        std::memcpy(pixel_rgb(job, x, y + row), part + 3 * row * C,
                    sizeof(float) * 3 * static_cast<std::size_t>(width));
}

/// As full_channel, of light that may be any.
HWY_INLINE float full_channel_beyond(float light) { return 255.0f * root(light > 0 ? light : 0); }

/// M registers beside each other, each of rows of C pixels, from the top to the bottom.
template <bool exact, int channels, int C, int M>
HWY_NOINLINE void light_columns(const detail::TileJob& job, const LitLayers& layers, int x0, int x1, int y0, int y1) {
    constexpr int rows = lane_count / C;
    const V zero = hn::Zero(D());
    V x[M];
    for (int m = 0; m < M; ++m)
        x[m] = hn::Add(hn::Load(D(), register_centres<C>.x), hn::Set(D(), static_cast<float>(x0 + m * C)));
    const LitLayer& first = layers.layer[0];
    const Vec3f shown = first.face->scale * first.lamps->colour;
    const Vec3f full = {full_channel_beyond(shown.x), full_channel_beyond(shown.y), full_channel_beyond(shown.z)};
    const FaceColumns<M> columns(*first.face, x);
    for (int row = y0; row < y1; row += rows) {
        V u[M], v[M], y[M];
        for (V& value : y) value = hn::Add(hn::Load(D(), register_centres<C>.y), hn::Set(D(), static_cast<float>(row)));
        if constexpr (channels == 1) {
            columns.places(*first.face, y[0], u, v);
            LampSums<M, 1> sums;
            add_lamps<exact>(first, u, v, sums);
            const V most = hn::Set(D(), 255.0f), rounding = hn::Set(D(), rounds_to_integer);
            for (int m = 0; m < M; ++m) {
                const V bright = quick_root(sums.v[0][m]);
                const auto channel = [&](float by) HWY_ATTR {
                    return hn::Add(hn::Min(hn::Mul(bright, hn::Set(D(), by)), most), rounding);
                };
                store_rows<C>(job, packed(DU(), channel(full.x), channel(full.y), channel(full.z)), x0 + m * C, row, x1,
                              y1);
            }
        } else {
            V light[3][M];
            for (auto& channel : light)
                for (V& value : channel) value = zero;
            for (int l = 0; l < layers.count; ++l) {
                const LitLayer& layer = layers.layer[l];
                places_on<M>(*layer.face, x, y, u, v);
                LampSums<M, 3> sums;
                add_lamps<exact>(layer, u, v, sums);
                const Vec3f scale = layer.face->scale;
                for (int m = 0; m < M; ++m) {
                    light[0][m] = hn::MulAdd(sums.v[0][m], hn::Set(D(), scale.x), light[0][m]);
                    light[1][m] = hn::MulAdd(sums.v[1][m], hn::Set(D(), scale.y), light[1][m]);
                    light[2][m] = hn::MulAdd(sums.v[2][m], hn::Set(D(), scale.z), light[2][m]);
                }
            }
            for (int m = 0; m < M; ++m) {
                if constexpr (exact)
                    store_float_rows<C>(job, light[0][m], light[1][m], light[2][m], x0 + m * C, row, x1, y1);
                else store_rows<C>(job, encoded_lanes(light[0][m], light[1][m], light[2][m]), x0 + m * C, row, x1, y1);
            }
        }
    }
}

template <bool exact, int channels>
HWY_INLINE void light_pixels(const detail::TileJob& job, const LitLayers& layers, const Rectangle& at) {
    int x = at.x0;
    constexpr int wide = lane_count < 16 ? 1 : 2;
    constexpr int half = lane_count < 8 ? lane_count : lane_count / 2;
    if constexpr (channels == 1 && lane_count == 16)
        for (; at.x1 - x >= 4 * lane_count; x += 4 * lane_count)
            light_columns<exact, channels, lane_count, 4>(job, layers, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x >= wide * lane_count; x += wide * lane_count)
        light_columns<exact, channels, lane_count, wide>(job, layers, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x > half; x += lane_count)
        light_columns<exact, channels, lane_count, 1>(job, layers, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x > 4; x += half) light_columns<exact, channels, half, 1>(job, layers, x, at.x1, at.y0, at.y1);
    if (x < at.x1) light_columns<exact, channels, 4, 1>(job, layers, x, at.x1, at.y0, at.y1);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
