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
    for (int row = y0; row < y1; row += rows) {
        V u[M], v[M], y[M];
        for (V& value : y) value = hn::Add(hn::Load(D(), register_centres<C>.y), hn::Set(D(), static_cast<float>(row)));
        if constexpr (channels == 1) {
            places_on<M>(*first.face, x, y, u, v);
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
    for (; at.x1 - x >= wide * lane_count; x += wide * lane_count)
        light_columns<exact, channels, lane_count, wide>(job, layers, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x > half; x += lane_count)
        light_columns<exact, channels, lane_count, 1>(job, layers, x, at.x1, at.y0, at.y1);
    for (; at.x1 - x > 4; x += half) light_columns<exact, channels, half, 1>(job, layers, x, at.x1, at.y0, at.y1);
    if (x < at.x1) light_columns<exact, channels, 4, 1>(job, layers, x, at.x1, at.y0, at.y1);
}

/// Which of sixteen places on a layer a part lamp lights.
HWY_INLINE Bits lit_by_part(const detail::TileJob& job, const accel::SceneView& scene, const LitLayer& layer,
                            const PartLamp& part, const Floats<16>& u, const Floats<16>& v, Bits some) {
    using F = Floats<16>;
    const FaceLamps& lamps = *layer.lamps;
    for (std::uint32_t e = part.first_edge; e < part.end_edge && some != 0; ++e)
        some &= is_at_most(F(0),
                           fused_lanes(F(lamps.edge_b[e]), u, fused_lanes(F(lamps.edge_c[e]), v, F(lamps.edge_a[e]))));
    if (some == 0 || part.end_object == part.first_object) return some;
    const LitFace& face = *layer.face;
    const Vec3f foot = face.eye + face.away * face.normal;
    const auto place = [&](float at, float by_u, float by_v)
                           HWY_ATTR { return fused_lanes(u, F(by_u), fused_lanes(v, F(by_v), F(at))); };
    const Points<16> point = {place(foot.x, face.along_u.x, face.along_v.x),
                              place(foot.y, face.along_u.y, face.along_v.y),
                              place(foot.z, face.along_u.z, face.along_v.z)};
    const accel::ObjectsOfBeam objects = {lamps.object + part.first_object, part.end_object - part.first_object,
                                          part.must_walk};
    return some & ~in_shade_of(scene, *job.objects, objects, point, scene.lights[index(part.light)], face.cell, some);
}

/// Blocks of 4 x 4 pixels, where objects may throw shadows.
template <bool exact>
HWY_NOINLINE void light_sixteens(const detail::TileJob& job, const accel::SceneView& scene, const LitLayers& layers,
                                 const Rectangle& at) {
    using F = Floats<16>;
    for (int y0 = at.y0; y0 < at.y1; y0 += 4)
        for (int x0 = at.x0; x0 < at.x1; x0 += 4) {
            const F x = load<16>(block_centres<16>.x) + F(static_cast<float>(x0));
            const F y = load<16>(block_centres<16>.y) + F(static_cast<float>(y0));
            const Bits within =
                rays_within<16>({x0, y0, at.x1 - x0 < 4 ? at.x1 : x0 + 4, at.y1 - y0 < 4 ? at.y1 : y0 + 4});
            Light<16> light = {F(0), F(0), F(0)};
            for (int l = 0; l < layers.count; ++l) {
                const LitLayer& layer = layers.layer[l];
                F u, v;
                places_on<F::vectors>(*layer.face, x.v, y.v, u.v, v.v);
                Light<16> sum = {F(0), F(0), F(0)};
                const auto add = [&](const LampOnFace& lamp, Bits lit) HWY_ATTR {
                    F share;
                    for (int m = 0; m < F::vectors; ++m) share.v[m] = share_at<exact>(lamp, u.v[m], v.v[m]);
                    if (lit != all_bits<16>) share = choose(lit, share, F(0));
                    sum = {fused_lanes(share, F(lamp.r), sum.r), fused_lanes(share, F(lamp.g), sum.g),
                           fused_lanes(share, F(lamp.b), sum.b)};
                };
                for (std::uint32_t k = 0; k < layer.span.lit_end; ++k) add(layer.lamps->lit[k], all_bits<16>);
                Bits had = 0;
                for (std::uint32_t k = layer.span.part_begin; k < layer.span.part_end; ++k) {
                    const PartLamp& part = layer.lamps->part[k];
                    if (!part.goes_on) had = 0;
                    const Bits lit = lit_by_part(job, scene, layer, part, u, v, within & ~had);
                    had |= lit;
                    if (lit != 0) add(part.lamp, lit);
                }
                const Vec3f scale = layer.face->scale;
                light = {fused_lanes(sum.r, F(scale.x), light.r), fused_lanes(sum.g, F(scale.y), light.g),
                         fused_lanes(sum.b, F(scale.z), light.b)};
            }
            for (int m = 0; m < F::vectors; ++m) {
                const int row = y0 + m * (lane_count / 4);
                if (row >= at.y1) break;
                if constexpr (exact)
                    store_float_rows<4>(job, light.r.v[m], light.g.v[m], light.b.v[m], x0, row, at.x1, at.y1);
                else store_rows<4>(job, encoded_lanes(light.r.v[m], light.g.v[m], light.b.v[m]), x0, row, at.x1, at.y1);
            }
        }
}

/// Lamps over a rectangle are decided by its quarters, down to this many pixels a side; fewer where objects stand in
/// their light.
inline constexpr int smallest_lit = 16, smallest_shaded = 8;

/// Lights a rectangle, and its quarters by themselves where some lamps light a part of it. lamps: of the layers
HWY_NOINLINE inline void light_rectangle(const detail::TileJob& job, const accel::SceneView& scene,
                                         FaceLamps* const* lamps, const LitLayers& layers, const Rectangle& at) {
    bool is_mixed = false, has_objects = false;
    for (int l = 0; l < layers.count; ++l) {
        is_mixed = is_mixed || layers.layer[l].span.is_mixed();
        has_objects = has_objects || (layers.layer[l].span.is_mixed() && layers.layer[l].span.has_objects);
    }
    const int smallest = has_objects ? smallest_shaded : smallest_lit;
    const int width = at.x1 - at.x0, height = at.y1 - at.y0;
    if (!is_mixed || (width <= smallest && height <= smallest)) {
        if (has_objects)
            return job.rgb != nullptr ? light_sixteens<true>(job, scene, layers, at)
                                      : light_sixteens<false>(job, scene, layers, at);
        if (job.rgb != nullptr) return light_pixels<true, 3>(job, layers, at);
        if (layers.count == 1 && lamps[0]->is_one_colour) return light_pixels<false, 1>(job, layers, at);
        return light_pixels<false, 3>(job, layers, at);
    }
    // Halves of whole blocks.
    const auto half = [&](int length) { return length > smallest ? ((length + 1) / 2 + 3) / 4 * 4 : length; };
    const int xs[3] = {at.x0, at.x0 + half(width), at.x1}, ys[3] = {at.y0, at.y0 + half(height), at.y1};
    for (int q = 0; q < 4; ++q) {
        const Rectangle quarter = {xs[q & 1], ys[q >> 1], xs[(q & 1) + 1], ys[(q >> 1) + 1]};
        if (quarter.x0 >= quarter.x1 || quarter.y0 >= quarter.y1) continue;
        LitLayers narrowed = layers;
        for (int l = 0; l < layers.count; ++l) {
            LitLayer& layer = narrowed.layer[l];
            const FaceCorners corners(*job.camera, *layer.face, quarter);
            if (!lamps[l]->narrow(scene, *layer.face, layers.layer[l].span, corners, layer.span))
                layer.span = layers.layer[l].span;
        }
        light_rectangle(job, scene, lamps, narrowed, quarter);
    }
}

/// Faces that a rectangle of the image sees, and what lights them there: a few are remembered.
class LitFaces {
public:
    LitFaces(const detail::TileJob& job, const accel::SceneView& scene) : job_(job), scene_(scene) {}

    /// For another rectangle.
    HWY_INLINE void see(const Rectangle& at) {
        at_ = at;
        for (Entry& entry : entries_) entry.cell = no_cell;
    }

    /// Lights a rectangle within it that the face fills. False, having done nothing, where that is not known.
    [[nodiscard]] HWY_INLINE bool light(const Way& way, std::uint32_t cell, Vec3f tint, const Rectangle& part) {
        Entry* entry = nullptr;
        for (Entry& one : entries_)
            if (one.cell == cell && one.target == way.target_bits && one.section == way.section) entry = &one;
        if (HWY_UNLIKELY(entry == nullptr)) entry = &made(way, cell);
        if (!entry->is_known) return false;
        const Vec3f colour = colour_of(scene_, scene_.source_faces[way.target_bits]);
        entry->face.scale = lamp_scale(*job_.lamps) * tint * colour;
        LitLayers layers;
        layers.layer[layers.count++] = {&entry->face, &entry->lamps, entry->span};
        if (entry->span.has_objects) {
            const FaceCorners corners(*job_.camera, entry->face, part);
            FaceLamps* const lamps = &entry->lamps;
            if (!entry->lamps.narrow(scene_, entry->face, entry->span, corners, layers.layer[0].span)) return false;
            light_rectangle(job_, scene_, &lamps, layers, part);
        } else if (entry->lamps.is_one_colour) {
            light_pixels<false, 1>(job_, layers, part);
        } else {
            light_pixels<false, 3>(job_, layers, part);
        }
        return true;
    }

private:
    struct Entry {
        std::uint32_t cell = no_cell;  ///< none: not made yet
        std::uint32_t target, section;
        bool is_known;
        LitFace face;
        FaceLamps lamps;
        LampSpan span;

        Entry() {}  // the rest is made when it is needed
    };

    HWY_NOINLINE Entry& made(const Way& way, std::uint32_t cell) {
        Entry& entry = entries_[next_++ % remembered];
        entry.cell = cell;
        entry.target = way.target_bits;
        entry.section = way.section;
        make_lit_face(scene_, *job_.camera, way, cell, nullptr, {1, 1, 1}, entry.face);
        const FaceCorners corners(*job_.camera, entry.face, at_);
        entry.is_known = !entry.face.is_near() && corners.is_sound &&
                         entry.lamps.take_all(job_, scene_, entry.face, corners, entry.span);
        return entry;
    }

    static constexpr std::uint32_t remembered = 4;
    const detail::TileJob& job_;
    const accel::SceneView& scene_;
    Rectangle at_ = {};
    std::uint32_t next_ = 0;
    Entry entries_[remembered];
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
