// Packets: a tile of the image is bounded by corner rays. Where the corners of a tile leave a cell by one face, so do
// all its rays, for faces and cells are convex: the tile goes on whole, or is filled. One step decides for four
// quarters at once, by the sixteen corner rays that they have.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// A square of pixels that is cut off by the image's end.
struct Tile {
    int x, y, side;
};

template <class Events>
class Packets {
public:
    static constexpr int corner_count = 16;
    static constexpr int tile_rays = 32;  ///< of blocks in the smallest tiles

    /// memory: where there are lamps
    Packets(const Canvas& canvas, const accel::SceneView& scene, LitMemory* memory, Events& events)
        : canvas_(canvas),
          job_(canvas.job),
          scene_(scene),
          events_(events),
          on_image_(scene, *canvas.job.camera),
          memory_(memory) {}

    /// Traces a tile that no other holds.
    void trace_all(const Tile& tile, const Bundle& from) {
        if (memory_ != nullptr) memory_->faces.see(clipped(tile));
        trace(tile, from, nullptr);
    }

    /// Traces a tile from where its rays are. `around`: the outlooks of a tile that holds this one.
    void trace(const Tile& tile, const Bundle& from, const Outlooks* around) {
        const Rectangle at = clipped(tile);
        if (tile.side <= job_.packets.smallest) return trace_small(at, from, around);
        Bundle bundle = from;
        events_.began_tile();
        Bits present = 0;
        const Points<corner_count> directions = corner_directions(tile, at, present);
        Outlooks outlooks(scene_, *job_.camera, on_image_, at, around);
        EyeRays<corner_count> rays(outlooks, job_.camera->origin, directions);
        if (bundle.is_mirrored) rays.mirror(bundle.mirror_level);
        const std::uint64_t most_steps = scene_.cells.count + 16;
        Ways<corner_count> ways;
        for (std::uint64_t step = 0; step < most_steps; ++step) {
            if (job_.objects != nullptr && sees_objects(outlooks, bundle)) return split_here(tile, bundle, outlooks);
            events_.entered_cell(scene_.cells[bundle.cell].section_count);
            ways.size = 0;
            leave_cell_by(scene_, rays, outlooks.on(bundle.cell), present, ways);
            if (ways.alone != 0 || ways.size != 1) break;
            const Way& way = ways.of[0];
            if (way.target().is_portal()) {
                go_on(way, bundle);
            } else if (!meets_mirror(way, bundle)) {
                return fill_tile(at, way, bundle);
            } else {
                reflect(way, bundle);
                rays.mirror(bundle.mirror_level);
            }
        }
        events_.split_tile();
        split(tile, bundle, ways, outlooks);
    }

private:
    static constexpr Bits quarter_bits = 0xfu;

    [[nodiscard]] HWY_INLINE bool sees_objects(Outlooks& outlooks, const Bundle& bundle) const {
        const ObjectList objects = bundle.is_mirrored ? outlooks.objects.in_mirror(bundle.cell, bundle.mirror_level)
                                                      : outlooks.objects.on(bundle.cell);
        return objects.size != 0;
    }

    /// Where objects stand in the way, quarters may still miss them.
    void split_here(const Tile& tile, const Bundle& bundle, const Outlooks& outlooks) {
        events_.split_tile();
        const int half = tile.side / 2;
        for (int q = 0; q < 4; ++q) {
            const Tile quarter = {tile.x + (q & 1) * half, tile.y + (q >> 1) * half, half};
            const Rectangle at = clipped(quarter);
            if (at.x0 < at.x1 && at.y0 < at.y1) trace(quarter, bundle, &outlooks);
        }
    }

    void trace_small(const Rectangle& at, const Bundle& bundle, const Outlooks* around) {
        Outlooks outlooks(scene_, *job_.camera, on_image_, at, around);
        if (memory_ != nullptr) outlooks.lit = &memory_->faces;
        if (job_.objects != nullptr && sees_objects(outlooks, bundle))
            return trace_blocks<ObjectRays::count>(job_, scene_, bundle, outlooks, at, events_);
        trace_blocks<tile_rays>(job_, scene_, bundle, outlooks, at, events_);
    }

    [[nodiscard]] Rectangle clipped(const Tile& tile) const {
        return {tile.x, tile.y, tile.x + tile.side < job_.x1 ? tile.x + tile.side : job_.x1,
                tile.y + tile.side < job_.y1 ? tile.y + tile.side : job_.y1};
    }

