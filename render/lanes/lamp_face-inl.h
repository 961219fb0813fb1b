// A face that fills a rectangle of pixels, and which lamps light how much of it: beams are convex, and so is the part
// of the face that a rectangle shows. Where its four corners lie on the inner side of a beam's plane, so does all of
// it; where all lie beyond one plane, the lamp is dark there by this way. What is undecided goes on to the quarters. No
// include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// A face of a cell as the camera's rays meet it, in coordinates of its own: metres from the eye's foot on its plane.
struct LitFace {
    std::uint32_t cell;
    Vec3f eye;                       ///< or its image in a floor
    Vec3f normal, along_u, along_v;  ///< of length 1; the normal on the light's side
    float away;                      ///< from the eye to the plane, along the normal: negative
    Affine facing;                   ///< normal . direction: negative
    Affine over_u, over_v;           ///< a pixel's place is (over_u, over_v) / facing
    Vec3f scale;                     ///< what lux become in the picture

    /// Nearer to its plane than this a point's place on it is noise over noise.
    [[nodiscard]] HWY_INLINE bool is_near() const { return !(away < -0x1p-8f); }
};

/// The rays of a bundle that leave its cell by one way. mirror: height of the floor that has mirrored them, or nullptr.
HWY_INLINE void make_lit_face(const accel::SceneView& scene, const CameraFrame& camera, const Way& way,
                              std::uint32_t cell, const float* mirror, Vec3f scale, LitFace& face) {
    face.cell = cell;
    face.eye = camera.origin;
    if (mirror != nullptr) face.eye.z = *mirror + (*mirror - face.eye.z);
    face.normal = -outward_normal(scene, way);
    face.along_v = {0, 0, 1};
    if (way.exit == Exit::Side) {
        const double px = scene.section_x[way.section], py = scene.section_y[way.section];
        const double ex = scene.section_x[way.next_section] - px, ey = scene.section_y[way.next_section] - py;
        const double inverse = 1 / std::sqrt(ex * ex + ey * ey);
        face.along_u = {static_cast<float>(ex * inverse), static_cast<float>(ey * inverse), 0};
        face.away = static_cast<float>((ex * (py - double{face.eye.y}) - ey * (px - double{face.eye.x})) * inverse);
    } else {
        const accel::Cell& c = scene.cells[cell];
        face.along_u = {1, 0, 0};
        face.along_v = {0, 1, 0};
        face.away = face.normal.z * ((way.exit == Exit::Floor ? c.z_floor : c.z_ceiling) - face.eye.z);
    }
    const float turn = mirror != nullptr ? -1.0f : 1.0f;
    const auto over_image = [&](Vec3f axis) {
        axis.z *= turn;
        return along(camera, axis);
    };
    face.facing = over_image(face.normal);
    face.over_u = over_image(face.away * face.along_u);
    face.over_v = over_image(face.away * face.along_v);
    face.scale = scale;
}

/// Where the pixels at the corners of a rectangle see the face.
struct FaceCorners {
    float u[4], v[4];
    bool is_sound = true;  ///< else it is seen so much from the side that they may lie anywhere

    HWY_INLINE FaceCorners(const CameraFrame& camera, const LitFace& face, const Rectangle& at) {
        const float x[2] = {static_cast<float>(at.x0) + 0.5f, static_cast<float>(at.x1) - 0.5f};
        const float y[2] = {static_cast<float>(at.y0) + 0.5f, static_cast<float>(at.y1) - 0.5f};
        for (int i = 0; i < 4; ++i) {
            const auto value = [&](const Affine& a) { return a.at_corner + x[i % 2] * a.by_x + y[i / 2] * a.by_y; };
            const Vec3f d = camera.direction(x[i % 2], y[i / 2]);
            const float facing = value(face.facing);
            constexpr float least = 1e-4f;
            is_sound = is_sound && facing < 0 && facing * facing > least * least * dot(d, d);
            u[i] = value(face.over_u) / facing;
            v[i] = value(face.over_v) / facing;
        }
    }
};

