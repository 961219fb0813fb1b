// The objects of a cell that rays through a rectangle of the image may meet.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// Pixels of the image: x0 to x1 - 1, y0 to y1 - 1.
struct Rectangle {
    int x0, y0, x1, y1;
};

/// The pyramid of the rays through a rectangle: four sides and the plane through the eye, as inward normals.
struct Pyramid {
    static constexpr int most = 16;  ///< planes of a register; those that are not used let everything pass
    alignas(64) float nx[most], ny[most], nz[most];
    Vec3f ahead;  ///< of the plane through the eye

    Pyramid() {}  // made when it is needed
    /// Half a pixel wider than the rays, which is more than rounding.
    Pyramid(const CameraFrame& camera, const Rectangle& at) {
        // p - eye = s (x du + y dv + corner): s x, s y and s are linear in p.
        const float volume = dot(camera.corner, cross(camera.du, camera.dv));
        const float sign = volume < 0 ? -1.0f : 1.0f;
        const Vec3f along_x = sign * cross(camera.dv, camera.corner), along_y = sign * cross(camera.corner, camera.du);
        ahead = sign * cross(camera.du, camera.dv);
        for (int i = 0; i < most; ++i) nx[i] = ny[i] = nz[i] = 0;
        const auto put = [&](int i, Vec3f n) {
            nx[i] = n.x;
            ny[i] = n.y;
            nz[i] = n.z;
        };
        put(0, along_x - static_cast<float>(at.x0) * ahead);
        put(1, static_cast<float>(at.x1) * ahead - along_x);
        put(2, along_y - static_cast<float>(at.y0) * ahead);
        put(3, static_cast<float>(at.y1) * ahead - along_y);
        put(4, ahead);
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

/// Whether the pyramid from the eye has something of the box in it; rather yes than no.
HWY_INLINE bool may_see(const Pyramid& pyramid, Vec3f eye, const TurnedBox& box) {
    using F = Floats<Pyramid::most>;
    const F nx = load<Pyramid::most>(pyramid.nx), ny = load<Pyramid::most>(pyramid.ny);
    const F nz = load<Pyramid::most>(pyramid.nz);
    const auto against = [&](Vec3f v)
                             HWY_ATTR { return fused_lanes(nx, F(v.x), fused_lanes(ny, F(v.y), nz * F(v.z))); };
    const F reach =
        magnitude_of(against(box.half[0])) + magnitude_of(against(box.half[1])) + magnitude_of(against(box.half[2]));
    return is_less(against(box.middle - eye) + reach, F(0)) == 0;
}

/// Objects of a cell, by how near their boxes come.
struct CellObjects {
    static constexpr std::uint32_t most = 24;
    std::uint32_t key = no_section;  ///< none: not made yet
    std::uint32_t size;
    bool is_known;  ///< else there are too many
    accel::ObjectId of[most];
    float nearness[most];

    CellObjects() {}  // the rest is made when it is needed
    HWY_INLINE void add(accel::ObjectId object, float near) {
        if (size == most) {
            is_known = false;
            return;
        }
        std::uint32_t at = size++;
        for (; at > 0 && nearness[at - 1] > near; --at) {
            of[at] = of[at - 1];
            nearness[at] = nearness[at - 1];
        }
        of[at] = object;
        nearness[at] = near;
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

/// What a rectangle sees of the objects in the cells that its rays cross; a few cells are remembered.
class ObjectsInView {
public:
    /// `around`: of a rectangle that holds this one, or nullptr.
    ObjectsInView(const accel::SceneView& scene, const CameraFrame& camera, const Rectangle& at,
                  const ObjectsInView* around)
        : scene_(scene), camera_(camera), at_(at), around_(around) {}

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
        if (seen.key != key) make(seen, wider(cell, key, all), key, floor);
        return HWY_LIKELY(seen.is_known) ? ObjectList{seen.of, seen.size} : all;
    }

    [[nodiscard]] ObjectList wider(std::uint32_t cell, std::uint32_t key, const ObjectList& all) const {
        for (const ObjectsInView* view = around_; view != nullptr; view = view->around_) {
            const CellObjects& seen = view->cells_[cell % remembered];
            if (seen.key == key && seen.is_known) return {seen.of, seen.size};
        }
        return all;
    }

    HWY_NOINLINE void make(CellObjects& seen, const ObjectList& from, std::uint32_t key, const float* floor) {
        if (!has_pyramid_) pyramid_ = Pyramid(camera_, at_);
        has_pyramid_ = true;
        seen.key = key;
        seen.size = 0;
        seen.is_known = true;
        for (std::uint32_t k = 0; k < from.size; ++k) {
            const accel::PlacedObject& object = scene_.objects[index(from.first[k])];
            TurnedBox box(scene_.meshes[index(object.mesh)], object);
            if (floor != nullptr) box.mirror(*floor);
            if (!may_see(pyramid_, camera_.origin, box)) continue;
            float near = dot(pyramid_.ahead, box.middle - camera_.origin);
            for (const Vec3f& h : box.half) near -= magnitude(dot(pyramid_.ahead, h));
            seen.add(from.first[k], near);
        }
    }

    const accel::SceneView& scene_;
    const CameraFrame& camera_;
    Rectangle at_;
    const ObjectsInView* around_;
    bool has_pyramid_ = false;
    Pyramid pyramid_;
    CellObjects cells_[remembered];
};

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
