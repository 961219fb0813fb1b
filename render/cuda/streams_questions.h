#pragma once
// What streams ask of walks: the nearest hit of a ray, or whether a segment is clear. Each knows how ray i begins, how
// a walk without rare cases (render/lean_walk.h) is answered, and how the whole walk of render/stream_ray.h is.

#include "render/lean_walk.h"
#include "render/stream_ray.h"

namespace enfilade::render::cuda {

/// Limit where a stream has limits, else NoLimit: their answers, chosen at run time.
struct RayLimit {
    float t;
    bool is_limited;

    ENFILADE_HD bool before_side(float num, float den) const {
        return is_limited && Limit<float>{t}.before_side(num, den);
    }
    ENFILADE_HD bool before_level(float rise, float dz) const {
        return is_limited && Limit<float>{t}.before_level(rise, dz);
    }
    ENFILADE_HD bool ends_in(std::uint32_t) const { return false; }
};

/// A ray or a segment under way.
template <class StopKind>
struct Traveller {
    Ray<float> ray;
    StopKind stop;
    ObjectPart part;  ///< in which objects count
    std::uint32_t cell;
};

struct NearestQuestion {
    using Job = detail::StreamJob;
    using Traveller = cuda::Traveller<RayLimit>;
    static constexpr ObjectsAsked asked = ObjectsAsked::Nearest;
    detail::StreamJob job;

    /// False: it is no ray, and that is its answer.
    ENFILADE_HD bool begin(std::uint64_t i, bool, Traveller& t) const {
        if (again(i, t)) return true;
        write_refusal(job, i);
        return false;
    }
    /// The same once more, of one that has begun.
    ENFILADE_HD bool again(std::uint64_t i, Traveller& t) const {
        const float max_distance = reach_of(job, i);
        if (!ray_of(job, i, max_distance, t.ray)) return false;
        const bool is_limited = job.max_distance != nullptr;
        t.stop = {is_limited ? limit_of(max_distance, length(t.ray.direction)) : 3e38f, is_limited};
        t.part.far = t.stop.t;
        t.cell = static_cast<std::uint32_t>(job.start[i]);
        return true;
    }
    template <class Scene>
    ENFILADE_HD void finish(const Scene& scene, std::uint64_t i, const Traveller& t, const WalkEnd<float>& end) const {
        const float distance = end.status == WalkStatus::Reached
                                   ? reach_of(job, i)
                                   : parameter(scene, t.ray, end) * length(t.ray.direction);
        write_answer(job, i, {end, {}}, distance);
    }
    ENFILADE_HD void finish_at_object(std::uint64_t i, const Traveller& t, std::uint32_t cell,
                                      const ObjectHit<float>& hit) const {
        Sight<float> sight = {};
        sight.end.status = WalkStatus::Object;
        sight.end.cell = cell;
        sight.hit = hit;
        write_answer(job, i, sight, hit.t * length(t.ray.direction));
    }
    template <class Rooms>
    ENFILADE_HD void answer_whole(const accel::SceneView& scene, const Rooms& rooms, std::uint64_t i) const {
        NoEvents none;
        answer_ray(scene, rooms, job, i, none);
    }
};

struct VisibleQuestion {
    using Job = detail::SegmentJob;
    using Traveller = cuda::Traveller<ToPoint<float>>;
    static constexpr ObjectsAsked asked = ObjectsAsked::Any;
    detail::SegmentJob job;

    /// False: it needs no walk, and is answered.
    ENFILADE_HD bool begin(std::uint64_t i, bool is_furnished, Traveller& t) const {
        const Vec3f p = from(i), q = to(i);
        const std::uint32_t cell = static_cast<std::uint32_t>(job.from_cell[i]), q_cell = cell_of_end(i);
        const bool are_places = is_place(p) && is_place(q);
        if (are_places && (is_furnished || cell != q_cell) && again(i, t)) return true;
        job.visible[i] = are_places ? 1 : 0;
        return false;
    }
    ENFILADE_HD bool again(std::uint64_t i, Traveller& t) const {
        Segment<float> segment;
        if (!make_segment(from(i), to(i), no_object, segment)) return false;
        t.ray = segment.ray;
        t.stop = {segment.t, cell_of_end(i)};
        t.part = segment.part;
        t.cell = static_cast<std::uint32_t>(job.from_cell[i]);
        return true;
    }
    template <class Scene>
    ENFILADE_HD void finish(const Scene&, std::uint64_t i, const Traveller&, const WalkEnd<float>& end) const {
        job.visible[i] = end.status == WalkStatus::Reached ? 1 : 0;
    }
    ENFILADE_HD void finish_at_object(std::uint64_t i, const Traveller&, std::uint32_t, const ObjectHit<float>&) const {
        job.visible[i] = 0;
    }
    template <class Rooms>
    ENFILADE_HD void answer_whole(const accel::SceneView& scene, const Rooms& rooms, std::uint64_t i) const {
        NoEvents none;
        answer_segment(scene, rooms, job, i, none);
    }

private:
    ENFILADE_HD Vec3f from(std::uint64_t i) const { return {job.from[0][i], job.from[1][i], job.from[2][i]}; }
    ENFILADE_HD Vec3f to(std::uint64_t i) const { return {job.to[0][i], job.to[1][i], job.to[2][i]}; }
    ENFILADE_HD std::uint32_t cell_of_end(std::uint64_t i) const {
        return job.to_cell != nullptr ? static_cast<std::uint32_t>(job.to_cell[i]) : no_cell;
    }
};

}  // namespace enfilade::render::cuda
