// Objects between lamps and places: those of a beam that a pyramid from the lamp meets, then sixteen rays an object.
// No include guard: lanes.cpp includes it once for every instruction set.

HWY_BEFORE_NAMESPACE();
namespace enfilade::render {
namespace HWY_NAMESPACE {

/// What a lamp's light crosses on its way to a rectangle of a face. Places count from the lamp.
class LampPyramid {
public:
    /// corners: of the rectangle, those of its upper row first. normal: the face's, on the lamp's side; height: the
    /// lamp's over the face
    HWY_INLINE LampPyramid(const Vec3f (&corners)[4], Vec3f normal, float height) {
        const Vec3f middle = corners[0] + corners[1] + corners[2] + corners[3];
        float reach = height;
        for (const Vec3f& c : corners) {
            const float size = magnitude(c.x) + magnitude(c.y) + magnitude(c.z);
            reach = size > reach ? size : reach;
        }
        // More than rounding may turn a plane by.
        const float noise = 1e-6f * reach * reach * reach;
        constexpr int ring[5] = {0, 1, 3, 2, 0};
        for (int k = 0; k < 4; ++k) {
            Vec3f plane = cross(corners[ring[k]], corners[ring[k + 1]]);
            if (dot(plane, middle) < 0) plane = -plane;
            put(k, plane, noise);
        }
        put(4, normal, height);
        put(5, -normal, 0);
        put(6, {0, 0, 0}, 1);
        put(7, {0, 0, 0}, 1);
    }

    /// Whether a box may reach into it; rather yes than no. middle, half: of the box along the scene's axes
    [[nodiscard]] HWY_INLINE bool may_meet(Vec3f middle, Vec3f half) const {
        const hn::CappedTag<float, planes> d;
        for (std::size_t k = 0; k < planes; k += hn::Lanes(d)) {
            const auto part = [&](const float* of, float by, auto sum)
                                  HWY_ATTR { return hn::MulAdd(hn::Load(d, of + k), hn::Set(d, by), sum); };
            const auto spread = [&](const float* of, float by, auto sum)
                                    HWY_ATTR { return hn::MulAdd(hn::Abs(hn::Load(d, of + k)), hn::Set(d, by), sum); };
            auto most = part(x_, middle.x, part(y_, middle.y, part(z_, middle.z, hn::Load(d, offset_ + k))));
            most = spread(x_, half.x, spread(y_, half.y, spread(z_, half.z, most)));
            if (!hn::AllFalse(d, hn::Lt(most, hn::Zero(d)))) return false;
        }
        return true;
    }

private:
    static constexpr std::size_t planes = 8;

    HWY_INLINE void put(int k, Vec3f plane, float offset) {
        constexpr float margin = 1e-3f;  // metres
        x_[k] = plane.x;
        y_[k] = plane.y;
        z_[k] = plane.z;
        offset_[k] = offset + margin * (magnitude(plane.x) + magnitude(plane.y) + magnitude(plane.z));
    }

    alignas(64) float x_[planes], y_[planes], z_[planes], offset_[planes];
};

/// Which of the places have one of the objects between them and the lamp.
template <int N>
HWY_NOINLINE Bits blocked_by(const accel::SceneView& scene, const ObjectTracer& tracer, const accel::ObjectId* objects,
                             std::uint32_t count, const Points<N>& point, Vec3f lamp, Bits some) {
    using F = Floats<N>;
    static_assert(N % ObjectRays::count == 0);
    const Points<N> way = {F(lamp.x) - point.x, F(lamp.y) - point.y, F(lamp.z) - point.z};
    const F touch = F(touch_slack) / root_of(dot_lanes(way, way));
    const Stretch<N> stretch = {touch, F(1) - touch};
    Asked asked;
    Bits blocked = 0;
    for (std::uint32_t k = 0; k < count && some != 0; ++k) {
        const accel::PlacedObject& object = scene.objects[index(objects[k])];
        const auto& m = object.object_from_scene.rows;
        const auto& at = object.scene_from_object.rows;
        const Points<N> o =
            turned_lanes(m.data(), Points<N>{point.x - F(at[3]), point.y - F(at[7]), point.z - F(at[11])});
        const Points<N> d = turned_lanes(m.data(), way);
        const Bits near = some & pass_box(scene.meshes[index(object.mesh)], o, d, stretch);
        if (near == 0) continue;
        for (int sixteen = 0; sixteen < N / ObjectRays::count; ++sixteen) {
            const Bits these = near >> (sixteen * ObjectRays::count) & 0xffffu;
            if (these == 0) continue;
            ObjectRays& to = asked.rays;
            store_sixteen(o.x, sixteen, to.origin_x);
            store_sixteen(o.y, sixteen, to.origin_y);
            store_sixteen(o.z, sixteen, to.origin_z);
            store_sixteen(d.x, sixteen, to.direction_x);
            store_sixteen(d.y, sixteen, to.direction_y);
            store_sixteen(d.z, sixteen, to.direction_z);
            store_sixteen(stretch.from, sixteen, to.near);
            store_sixteen(stretch.to, sixteen, to.far);
            asked.choose_lanes(these);
            blocked |= Bits(tracer.blocked16(tracer.state, object.mesh, asked.valid, to))
                       << (sixteen * ObjectRays::count);
        }
        some &= ~blocked;
    }
    return blocked;
}

}  // namespace HWY_NAMESPACE
}  // namespace enfilade::render
HWY_AFTER_NAMESPACE();
