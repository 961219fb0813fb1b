// Which lamps light which parts of a tile: quarter by quarter, face by face.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

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
        for (Key& key : keys_) key.cell = no_cell;
    }

    /// Lights a rectangle within it that the face fills. False, having done nothing, where that is not known.
    [[nodiscard]] HWY_INLINE bool light(const Way& way, std::uint32_t cell, Vec3f tint, const Rectangle& part) {
        Entry& entry = on(way, cell);
        if (!entry.is_known) return false;
        entry.face.scale = lamp_scale(*job_.lamps) * tint * colour_of(scene_, scene_.source_faces[way.target_bits]);
        LitLayers layers;
        layers.layer[layers.count++] = {&entry.face, &entry.lamps, entry.span};
        const bool is_small = part.x1 - part.x0 <= smallest_shaded && !entry.span.has_objects;
        if (is_small || !entry.span.is_mixed()) {
            if (job_.rgb != nullptr) light_pixels<true, 3>(job_, layers, part);
            else if (entry.lamps.is_one_colour) light_pixels<false, 1>(job_, layers, part);
            else light_pixels<false, 3>(job_, layers, part);
            return true;
        }
        const FaceCorners corners(*job_.camera, entry.face, part);
        FaceLamps* const lamps = &entry.lamps;
        if (!entry.lamps.narrow(scene_, entry.face, entry.span, corners, layers.layer[0].span)) return false;
        light_rectangle(job_, scene_, &lamps, layers, part);
        return true;
    }

    /// The same for rays of a block, by the centres of their pixels.
    template <int N>
    [[nodiscard]] HWY_INLINE bool light_rays(const Way& way, std::uint32_t cell, const Floats<N>& x, const Floats<N>& y,
                                             Light<N>& light) {
        using F = Floats<N>;
        Entry& entry = on(way, cell);
        if (!entry.is_known || entry.span.has_objects || job_.rgb != nullptr) return false;
        F u, v;
        places_on<F::vectors>(entry.face, x.v, y.v, u.v, v.v);
        LampSums<F::vectors, 3> sums;
        add_lamps<false>(LitLayer{&entry.face, &entry.lamps, entry.span}, u.v, v.v, sums);
        const Vec3f scale = lamp_scale(*job_.lamps) * colour_of(scene_, scene_.source_faces[way.target_bits]);
        Light<N> own;
        for (int m = 0; m < F::vectors; ++m) {
            own.r.v[m] = hn::Mul(sums.v[0][m], hn::Set(D(), scale.x));
            own.g.v[m] = hn::Mul(sums.v[1][m], hn::Set(D(), scale.y));
            own.b.v[m] = hn::Mul(sums.v[2][m], hn::Set(D(), scale.z));
        }
        light = choose_light(way.rays, own, light);
        return true;
    }

private:
    struct Entry {
        bool is_known;
        LitFace face;
        FaceLamps lamps;
        LampSpan span;

        Entry() {}  // the rest is made when it is needed
    };

    struct Key {
        std::uint32_t cell = no_cell;  ///< none: not made yet
        std::uint32_t target, section;
    };

    [[nodiscard]] HWY_INLINE Entry& on(const Way& way, std::uint32_t cell) {
        for (std::uint32_t k = 0; k < remembered; ++k)
            if (keys_[k].cell == cell && keys_[k].target == way.target_bits && keys_[k].section == way.section)
                return entries_[k];
        return made(way, cell);
    }

    HWY_NOINLINE Entry& made(const Way& way, std::uint32_t cell) {
        const std::uint32_t place = next_++ % remembered;
        keys_[place].cell = cell;
        keys_[place].target = way.target_bits;
        keys_[place].section = way.section;
        Entry& entry = entries_[place];
        entry.span = {};
        make_lit_face(scene_, *job_.camera, way, cell, nullptr, {1, 1, 1}, entry.face);
        const FaceCorners corners(*job_.camera, entry.face, at_);
        entry.is_known = !entry.face.is_near() && corners.is_sound &&
                         entry.lamps.take_all(job_, scene_, entry.face, corners, entry.span);
        return entry;
    }

    static constexpr std::uint32_t remembered = 8;
    const detail::TileJob& job_;
    const accel::SceneView& scene_;
    Rectangle at_ = {};
    std::uint32_t next_ = 0;
    Key keys_[remembered];
    Entry entries_[remembered];
};

/// What lit tiles are decided in: too much to stand on the stack of pictures without lamps.
struct LitMemory {
    LitFaces faces;
    FaceLamps lamps[2];  ///< of faces that are not known for all of a tile

    LitMemory(const detail::TileJob& job, const accel::SceneView& scene) : faces(job, scene) {}
};

/// As light_of, by the scene's lamps. known: what a rectangle around the rays' pixels knows of its faces, or nullptr
template <int N>
HWY_NOINLINE Light<N> lamp_light_of(const Seen<N>& seen, const Rays<N>& rays, const Floats<N>& inverse_length,
                                    const Tints<N>& tints, LitFaces* known, const Floats<N>& x, const Floats<N>& y) {
    Light<N> light = {Floats<N>(0), Floats<N>(0), Floats<N>(0)};
    for (int i = 0; i < seen.ends.size; ++i) {
        const Way& way = seen.ends.way[i];
        if (known != nullptr && known->light_rays(way, seen.ends.cell[i], x, y, light)) continue;
        add_lit_face(seen.job, seen.scene, rays, way, seen.ends.cell[i],
                     colour_of(seen.scene, seen.scene.source_faces[way.target_bits]), light);
    }
    if (seen.has_hits) add_lit_objects(seen, rays, light);
    return with_sky_and_glass(seen, inverse_length, tints, light);
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