    /// Through the centres of the pixels at the corners of the four quarters; lanes 4 q to 4 q + 3 belong to quarter q.
    /// Quarters beyond the image have none.
    HWY_INLINE Points<corner_count> corner_directions(const Tile& tile, const Rectangle& at, Bits& present) const {
        using F = Floats<corner_count>;
        const int half = tile.side / 2;
        if (HWY_UNLIKELY(at.x1 - at.x0 != tile.side || at.y1 - at.y0 != tile.side))
            return corner_directions_at_the_end(tile, present);
        present = all_bits<corner_count>;
        // Lane by lane: whether it is in the right (lower) quarters, and whether it is its right (lower) corner.
        alignas(64) static constexpr float of_quarter[2][corner_count] = {
            {0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}};
        alignas(64) static constexpr float of_corner[2][corner_count] = {
            {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1}, {0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1}};
        const F quarter(static_cast<float>(half)), corner(static_cast<float>(half - 1));
        const auto place = [&](int axis, int start) HWY_ATTR {
            return fused_lanes(
                load<corner_count>(of_quarter[axis]), quarter,
                fused_lanes(load<corner_count>(of_corner[axis]), corner, F(static_cast<float>(start) + 0.5f)));
        };
        return directions(*job_.camera, place(0, tile.x), place(1, tile.y));
    }

    HWY_NOINLINE Points<corner_count> corner_directions_at_the_end(const Tile& tile, Bits& present) const {
        HWY_ALIGN float x[corner_count];
        HWY_ALIGN float y[corner_count];
        const int half = tile.side / 2;
        present = 0;
        for (int q = 0; q < 4; ++q) {
            const Rectangle at = clipped({tile.x + (q & 1) * half, tile.y + (q >> 1) * half, half});
            if (at.x0 < at.x1 && at.y0 < at.y1) present |= quarter_bits << (4 * q);
            for (int corner = 0; corner < 4; ++corner) {
                x[4 * q + corner] =
                    corner % 2 == 0 ? static_cast<float>(at.x0) + 0.5f : static_cast<float>(at.x1) - 0.5f;
                y[4 * q + corner] =
                    corner / 2 == 0 ? static_cast<float>(at.y0) + 0.5f : static_cast<float>(at.y1) - 0.5f;
            }
        }
        return directions(*job_.camera, load<corner_count>(x), load<corner_count>(y));
    }

    [[nodiscard]] bool meets_mirror(const Way& way, const Bundle& bundle) const {
        return !bundle.is_mirrored && is_mirror(job_, way, scene_.source_faces[way.target_bits]);
    }

    void go_on(const Way& way, Bundle& bundle) {
        if (way.target().is_glass()) {
            bundle.tint = bundle.tint * tint_of(scene_, bundle.cell, way.exit, way.face);
            events_.crossed_glass();
        }
        bundle.came_from = bundle.cell;
        bundle.came_by = way.exit;
        bundle.section = way.section;
        bundle.next_section = way.next_section;
        bundle.cell = static_cast<std::uint32_t>(way.target().neighbour());
    }

    /// What a face adds, seen by the bundle. Written in place, number by number: copies wait for what was just written.
    HWY_INLINE void see(const Way& way, const Bundle& bundle, Layer& layer) const {
        const accel::SourceFace& face = scene_.source_faces[way.target_bits];
        layer.turn = bundle.is_mirrored ? -1.0f : 1.0f;
        layer.is_sky = face.surface == accel::Surface::Sky;
        if (layer.is_sky) {
            layer.scale = bundle.tint;
            return;
        }
        const Vec3f n = outward_normal(scene_, way);
        layer.normal.x = n.x;
        layer.normal.y = n.y;
        layer.normal.z = layer.turn * n.z;
        const Vec3f colour = colour_of(scene_, face);
        layer.scale.x = bundle.tint.x * colour.x;
        layer.scale.y = bundle.tint.y * colour.y;
        layer.scale.z = bundle.tint.z * colour.z;
    }

    void reflect(const Way& way, Bundle& bundle) const {
        const Vec3f light = bundle.tint * colour_of(scene_, scene_.source_faces[way.target_bits]);
        bundle.floor = (1 - job_.mirror_floor) * light;
        bundle.tint = job_.mirror_floor * bundle.tint;
        bundle.is_mirrored = true;
        bundle.floor_cell = bundle.cell;
        bundle.came_from = no_cell;
        bundle.mirror_level = scene_.cells[bundle.cell].z_floor;
    }

