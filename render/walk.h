#pragma once
// The walk through cells and portals (Maria, Horna, Aveneau 2013, section 4; README.md of this folder for what that
// text leaves open). Header-only, for float and double, host and device: who schedules it decides nothing about its
// results.

#include <cstdint>

#include "accel/scene.h"
#include "render/isa.h"
#include "render/left_bits.h"
#include "render/ray.h"
#include "render/walk_events.h"

namespace enfilade::render {
inline namespace ENFILADE_ISA {

/// Where a walk ended.
template <class T>
struct WalkEnd {
    WalkStatus status;
    Exit exit;
    std::uint32_t cell;
    std::uint32_t section;       ///< by which the ray leaves the cell's endless prism; 2^32 - 1 for vertical rays
    std::uint32_t next_section;  ///< where that section ends
    std::uint32_t face;          ///< side face, if exit is Side
    accel::Target target;
    T num, den;  ///< the prism is left at origin + num / den * direction
    T facing;    ///< direction . outward normal (of the section's length)
};

/// Where a walk is told to end before a face stops it. `before_side` and `before_level` say whether that place lies
/// before the face by which the ray leaves a cell, `ends_in` whether the cell just entered is as good as that place.
///
/// Walks until a face stops the light.
struct NoLimit {
    template <class T>
    ENFILADE_HD bool before_side(T, T) const {
        return false;
    }
    template <class T>
    ENFILADE_HD bool before_level(T, T) const {
        return false;
    }
    ENFILADE_HD bool ends_in(std::uint32_t) const { return false; }
};

/// Walks at most `t` times the ray's (scaled) direction.
template <class T>
struct Limit {
    T t;
    ENFILADE_HD bool before_side(T num, T den) const { return !(num <= t * den); }
    /// rise: from the origin up to the level.
    ENFILADE_HD bool before_level(T rise, T dz) const { return dz < T(0) ? !(rise >= t * dz) : !(rise <= t * dz); }
    ENFILADE_HD bool ends_in(std::uint32_t) const { return false; }
};

/// The parameter at `distance` metres along a direction so many metres long; more than any scene's where there is no
/// limit.
ENFILADE_HD float limit_of(float distance, float direction_metres) {
    return distance < 1e30f ? distance / direction_metres : 3e38f;
}

/// Walks to the point q at `t` times the ray's (scaled) direction. What lies on a face lies before it. Cells are
/// convex: from the border at which the ray enters q's cell, if that is known, nothing comes between, so the walk ends
/// there. q's distance still ends it where rounding leads the ray past a corner of that cell.
template <class T>
struct ToPoint {
    T t;
    std::uint32_t cell;  ///< no_cell: not known
    ENFILADE_HD bool before_side(T num, T den) const { return num >= t * den; }
    ENFILADE_HD bool before_level(T rise, T dz) const { return dz < T(0) ? rise <= t * dz : rise >= t * dz; }
    ENFILADE_HD bool ends_in(std::uint32_t entered) const { return entered == cell; }
};

inline constexpr std::uint32_t no_cell = 0xffffffffu;

inline constexpr std::uint32_t no_section = 0xffffffffu;
inline constexpr std::uint32_t bit_sections = 32;

/// Twice the place along the ray's 2D direction where it crosses the section from p to q, weighted by its sides:
/// num / den = t with num = q_side (p - o).d - p_side (q - o).d and den = (q_side - p_side) d.d. It interpolates
/// between the section's ends, so it never leaves the section, however nearly parallel ray and section are; n.(p - o) /
/// n.d would. Seen from the neighbour both are exactly negated; for the reversed line num is, and den is the same.
template <class T>
struct Crossing {
    T num, den;
    T facing;  ///< q_side - p_side: direction . outward normal
};

/// Sides of p and q as `line_side` gave them. A section that was missed is met at its nearer end.
template <class T>
ENFILADE_HD Crossing<T> crossing(const Ray<T>& ray, T px, T py, T p_side, T qx, T qy, T q_side) {
    const T dx = ray.direction.x, dy = ray.direction.y;
    const T p_along = fused(px - ray.origin.x, dx, (py - ray.origin.y) * dy);
    const T q_along = fused(qx - ray.origin.x, dx, (qy - ray.origin.y) * dy);
    p_side = p_side < T(0) ? p_side : T(0);
    q_side = q_side > T(0) ? q_side : T(0);
    const T facing = q_side - p_side;
    return {q_side * p_along - p_side * q_along, facing * (dx * dx + dy * dy), facing};
}

// What a walk reads of a scene. A scene of other records has overloads of these (cuda/packed_sections.h) and the arrays
// of a SceneView besides.

ENFILADE_HD const accel::Cell& walked_cell(const accel::SceneView& scene, std::uint32_t cell) {
    return scene.cells[cell];
}

/// Where a section begins.
struct LinePlace {
    float x, y;
};
ENFILADE_HD LinePlace line_at(const accel::SceneView& scene, std::uint32_t section) {
    return {scene.section_x[section], scene.section_y[section]};
}

/// Of so many lines one question is asked at most.
ENFILADE_HD constexpr std::uint32_t most_lines(const accel::SceneView&) { return bit_sections; }

/// Which of `count` lines from `first` on lie on the left of the ray, bit by bit. \pre count <= most_lines
template <class T>
ENFILADE_HD std::uint32_t left_lines(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t first,
                                     std::uint32_t count) {
    return left_bits(ray, scene.section_x.first + first, scene.section_y.first + first, count);
}

/// A face of a section's stack.
struct StackFace {
    std::uint32_t face;
    bool is_top;
    ENFILADE_HD accel::Target target(const accel::SceneView& scene) const { return scene.side_faces[face].target; }
};
/// The lowest whose top is above the ray where it leaves: without division. scaled_dz: num * dz
template <class T>
ENFILADE_HD StackFace stack_face(const accel::SceneView& scene, std::uint32_t section, T scaled_dz, T origin_z, T den) {
    const std::uint32_t top = scene.section_tails[section + 1].first_face - 1;
    std::uint32_t face = scene.section_tails[section].first_face;
    while (face < top && !(scaled_dz < (T(scene.side_faces[face].z_top) - origin_z) * den)) ++face;
    return {face, face == top};
}

template <class Scene, class T>
ENFILADE_HD Crossing<T> section_crossing(const Scene& scene, const Ray<T>& ray, std::uint32_t section,
                                         std::uint32_t next) {
    const LinePlace p = line_at(scene, section), q = line_at(scene, next);
    const T px = p.x, py = p.y, qx = q.x, qy = q.y;
    return crossing(ray, px, py, line_side(ray, px, py), qx, qy, line_side(ray, qx, qy));
}

/// A few roundings, relative.
template <class T>
ENFILADE_HD constexpr T rounding() {
    return sizeof(T) == sizeof(float) ? T(0x1p-21) : T(0x1p-50);
}

/// The rare cases: several sections that accept; none that does; a vertical ray, which leaves by none (no_section).
/// Counted from the cell's first. README.md, "Ties and noise". The ray comes by value: its address would hold it in
/// memory on the hot path, too.
template <class T, class Events>
ENFILADE_HD_COLD std::uint32_t resolve_exit(const accel::SceneView& scene, Ray<T> ray, std::uint32_t first,
                                            std::uint32_t count, std::uint32_t entry, std::uint32_t entry_next,
                                            bool take_farthest, Events& events) {
    if (ray.direction.x == T(0) && ray.direction.y == T(0)) return no_section;
    std::uint32_t best = no_section, nearest_miss = no_section, accepting = 0;
    T best_along = T(0), best_margin = T(0), best_end = T(0);
    const std::uint32_t last = first + count - 1;
    const bool zero_is_left = ray.zero_mask != 0;
    T px = scene.section_x[first], py = scene.section_y[first];
    T p_side = line_side(ray, px, py);
    for (std::uint32_t i = first; i <= last; ++i) {
        const std::uint32_t j = i == last ? first : i + 1;
        const T qx = scene.section_x[j], qy = scene.section_y[j];
        const T q_side = line_side(ray, qx, qy);
        const bool is_entry = entry != no_section && px == T(scene.section_x[entry_next]) &&
                              py == T(scene.section_y[entry_next]) && qx == T(scene.section_x[entry]) &&
                              qy == T(scene.section_y[entry]);
        const bool p_right = !(p_side > T(0) || (p_side == T(0) && zero_is_left));
        const bool q_left = q_side > T(0) || (q_side == T(0) && zero_is_left);
        const Crossing<T> at = crossing(ray, px, py, p_side, qx, qy, q_side);
        const T along = at.den > T(0) ? at.num / at.den : T(0);
        if (!is_entry && p_right && q_left &&
            (accepting++ == 0 || (take_farthest ? along > best_along : along < best_along))) {
            best = i;
            best_along = along;
        }
        // Within rounding of equally near, the miss whose nearer end lies farther along.
        const T margin = -p_side < q_side ? -p_side : q_side;
        const T noise =
            rounding<T>() * (magnitude(ray.moment) + magnitude(px * ray.direction.y) + magnitude(py * ray.direction.x));
        if (!is_entry && (nearest_miss == no_section || margin > best_margin + noise ||
                          (margin > best_margin - noise && along > best_end))) {
            nearest_miss = i;
            best_margin = margin;
            best_end = along;
        }
        px = qx;
        py = qy;
        p_side = q_side;
    }
    if (accepting > 1) events.several_exits();
    if (accepting == 0) events.no_exit();
    return (accepting > 0 ? best : nearest_miss) - first;
}

ENFILADE_HD std::uint32_t lowest_bit(std::uint32_t bits) {
#if defined(__CUDA_ARCH__)
    return static_cast<std::uint32_t>(__ffs(static_cast<int>(bits)) - 1);
#else
    return static_cast<std::uint32_t>(__builtin_ctz(bits));
#endif
}

/// The one section that has its beginning on the right of the ray and its end on the left, counted from the cell's
/// first; `no_section` if there is none or more than one.
template <class Scene, class T>
ENFILADE_HD std::uint32_t only_accepting(const Scene& scene, const Ray<T>& ray, std::uint32_t first,
                                         std::uint32_t count) {
    if (count <= most_lines(scene)) {
        const std::uint32_t bits = left_lines(scene, ray, first, count);
        const std::uint32_t all = ~0u >> (bit_sections - count);
        const std::uint32_t next_bits = (bits & all) >> 1 | (bits & 1u) << (count - 1);
        const std::uint32_t accepting = ~bits & next_bits;
        return accepting != 0 && (accepting & (accepting - 1)) == 0 ? lowest_bit(accepting) : no_section;
    }
    std::uint32_t found = no_section, found_count = 0;
    std::uint32_t first_bit = 0, bit_before = 1;  // nothing ends before the first section
    for (std::uint32_t begin = 0; begin < count; begin += most_lines(scene)) {
        const std::uint32_t size = count - begin < most_lines(scene) ? count - begin : most_lines(scene);
        const std::uint32_t bits = left_lines(scene, ray, first + begin, size);
        if (begin == 0) first_bit = bits & 1u;
        if (begin > 0 && bit_before == 0 && (bits & 1u) != 0) {
            found = begin - 1;
            ++found_count;
        }
        const std::uint32_t inner = ~0u >> (bit_sections - size) >> 1;
        std::uint32_t accepting = ~bits & bits >> 1 & inner;
        for (; accepting != 0; accepting &= accepting - 1) {
            found = begin + lowest_bit(accepting);
            ++found_count;
        }
        bit_before = bits >> (size - 1) & 1u;
    }
    if (bit_before == 0 && first_bit != 0) {
        found = count - 1;
        ++found_count;
    }
    return found_count == 1 ? found : no_section;
}

/// Step 1: the exit section, by one side test a vertical line; consecutive sections share theirs. Counted from the
/// cell's first; `no_section` for vertical rays.
template <class Scene, class T, class Events>
ENFILADE_HD std::uint32_t find_section(const Scene& scene, const Ray<T>& ray, std::uint32_t first, std::uint32_t count,
                                       std::uint32_t entry, std::uint32_t entry_next, bool take_farthest,
                                       Events& events) {
    const std::uint32_t i = only_accepting(scene, ray, first, count);
    return i != no_section ? i : resolve_exit(scene, ray, first, count, entry, entry_next, take_farthest, events);
}

template <class Cell, class T, class Stop>
ENFILADE_HD void leave_by_level(const Cell& cell, const Ray<T>& ray, Exit exit, const Stop& stop, WalkEnd<T>& end) {
    end.exit = exit;
    end.target = exit == Exit::Floor ? cell.floor : cell.ceiling;
    const T rise = (exit == Exit::Floor ? T(cell.z_floor) : T(cell.z_ceiling)) - ray.origin.z;
    end.status = stop.before_level(rise, ray.direction.z) ? WalkStatus::Reached : WalkStatus::Hit;
}

/// Step 2: the face in the exit section's stack, bottom-up, without division. Equality counts as above: every level is
/// shifted down by a vanishing amount, the same for both directions of the ray. Floors are left downwards and ceilings
/// upwards only, whatever rounding says of a ray that starts on one of them.
template <class Scene, class Cell, class T, class Stop>
ENFILADE_HD void find_face(const Scene& scene, const Ray<T>& ray, const Cell& cell, const Stop& stop, WalkEnd<T>& end) {
    const T dz = ray.direction.z;
    const T scaled_dz = end.num * dz;
    if (dz < T(0) && scaled_dz < (T(cell.z_floor) - ray.origin.z) * end.den)
        return leave_by_level(cell, ray, Exit::Floor, stop, end);
    const auto found = stack_face(scene, end.section, scaled_dz, ray.origin.z, end.den);
    if (dz > T(0) && found.is_top && !(scaled_dz < (T(cell.z_ceiling) - ray.origin.z) * end.den))
        return leave_by_level(cell, ray, Exit::Ceiling, stop, end);
    end.exit = Exit::Side;
    end.face = found.face;
    end.target = found.target(scene);
    end.status = stop.before_side(end.num, end.den) ? WalkStatus::Reached : WalkStatus::Hit;
}

/// The face by which a ray leaves a cell, once its section is known. i: counted from the cell's first
template <class Scene, class Cell, class T, class Stop>
ENFILADE_HD void leave_by_section(const Scene& scene, const Ray<T>& ray, const Cell& c, std::uint32_t i,
                                  const Stop& stop, WalkEnd<T>& end) {
    end.section = c.first_section + i;
    end.next_section = i + 1 == c.section_count ? c.first_section : c.first_section + i + 1;
    const Crossing<T> at = section_crossing(scene, ray, end.section, end.next_section);
    end.num = at.num;
    end.den = at.den;
    end.facing = at.facing;
    find_face(scene, ray, c, stop, end);
}

/// The face by which a ray leaves a cell: section, then face.
template <class Scene, class T, class Stop, class Events>
ENFILADE_HD void leave_cell(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, std::uint32_t entry,
                            std::uint32_t entry_next, bool take_farthest, const Stop& stop, Events& events,
                            WalkEnd<T>& end) {
    const auto& c = walked_cell(scene, cell);
    end.cell = cell;
    const std::uint32_t i =
        find_section(scene, ray, c.first_section, c.section_count, entry, entry_next, take_farthest, events);
    if (i == no_section) {
        end.section = end.next_section = no_section;
        return leave_by_level(c, ray, ray.direction.z < T(0) ? Exit::Floor : Exit::Ceiling, stop, end);
    }
    leave_by_section(scene, ray, c, i, stop, end);
}

/// The tint of the glass behind a face. Out of line: windows are rare.
ENFILADE_HD_COLD inline Vec3f tint_of(const accel::SceneView& scene, std::uint32_t cell, Exit exit,
                                      std::uint32_t face) {
    const accel::PortalId portal = exit == Exit::Side    ? scene.side_face_portals[face]
                                   : exit == Exit::Floor ? scene.cell_portals[cell].floor
                                                         : scene.cell_portals[cell].ceiling;
    const accel::Vertex tint = scene.tints[scene.portals[static_cast<std::uint32_t>(portal)].kind_and_tint >> 2];
    return {tint.x, tint.y, tint.z};
}

/// For walks whose light nobody asks for.
struct NoThroughput {};
ENFILADE_HD void tint_by_glass(const accel::SceneView&, std::uint32_t, Exit, std::uint32_t, NoThroughput&) {}
ENFILADE_HD void tint_by_glass(const accel::SceneView& scene, std::uint32_t cell, Exit exit, std::uint32_t face,
                               Vec3f& throughput) {
    throughput = throughput * tint_of(scene, cell, exit, face);
}

/// A line that enters more cells goes in a circle. Targets have 30 bits, so twice as many fit in 32.
ENFILADE_HD std::uint32_t most_steps(const accel::SceneView& scene) {
    return static_cast<std::uint32_t>(scene.cells.count) + 16;
}

/// Follows the ray from `cell`, which holds its origin, through portals until a source face stops it or `stop` does.
/// Always ends: a straight line enters no convex cell twice, so more steps than cells mean that rounding leads the walk
/// in a circle about a vertex; then it takes the nearest of several exits instead of the farthest, once as long.
template <class Scene, class T, class Stop, class Throughput, class Events>
ENFILADE_HD WalkEnd<T> walk_in(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                               Throughput& throughput, Events& events) {
    WalkEnd<T> end;
    events.began_walk();
    std::uint32_t entry = no_section, entry_next = no_section;
    const std::uint32_t turn_back = most_steps(scene);
    for (std::uint32_t steps = 2 * turn_back; steps > 0; --steps) {
        events.entered_cell(walked_cell(scene, cell).section_count);
        leave_cell(scene, ray, cell, entry, entry_next, steps > turn_back, stop, events, end);
        if (end.status == WalkStatus::Reached || !end.target.is_portal()) return end;
        if (end.target.is_glass()) {
            tint_by_glass(scene, cell, end.exit, end.face, throughput);
            events.crossed_glass();
        }
        // Through a floor or ceiling the prism stays the same: its exit section is no entry of the next cell.
        entry = end.exit == Exit::Side ? end.section : no_section;
        entry_next = end.next_section;
        cell = static_cast<std::uint32_t>(end.target.neighbour());
        events.crossed(cell);
        if (stop.ends_in(cell)) {
            end.cell = cell;
            end.status = WalkStatus::Reached;
            return end;
        }
    }
    end.status = WalkStatus::Leak;
    events.leaked();
    return end;
}

ENFILADE_HD NoLimit in_double(NoLimit) { return {}; }
ENFILADE_HD Limit<double> in_double(Limit<float> stop) { return {stop.t}; }
ENFILADE_HD ToPoint<double> in_double(ToPoint<float> stop) { return {stop.t, stop.cell}; }

/// Where noise has led a ray out of its cell by a section behind its origin: along a wall that it starts on, or one of
/// many corners in line. One section accepts it, and another than in truth.
ENFILADE_HD bool ends_behind(const Ray<float>& ray, const WalkEnd<float>& end) {
    if (!(end.num < 0.0f) || end.exit != Exit::Side || end.status != WalkStatus::Hit) return false;
    constexpr float metres = -1e-3f;  // what starts on a face may meet it a rounding behind itself
    return end.num / end.den * length(ray.direction) < metres;
}

/// What a walk in double found of a line in float.
ENFILADE_HD WalkEnd<float> in_float(const WalkEnd<double>& end) {
    return {end.status,
            end.exit,
            end.cell,
            end.section,
            end.next_section,
            end.face,
            end.target,
            static_cast<float>(end.num),
            static_cast<float>(end.den),
            static_cast<float>(end.facing)};
}

/// The same line, walked in double precision.
template <class Stop, class Throughput, class Events>
ENFILADE_HD_COLD WalkEnd<float> walk_in_double(const accel::SceneView& scene, Ray<float> ray, std::uint32_t cell,
                                               const Stop& stop, Throughput& throughput, Events& events) {
    const Ray<double> exact = make_ray_unchecked(vec_cast<double>(ray.origin), vec_cast<double>(ray.direction));
    return in_float(walk_in(scene, exact, cell, in_double(stop), throughput, events));
}

/// Follows the ray (walk_in) in its own precision, and in double where that led it out behind its origin.
template <class Scene, class T, class Stop, class Throughput, class Events>
ENFILADE_HD WalkEnd<T> walk(const Scene& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                            Throughput& throughput, Events& events) {
    const Throughput before = throughput;
    const WalkEnd<T> end = walk_in(scene, ray, cell, stop, throughput, events);
    if constexpr (sizeof(T) == sizeof(float)) {
        if (ends_behind(ray, end)) [[unlikely]] {
            throughput = before;
            return walk_in_double(scene, ray, cell, stop, throughput, events);
        }
    }
    return end;
}

/// The ray's parameter where the walk ended, in units of its (scaled) direction; not negative. Computed once, at the
/// end.
template <class Scene, class T>
ENFILADE_HD T parameter(const Scene& scene, const Ray<T>& ray, const WalkEnd<T>& end) {
    T t;
    if (end.exit == Exit::Side) {
        t = end.num / end.den;
    } else {
        const auto& cell = walked_cell(scene, end.cell);
        t = ((end.exit == Exit::Floor ? T(cell.z_floor) : T(cell.z_ceiling)) - ray.origin.z) / ray.direction.z;
    }
    return t > T(0) ? t : T(0);  // what starts on a face may meet it a rounding behind itself
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