/// A lamp in the face's coordinates. Colours are candela times the lamp's height over the face, through its glass.
struct LampOnFace {
    float u, v;
    float height2;  ///< squared
    float weight;   ///< the sum of the colour
    float r, g, b;
    float reserved;
};

/// A lamp that lights a part of a rectangle: where all its edges are 0 or more, and none of its objects is in the way.
struct PartLamp {
    LampOnFace lamp;
    std::uint32_t first_edge, end_edge;
    std::uint32_t first_object, end_object;
    accel::LightId light;
    bool must_walk;  ///< where an object meets: it may be cut off behind its room's wall
    bool goes_on;    ///< another beam of the lamp before
};

/// What of the stacks of FaceLamps a rectangle has: the lamps that light all of it, and those that light a part.
struct LampSpan {
    std::uint32_t lit_end;
    std::uint32_t part_begin, part_end;
    bool has_objects;  ///< some of the parts

    [[nodiscard]] HWY_INLINE bool is_mixed() const { return part_end > part_begin; }
};

/// The lamps of a face, in stacks: a rectangle's quarters add theirs and take them off again.
class FaceLamps {
public:
    static constexpr std::uint32_t most_lamps = 512;
    static constexpr std::uint32_t most_edges = 2048;
    static constexpr std::uint32_t most_objects = 4096;

    LampOnFace lit[most_lamps];
    PartLamp part[most_lamps];
    alignas(64) float edge_a[most_edges + 16], edge_b[most_edges + 16], edge_c[most_edges + 16];
    accel::ObjectId object[most_objects];
    Vec3f colour;        ///< of the first lamp
    bool is_one_colour;  ///< that of all, but for brightness

    FaceLamps() {}  // what is read was written

    /// The lamps of the face's cell over a rectangle. False where there are too many, one without
    /// tree, or where trees are not asked.
    [[nodiscard]] HWY_NOINLINE bool take_all(const detail::TileJob& job, const accel::SceneView& scene,
                                             const LitFace& face, const FaceCorners& at, LampSpan& span) {
        const accel::LightTreesView& trees = job.lamps->trees;
        if (job.lamps->search != LampSearch::Tree) return false;
        lit_top_ = part_top_ = edge_top_ = object_top_ = 0;
        span.has_objects = false;
        is_one_colour = true;
        const std::uint32_t end = trees.cell_offsets[face.cell + 1];
        std::uint32_t next = trees.cell_offsets[face.cell];
        for (std::uint32_t k = next; k < end; k = next) {
            next = end_of_lamp(trees, k, end);
            if (trees.cell_lights[k].beam == accel::no_beam || is_full()) return false;
            const accel::Light& lamp = scene.lights[index(trees.cell_lights[k].light)];
            const Vec3f away = place_of(lamp) - face.eye;
            float height = dot(face.normal, away) - face.away;
            if (!(height > 0)) continue;
            constexpr float least_height = 1e-6f;  // of which the square over its cube is largest_share
            height = height < least_height ? least_height : height;
            const Vec3f foot = face.away * face.normal - away;  // from the lamp to the eye's foot
            const std::uint32_t first_part = part_top_;
            for (; k < next; ++k) {
                const std::uint32_t beam = trees.cell_lights[k].beam;
                if (is_full()) return false;
                PartLamp taken;
                taken.first_edge = edge_top_;
                taken.first_object = object_top_;
                if (!take_planes(trees, trees.planes_of(beam), face, foot, at)) continue;
                const Vec3f light = height * tint_of(trees, beam) * intensity_of(lamp);
                taken.lamp.u = dot(face.along_u, away);
                taken.lamp.v = dot(face.along_v, away);
                taken.lamp.height2 = height * height;
                taken.lamp.weight = light.x + light.y + light.z;
                taken.lamp.r = light.x;
                taken.lamp.g = light.y;
                taken.lamp.b = light.z;
                taken.light = trees.cell_lights[k].light;
                if (job.objects != nullptr) {
                    const accel::ObjectsOfBeam objects = trees.objects_of(beam);
                    taken.must_walk = objects.must_walk;
                    if (object_top_ + objects.count > most_objects) return false;
                    take_objects(scene, objects.first, objects.count, place_of(lamp), face, height, at);
                }
                note_colour(light);
                if (add(taken, first_part, span)) break;
            }
        }
        span.lit_end = lit_top_;
        span.part_begin = 0;
        span.part_end = part_top_;
        return true;
    }

