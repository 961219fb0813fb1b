#pragma once
// The walk without its rare cases, for devices: a loop without calls needs no stack and fewer registers. What it cannot
// decide (several sections accept a ray or none does, vertical rays, circles, ends behind the origin) is told to
// whoever asked, who walks that ray from its start by `walk`: so the answers are those of `walk`, ray by ray.
// Header-only, for host and device.

#include "render/rooms.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {
namespace {

/// By which face a ray leaves a cell, to `end`; false: a rare case.
template <class Scene, class Stop>
ENFILADE_HD bool leave_plainly(const Scene& scene, const Ray<float>& ray, std::uint32_t cell, const Stop& stop,
                               WalkEnd<float>& end) {
    const auto& c = walked_cell(scene, cell);
    end.cell = cell;
    const std::uint32_t i = only_accepting(scene, ray, c.first_section, c.section_count);
    if (i == no_section) return false;
    leave_by_section(scene, ray, c, i, stop, end);
    return true;
}

enum class Plainly { GoesOn, Ends, Rare };

/// One cell of the walk: through the cell that holds `end.cell`'s number, to the next one, whose number is then there.
/// throughput, events: as of walk
template <class Scene, class Stop, class Throughput>
ENFILADE_HD Plainly step_plainly(const Scene& scene, const Ray<float>& ray, const Stop& stop, Throughput& throughput,
                                 WalkEnd<float>& end) {
    if (!leave_plainly(scene, ray, end.cell, stop, end)) return Plainly::Rare;
    if (end.status == WalkStatus::Reached || !end.target.is_portal())
        return ends_behind(ray, end) ? Plainly::Rare : Plainly::Ends;
    if (end.target.is_glass()) tint_by_glass(scene, end.cell, end.exit, end.face, throughput);
    end.cell = static_cast<std::uint32_t>(end.target.neighbour());
    if (!stop.ends_in(end.cell)) return Plainly::GoesOn;
    end.status = WalkStatus::Reached;
    return Plainly::Ends;
}

/// The walk from `cell` on; false: a rare case, and `throughput` is not to be used.
template <class Scene, class Stop, class Throughput>
ENFILADE_HD bool walk_plainly(const Scene& scene, const Ray<float>& ray, std::uint32_t cell, const Stop& stop,
                              Throughput& throughput, WalkEnd<float>& end) {
    end.cell = cell;
    for (std::uint32_t steps = most_steps(scene); steps > 0; --steps) {
        const Plainly step = step_plainly(scene, ray, stop, throughput, end);
        if (step != Plainly::GoesOn) return step == Plainly::Ends;
    }
    return false;
}

/// The whole walk, out of line.
template <class Stop, class Throughput>
ENFILADE_HD_COLD WalkEnd<float> walk_from_start(const accel::SceneView& scene, Ray<float> ray, std::uint32_t cell,
                                                Stop stop, Throughput& throughput) {
    NoEvents none;
    return walk(scene, ray, cell, stop, throughput, none);
}

/// As BareRooms, for kernels: rare cases are one call, outside of the loop over cells.
struct LeanRooms {
    static constexpr bool are_furnished = false;

    template <class Scene, class Stop, class Throughput, class Events>
    ENFILADE_HD Sight<float> look_along(const Scene& scene, const Ray<float>& ray, std::uint32_t cell, const Stop& stop,
                                        Throughput& throughput, Events&, float = 0) const {
        return {walked(scene, ray, cell, stop, throughput), {}};
    }
    template <class Scene, class Stop, class Throughput, class Events>
    ENFILADE_HD WalkEnd<float> look_for_any(const Scene& scene, const Ray<float>& ray, std::uint32_t cell,
                                            const Stop& stop, ObjectPart, Throughput& throughput, Events&) const {
        return walked(scene, ray, cell, stop, throughput);
    }

private:
    template <class Scene, class Stop, class Throughput>
    ENFILADE_HD static WalkEnd<float> walked(const Scene& scene, const Ray<float>& ray, std::uint32_t cell,
                                             const Stop& stop, Throughput& throughput) {
        const Throughput before = throughput;
        WalkEnd<float> end;
        if (walk_plainly(scene, ray, cell, stop, throughput, end)) return end;
        Throughput whole = before;  // its address holds it in memory on this path alone
        end = walk_from_start(scene, ray, cell, stop, whole);
        throughput = whole;
        return end;
    }
};

}  // namespace
}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
