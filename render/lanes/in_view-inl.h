// The objects of a cell that rays through a rectangle of the image may meet.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Pixels of the image: x0 to x1 - 1, y0 to y1 - 1.
struct Rectangle {
    int x0, y0, x1, y1;
};

/// From points to pixels: p - eye = s (x du + y dv + corner), so that s x, s y and s are linear in p.
struct Projection {
    Vec3f eye, sx, sy, s;

    HWY_INLINE explicit Projection(const CameraFrame& camera) : eye(camera.origin) {
        const float over = 1.0f / dot(camera.corner, cross(camera.du, camera.dv));
        sx = over * cross(camera.dv, camera.corner);
        sy = over * cross(camera.corner, camera.du);
        s = over * cross(camera.du, camera.dv);
    }
};

/// A box by its middle and three half edges.
struct TurnedBox {
    Vec3f middle, half[3];

    HWY_INLINE TurnedBox(const accel::ObjectMesh& mesh, const accel::PlacedObject& object) {
        const float* m = object.scene_from_object.rows.data();
        const float *low = mesh.low.data(), *high = mesh.high.data();
        middle = {m[3], m[7], m[11]};
        for (int k = 0; k < 3; ++k) {
            const Vec3f axis = {m[k], m[4 + k], m[8 + k]};
            middle = middle + (0.5f * (low[k] + high[k])) * axis;
            half[k] = (0.5f * (high[k] - low[k])) * axis;
        }
    }
    /// As a level floor mirrors it.
    HWY_INLINE void mirror(float floor) {
        middle.z = floor + (floor - middle.z);
        for (Vec3f& h : half) h.z = -h.z;
    }
};

/// Where on the image a box is seen, rather more than less, and how near it comes. x0 > x1: behind the eye.
struct Shadow {
    float x0, x1, y0, y1;
    float nearness;  ///< along the camera's axis
};

inline constexpr float endless = 1e9f;

/// Of a box through the plane of the eye: of its part before that.
HWY_NOINLINE inline Shadow cut_shadow(const float* s, const float* sx, const float* sy, float nearest) {
    // Nearer than this only what touches the eye is on the image.
    constexpr float least = 1e-4f;
    Shadow shadow = {endless, -endless, endless, -endless, nearest};
    const auto add = [&](float at, float x, float y) {
        shadow.x0 = x / at < shadow.x0 ? x / at : shadow.x0;
        shadow.x1 = x / at > shadow.x1 ? x / at : shadow.x1;
        shadow.y0 = y / at < shadow.y0 ? y / at : shadow.y0;
        shadow.y1 = y / at > shadow.y1 ? y / at : shadow.y1;
    };
    for (int i = 0; i < 8; ++i) {
        if (s[i] >= least) add(s[i], sx[i], sy[i]);
        for (int axis = 1; axis < 8; axis *= 2) {
            const int j = i | axis;
            if (j == i || (s[i] >= least) == (s[j] >= least)) continue;
            const float share = (least - s[i]) / (s[j] - s[i]);
            add(least, sx[i] + share * (sx[j] - sx[i]), sy[i] + share * (sy[j] - sy[i]));
        }
    }
    const auto less = [](float x) { return x - (1 + 1e-5f * magnitude(x)); };
    const auto more = [](float x) { return x + (1 + 1e-5f * magnitude(x)); };
    return {less(shadow.x0), more(shadow.x1), less(shadow.y0), more(shadow.y1), nearest};
}

/// Whether the eye lies in the box, or a centimetre from it.
HWY_INLINE bool is_at(const TurnedBox& box, Vec3f eye) {
    const Vec3f away = eye - box.middle;
    for (const Vec3f& h : box.half) {
        const float size = dot(h, h), along = magnitude(dot(away, h));
        if (along > size + 0.01f * root(size)) return false;
    }
    return true;
}