    /// What a rectangle within another one has of its lamps. False where there are too many.
    [[nodiscard]] HWY_NOINLINE bool narrow(const accel::SceneView& scene, const LitFace& face, const LampSpan& wider,
                                           const FaceCorners& at, LampSpan& span) {
        lit_top_ = wider.lit_end;
        part_top_ = wider.part_end;
        edge_top_ = wider.is_mixed() ? part[wider.part_end - 1].end_edge : 0;
        object_top_ = wider.is_mixed() ? part[wider.part_end - 1].end_object : 0;
        span.part_begin = part_top_;
        span.has_objects = false;
        std::uint32_t first_part = part_top_;
        bool is_lit = false;
        for (std::uint32_t k = wider.part_begin; k < wider.part_end; ++k) {
            const PartLamp& from = part[k];
            if (!from.goes_on) {
                first_part = part_top_;
                is_lit = false;
            }
            if (is_lit) continue;
            if (is_full()) return false;
            PartLamp taken = from;
            taken.first_edge = edge_top_;
            taken.first_object = object_top_;
            if (!take_edges(from.first_edge, from.end_edge, at)) continue;
            if (from.end_object > from.first_object) {
                const std::uint32_t count = from.end_object - from.first_object;
                if (object_top_ + count > most_objects) return false;
                take_objects(scene, object + from.first_object, count, place_of(scene.lights[index(from.light)]), face,
                             root(from.lamp.height2), at);
            }
            is_lit = add(taken, first_part, span);
        }
        span.lit_end = lit_top_;
        span.part_end = part_top_;
        return true;
    }

private:
    [[nodiscard]] HWY_INLINE bool is_full() const {
        constexpr std::uint32_t of_a_beam = 1024;
        return lit_top_ == most_lamps || part_top_ == most_lamps || edge_top_ > most_edges - of_a_beam;
    }

    HWY_INLINE void note_colour(Vec3f light) {
        if (lit_top_ + part_top_ == 0) {
            const float sum = light.x + light.y + light.z;
            colour = (1 / (sum > 0 ? sum : 1)) * light;
            return;
        }
        const float sum = light.x + light.y + light.z;
        const Vec3f off = light - sum * colour;
        is_one_colour = is_one_colour && magnitude(off.x) + magnitude(off.y) + magnitude(off.z) <= 1e-6f * sum;
    }

    /// Adds what edges and objects are left of a beam. True where it holds all: then other beams of its lamp have
    /// nothing left.
    HWY_INLINE bool add(PartLamp& taken, std::uint32_t first_part, LampSpan& span) {
        taken.end_edge = edge_top_;
        taken.end_object = object_top_;
        const bool holds_all = taken.first_edge == edge_top_;
        if (holds_all) part_top_ = first_part;
        if (holds_all && taken.first_object == object_top_) {
            lit[lit_top_++] = taken.lamp;
            return true;
        }
        taken.goes_on = part_top_ != first_part;
        span.has_objects = span.has_objects || taken.first_object != object_top_;
        part[part_top_++] = taken;
        return holds_all;
    }

