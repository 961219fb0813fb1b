#pragma once
// Walks without their rare cases: several sections that accept a ray, none, a ray led out behind its origin. Whoever
// walks so is told that one arose, and walks the ray again with all of them, apart: their registers and their calls are
// not in the way of all other rays then.

#include "render/lean_walk.h"
#include "render/object_walk.h"

namespace enfilade::render::cuda {

/// Events of a walk: whether a rare case arose, so that nothing it found may be used.
struct Deferring : NoEvents {
    bool is_rare = false;
};

// These are found instead of the walk's own by the type of its events.

template <class T>
ENFILADE_HD std::uint32_t resolve_exit(const accel::SceneView&, const Ray<T>&, std::uint32_t, std::uint32_t,
                                       std::uint32_t, std::uint32_t, bool, Deferring& events) {
    events.is_rare = true;
    return no_section;
}

template <class Stop>
ENFILADE_HD WalkEnd<float> walk_in_double(const accel::SceneView&, const Ray<float>&, std::uint32_t, const Stop&,
                                          Vec3f&, Deferring& events) {
    events.is_rare = true;
    WalkEnd<float> end = {};
    end.status = WalkStatus::Refused;
    return end;
}

template <ObjectsAsked asked_for, class Inside, class Stop>
ENFILADE_HD WalkEnd<float> walk_furnished_in_double(const accel::SceneView&, const Inside&, const Ray<float>&,
                                                    std::uint32_t, const Stop&, ObjectPart, Vec3f&, Deferring& events,
                                                    ObjectHit<float>&) {
    events.is_rare = true;
    WalkEnd<float> end = {};
    end.status = WalkStatus::Refused;
    return end;
}

/// Bare rooms for walks that defer.
struct QuickRooms {
    static constexpr bool are_furnished = false;

    template <class Stop>
    ENFILADE_HD Sight<float> look_along(const accel::SceneView& scene, const Ray<float>& ray, std::uint32_t cell,
                                        const Stop& stop, Vec3f& throughput, Deferring& events, float = 0) const {
        return {walked(scene, ray, cell, stop, throughput, events), {}};
    }
    template <class Stop>
    ENFILADE_HD WalkEnd<float> look_for_any(const accel::SceneView& scene, const Ray<float>& ray, std::uint32_t cell,
                                            const Stop& stop, ObjectPart, Vec3f& throughput, Deferring& events) const {
        return walked(scene, ray, cell, stop, throughput, events);
    }

private:
    template <class Stop>
    ENFILADE_HD static WalkEnd<float> walked(const accel::SceneView& scene, const Ray<float>& ray, std::uint32_t cell,
                                             const Stop& stop, Vec3f& throughput, Deferring& events) {
        WalkEnd<float> end;
        if (!walk_plainly(scene, ray, cell, stop, throughput, end)) {
            events.is_rare = true;
            end.status = WalkStatus::Refused;
        }
        return end;
    }
};

}  // namespace enfilade::render::cuda