HWY_INLINE Shadow shadow_of(const TurnedBox& box, const Projection& onto) {
    using F = Floats<16>;
    alignas(64) static constexpr float signs[3][16] = {{-1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1},
                                                       {-1, -1, 1, 1, -1, -1, 1, 1, -1, -1, 1, 1, -1, -1, 1, 1},
                                                       {-1, -1, -1, -1, 1, 1, 1, 1, -1, -1, -1, -1, 1, 1, 1, 1}};
    const F first = load<16>(signs[0]), second = load<16>(signs[1]), third = load<16>(signs[2]);
    const auto along = [&](Vec3f axis) HWY_ATTR {
        return fused_lanes(
            first, F(dot(axis, box.half[0])),
            fused_lanes(second, F(dot(axis, box.half[1])),
                        fused_lanes(third, F(dot(axis, box.half[2])), F(dot(axis, box.middle - onto.eye)))));
    };
    const F s = along(onto.s);
    const float nearest = least_lane(s);
    constexpr float at_eye = 1e-3f;
    if (HWY_UNLIKELY(!(nearest > at_eye))) {
        if (largest_lane(s) < -at_eye) return {1, 0, 1, 0, nearest};
        if (is_at(box, onto.eye)) return {-endless, endless, -endless, endless, nearest};
        float numbers[3][16];
        store(s, numbers[0]);
        store(along(onto.sx), numbers[1]);
        store(along(onto.sy), numbers[2]);
        return cut_shadow(numbers[0], numbers[1], numbers[2], nearest);
    }
    const F x = along(onto.sx) / s, y = along(onto.sy) / s;
    constexpr float margin = 0.5f;  // more than rounding
    return {least_lane(x) - margin, largest_lane(x) + margin, least_lane(y) - margin, largest_lane(y) + margin,
            nearest};
}

/// Objects of a cell, by how near their boxes come, and where they are seen.
struct CellObjects {
    static constexpr std::uint32_t most = 96;
    static constexpr std::uint32_t room = most + 16;  ///< whole registers are written
    std::uint32_t key = no_section;                   ///< none: not made yet
    std::uint32_t size;
    bool is_known;  ///< else there are too many
    alignas(64) float x0[room], x1[room], y0[room], y1[room];
    alignas(64) accel::ObjectId of[room];

    CellObjects() {}  // the rest is made when it is needed

    /// All objects of a cell that lie before the eye.
    HWY_NOINLINE void make(const accel::SceneView& scene, const Projection& onto, const accel::ObjectId* all,
                           std::uint32_t count, const float* floor) {
        size = 0;
        is_known = count <= most;
        if (!is_known) return;
        Shadow seen[most];
        std::uint8_t order[most];
        for (std::uint32_t k = 0; k < count; ++k) {
            const accel::PlacedObject& object = scene.objects[index(all[k])];
            TurnedBox box(scene.meshes[index(object.mesh)], object);
            if (floor != nullptr) box.mirror(*floor);
            seen[k] = shadow_of(box, onto);
            const Shadow& s = seen[k];
            if (s.x0 > s.x1) continue;
            std::uint32_t place = size++;
            for (; place > 0 && seen[order[place - 1]].nearness > s.nearness; --place) order[place] = order[place - 1];
            order[place] = static_cast<std::uint8_t>(k);
        }
        for (std::uint32_t i = 0; i < size; ++i) {
            const Shadow& s = seen[order[i]];
            x0[i] = s.x0;
            x1[i] = s.x1;
            y0[i] = s.y0;
            y1[i] = s.y1;
            of[i] = all[order[i]];
        }
    }

    /// What a rectangle sees of those that a larger one sees.
    HWY_INLINE void narrow(const CellObjects& wider, const Rectangle& at) {
        size = 0;
        const V left = hn::Set(D(), static_cast<float>(at.x0)), right = hn::Set(D(), static_cast<float>(at.x1));
        const V upper = hn::Set(D(), static_cast<float>(at.y0)), lower = hn::Set(D(), static_cast<float>(at.y1));
        for (std::uint32_t k = 0; k < wider.size; k += lane_count) {
            const V a = hn::Load(D(), wider.x0 + k), b = hn::Load(D(), wider.x1 + k);
            const V c = hn::Load(D(), wider.y0 + k), d = hn::Load(D(), wider.y1 + k);
            const auto across = hn::And(hn::Lt(a, right), hn::Gt(b, left));
            const auto down = hn::And(hn::Lt(c, lower), hn::Gt(d, upper));
            const std::uint32_t present = wider.size - k < lane_count ? wider.size - k : lane_count;
            Bits kept = bits_of(hn::And(across, down)) & (~Bits(0) >> (32 - present));
            for (; kept != 0; kept &= kept - 1) {
                const std::uint32_t from = k + lowest_bit(kept);
                x0[size] = wider.x0[from];
                x1[size] = wider.x1[from];
                y0[size] = wider.y0[from];
                y1[size] = wider.y1[from];
                of[size++] = wider.of[from];
            }
        }
    }
};