    /// Those that the way from the lamp to the rectangle may meet.
    HWY_NOINLINE void take_objects(const accel::SceneView& scene, const accel::ObjectId* objects, std::uint32_t count,
                                   Vec3f lamp, const LitFace& face, float height, const FaceCorners& at) {
        if (count == 0) return;
        const Vec3f foot = face.eye + face.away * face.normal - lamp;
        Vec3f corners[4];
        for (int i = 0; i < 4; ++i) corners[i] = foot + at.u[i] * face.along_u + at.v[i] * face.along_v;
        const LampPyramid pyramid(corners, face.normal, height);
        for (std::uint32_t k = 0; k < count; ++k) {
            const accel::PlacedObject& placed = scene.objects[index(objects[k])];
            const Vec3f low = {placed.low[0], placed.low[1], placed.low[2]};
            const Vec3f high = {placed.high[0], placed.high[1], placed.high[2]};
            if (pyramid.may_meet(0.5f * (low + high) - lamp, 0.5f * (high - low))) object[object_top_++] = objects[k];
        }
    }

    /// Keeps those of a register of edges on both sides of which corners lie. False: all corners lie beyond one.
    HWY_INLINE bool sift(V a, V b, V c, hn::Mask<D> present, const FaceCorners& at) {
        const V zero = hn::Zero(D());
        hn::Mask<D> all_out = present, some_out = hn::FirstN(D(), 0);
        for (int i = 0; i < 4; ++i) {
            const V s = hn::MulAdd(b, hn::Set(D(), at.u[i]), hn::MulAdd(c, hn::Set(D(), at.v[i]), a));
            const auto out = hn::Lt(s, zero);
            all_out = hn::And(all_out, out);
            some_out = hn::Or(some_out, out);
        }
        if (!hn::AllFalse(D(), all_out)) return false;
        const auto crossing = hn::And(some_out, present);
        const std::size_t count = hn::CountTrue(D(), crossing);
        if (count == 0) return true;
        hn::StoreU(hn::Compress(a, crossing), D(), edge_a + edge_top_);
        hn::StoreU(hn::Compress(b, crossing), D(), edge_b + edge_top_);
        hn::StoreU(hn::Compress(c, crossing), D(), edge_c + edge_top_);
        edge_top_ += static_cast<std::uint32_t>(count);
        return true;
    }

    HWY_INLINE bool take_edges(std::uint32_t first, std::uint32_t end, const FaceCorners& at) {
        const std::uint32_t before = edge_top_;
        for (std::uint32_t k = first; k < end; k += lane_count) {
            const auto present = hn::FirstN(D(), end - k);
            if (sift(hn::LoadU(D(), edge_a + k), hn::LoadU(D(), edge_b + k), hn::LoadU(D(), edge_c + k), present, at))
                continue;
            edge_top_ = before;
            return false;
        }
        return true;
    }

    /// Planes through the lamp as edges on the face: foot . plane + u (along_u . plane) + v (along_v . plane).
    HWY_INLINE bool take_planes(const accel::LightTreesView& trees, const accel::PlanesOfBeam& planes,
                                const LitFace& face, Vec3f foot, const FaceCorners& at) {
        const std::uint32_t before = edge_top_;
        const auto* const last = trees.planes.first + trees.planes.count;
        for (std::uint32_t k = 0; k < planes.count; k += lane_count) {
            const std::uint32_t left = planes.count - k;
            const auto* from = reinterpret_cast<const float*>(planes.first + k);
            alignas(64) float copied[3 * lane_count];
            if (HWY_UNLIKELY(last - (planes.first + k) < lane_count)) {  // nothing behind the last plane is read
                std::memset(copied, 0, sizeof copied);
                std::memcpy(copied, from, sizeof(accel::BeamPlane) * (left < lane_count ? left : lane_count));
                from = copied;
            }
            V x, y, z;
            hn::LoadInterleaved3(D(), from, x, y, z);
            const auto along = [&](Vec3f axis) HWY_ATTR {
                return hn::MulAdd(x, hn::Set(D(), axis.x),
                                  hn::MulAdd(y, hn::Set(D(), axis.y), hn::Mul(z, hn::Set(D(), axis.z))));
            };
            const auto present = hn::FirstN(D(), left);
            if (sift(along(foot), along(face.along_u), along(face.along_v), present, at)) continue;
            edge_top_ = before;
            return false;
        }
        return true;
    }

    std::uint32_t lit_top_, part_top_, edge_top_, object_top_;
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