    /// Lights the rectangle that a face fills. False, having done nothing, for the sky.
    bool light_tile(const Rectangle& at, const Way& way, const Bundle& bundle) {
        const accel::SourceFace& seen = scene_.source_faces[way.target_bits];
        const bool is_sky = seen.surface == accel::Surface::Sky;
        if (is_sky && !bundle.is_mirrored) return false;
        if (!bundle.is_mirrored && memory_->faces.light(way, bundle.cell, bundle.tint, at)) {
            events_.filled_tile(static_cast<std::uint64_t>(at.x1 - at.x0) * static_cast<std::uint64_t>(at.y1 - at.y0));
            return true;
        }
        const float shown = lamp_scale(*job_.lamps);
        LitFace faces[2];
        LitLayers layers;
        bool is_whole = !is_sky;
        if (bundle.is_mirrored)
            make_lit_face(scene_, *job_.camera, floor_way(scene_, bundle), bundle.floor_cell, nullptr,
                          shown * bundle.floor, faces[layers.count++]);
        if (is_whole)
            make_lit_face(scene_, *job_.camera, way, bundle.cell, bundle.is_mirrored ? &bundle.mirror_level : nullptr,
                          shown * bundle.tint * colour_of(scene_, seen), faces[layers.count++]);
        for (int l = 0; l < layers.count && is_whole; ++l) {
            const FaceCorners corners(*job_.camera, faces[l], at);
            layers.layer[l] = {&faces[l], &memory_->lamps[l], {}};
            is_whole = !faces[l].is_near() && corners.is_sound &&
                       memory_->lamps[l].take_all(job_, scene_, faces[l], corners, layers.layer[l].span);
        }
        if (is_whole) {
            FaceLamps* const lamps[2] = {&memory_->lamps[0], &memory_->lamps[1]};
            light_rectangle(job_, scene_, lamps, layers, at);
            events_.filled_tile(static_cast<std::uint64_t>(at.x1 - at.x0) * static_cast<std::uint64_t>(at.y1 - at.y0));
        } else {
            Outlooks outlooks(scene_, *job_.camera, on_image_, at, nullptr);
            trace_blocks<tile_rays>(job_, scene_, bundle, outlooks, at, events_);
        }
        return true;
    }

    void fill_tile(const Rectangle& at, const Way& way, const Bundle& bundle) {
        if (memory_ != nullptr && light_tile(at, way, bundle)) return;
        Layers layers;
        if (bundle.is_mirrored) layers.layer[layers.count++] = {false, 1, {0, 0, -1}, bundle.floor};
        see(way, bundle, layers.layer[layers.count++]);
        fill(canvas_, at, layers);
        events_.filled_tile(static_cast<std::uint64_t>(at.x1 - at.x0) * static_cast<std::uint64_t>(at.y1 - at.y0));
    }

    /// Quarters whose corners agree go on by themselves, the others from this cell.
    void split(const Tile& tile, const Bundle& bundle, const Ways<corner_count>& ways, const Outlooks& outlooks) {
        const int half = tile.side / 2;
        for (int q = 0; q < 4; ++q) {
            const Tile quarter = {tile.x + (q & 1) * half, tile.y + (q >> 1) * half, half};
            const Rectangle at = clipped(quarter);
            if (at.x0 >= at.x1 || at.y0 >= at.y1) continue;
            const Bits bits = quarter_bits << (4 * q);
            const Way* one = nullptr;
            for (int i = 0; i < ways.size; ++i)
                if ((ways.of[i].rays & bits) == bits) one = &ways.of[i];
            Bundle part = bundle;
            if (one == nullptr) {
                trace(quarter, part, &outlooks);
            } else if (one->target().is_portal()) {
                go_on(*one, part);
                trace(quarter, part, &outlooks);
            } else if (!meets_mirror(*one, part)) {
                fill_tile(at, *one, part);
            } else {
                reflect(*one, part);
                trace(quarter, part, &outlooks);
            }
        }
    }

    const Canvas& canvas_;
    const detail::TileJob& job_;
    const accel::SceneView& scene_;
    Events& events_;
    ObjectsOnImage on_image_;
    LitMemory* memory_;
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