/// Some objects.
struct ObjectList {
    const accel::ObjectId* first;
    std::uint32_t size;
};

/// All objects that a cell lists.
HWY_INLINE ObjectList all_objects(const accel::SceneView& scene, std::uint32_t cell) {
    const std::uint32_t begin = scene.cell_object_offsets[cell];
    return {scene.cell_objects.first + begin, scene.cell_object_offsets[cell + 1] - begin};
}

/// The objects of cells on the whole image, for as long as a few tiles are traced: boxes are projected once.
class ObjectsOnImage {
public:
    ObjectsOnImage(const accel::SceneView& scene, const CameraFrame& camera) : scene_(scene), onto_(camera) {}

    /// floor: of a mirror, or nullptr. A mirror's height is that of its cell's floor, wherever it is asked for.
    [[nodiscard]] const CellObjects& of(std::uint32_t cell, std::uint32_t key, const float* floor) {
        CellObjects& seen = cells_[key % remembered];
        if (HWY_UNLIKELY(seen.key != key || (floor != nullptr && floor_[key % remembered] != *floor))) {
            const ObjectList all = all_objects(scene_, cell);
            seen.key = key;
            if (floor != nullptr) floor_[key % remembered] = *floor;
            seen.make(scene_, onto_, all.first, all.size, floor);
        }
        return seen;
    }

private:
    static constexpr std::uint32_t remembered = 16;
    const accel::SceneView& scene_;
    Projection onto_;
    float floor_[remembered];
    CellObjects cells_[remembered];
};

/// What a rectangle sees of the objects in the cells that its rays cross; a few cells are remembered.
class ObjectsInView {
public:
    /// `around`: of a rectangle that holds this one, or nullptr.
    ObjectsInView(const accel::SceneView& scene, ObjectsOnImage& on_image, const Rectangle& at,
                  const ObjectsInView* around)
        : scene_(scene), on_image_(on_image), at_(at), around_(around) {}

    [[nodiscard]] HWY_INLINE ObjectList on(std::uint32_t cell) { return asked(cell, 2 * cell, nullptr); }
    /// Seen in a floor at that height; the same for all rays of a rectangle.
    [[nodiscard]] HWY_INLINE ObjectList in_mirror(std::uint32_t cell, float floor) {
        return asked(cell, 2 * cell + 1, &floor);
    }

private:
    static constexpr std::uint32_t remembered = 4;

    HWY_INLINE ObjectList asked(std::uint32_t cell, std::uint32_t key, const float* floor) {
        const ObjectList all = all_objects(scene_, cell);
        if (all.size == 0) return all;
        CellObjects& seen = cells_[cell % remembered];
        if (seen.key != key) {
            const CellObjects* wider = wider_one(cell, key);
            if (wider == nullptr) wider = &on_image_.of(cell, key, floor);
            seen.key = key;
            seen.is_known = wider->is_known;
            if (seen.is_known) seen.narrow(*wider, at_);
        }
        return HWY_LIKELY(seen.is_known) ? ObjectList{seen.of, seen.size} : all;
    }

    [[nodiscard]] HWY_INLINE const CellObjects* wider_one(std::uint32_t cell, std::uint32_t key) const {
        for (const ObjectsInView* view = around_; view != nullptr; view = view->around_) {
            const CellObjects& seen = view->cells_[cell % remembered];
            if (seen.key == key && seen.is_known) return &seen;
        }
        return nullptr;
    }

    const accel::SceneView& scene_;
    ObjectsOnImage& on_image_;
    Rectangle at_;
    const ObjectsInView* around_;
    CellObjects cells_[remembered];
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
