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
};

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
};

/// Walks at most `t` times the ray's (scaled) direction.
template <class T>
struct Limit {
    T t;
    ENFILADE_HD bool before_side(T num, T den) const { return !(num <= t * den); }
    /// rise: from the origin up to the level.
    ENFILADE_HD bool before_level(T rise, T dz) const { return dz < T(0) ? !(rise >= t * dz) : !(rise <= t * dz); }
};

inline constexpr std::uint32_t no_section = 0xffffffffu;
inline constexpr std::uint32_t bit_sections = 32;

/// The section of a cell by which a ray leaves, and the plane of that section along the ray.
template <class T>
struct SectionExit {
    std::uint32_t section, next;
    T num, den;
};

/// num = C - n.o and den = n.d for the outward normal n = (ey, -ex) of the section from p to q. den is the difference
/// of two sides that are known already. Seen from the neighbour, both are exactly negated or exactly equal.
template <class T>
ENFILADE_HD SectionExit<T> section_exit(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t section,
                                        std::uint32_t next) {
    const T px = scene.section_x[section], py = scene.section_y[section];
    const T qx = scene.section_x[next], qy = scene.section_y[next];
    const T den = ray.line_sign * (line_side(ray, qx, qy) - line_side(ray, px, py));
    T c;
    if constexpr (sizeof(T) == sizeof(double)) c = px * qy - qx * py;  // exact: products of 25 bits each
    else c = scene.section_tails[section].c;
    const T num = fused(qx - px, ray.origin.y, fused(-(qy - py), ray.origin.x, c));
    return {section, next, num, den};
}

/// The rare cases: a vertical ray; several sections that accept; none that does. README.md, "Ties and noise".
template <class T, class Events>
ENFILADE_HD_COLD SectionExit<T> resolve_exit(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t first,
                                             std::uint32_t count, std::uint32_t entry, std::uint32_t entry_next,
                                             Events& events) {
    if (ray.direction.x == T(0) && ray.direction.y == T(0)) return {no_section, no_section, T(1), T(0)};
    SectionExit<T> farthest = {no_section, no_section, T(0), T(1)};
    SectionExit<T> nearest_miss = farthest;
    T best_margin = T(0);
    std::uint32_t accepting = 0;
    const std::uint32_t last = first + count - 1;
    const T sign = ray.line_sign;
    T side = sign * line_side(ray, T(scene.section_x[first]), T(scene.section_y[first]));
    for (std::uint32_t i = first; i <= last; ++i) {
        const std::uint32_t j = i == last ? first : i + 1;
        const T next_side = sign * line_side(ray, T(scene.section_x[j]), T(scene.section_y[j]));
        const bool zero = ray.zero_mask != 0;
        const bool right = !(side > T(0) || (side == T(0) && zero));
        const bool left = next_side > T(0) || (next_side == T(0) && zero);
        const bool is_entry = entry != no_section && scene.section_x[i] == scene.section_x[entry_next] &&
                              scene.section_y[i] == scene.section_y[entry_next] &&
                              scene.section_x[j] == scene.section_x[entry] &&
                              scene.section_y[j] == scene.section_y[entry];
        if (!is_entry) {
            const SectionExit<T> candidate = section_exit(scene, ray, i, j);
            if (right && left) {
                ++accepting;
                if (farthest.section == no_section || candidate.num * farthest.den > farthest.num * candidate.den)
                    farthest = candidate;
            }
            const T margin = -side < next_side ? -side : next_side;
            if (nearest_miss.section == no_section || margin > best_margin ||
                (margin == best_margin && candidate.den > nearest_miss.den)) {
                best_margin = margin;
                nearest_miss = candidate;
            }
        }
        side = next_side;
    }
    if (accepting > 1) events.several_exits();
    if (accepting == 0) events.no_exit();
    return accepting > 0 ? farthest : nearest_miss;
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
template <class T>
ENFILADE_HD std::uint32_t only_accepting(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t first,
                                         std::uint32_t count) {
    const float* xs = scene.section_x.first + first;
    const float* ys = scene.section_y.first + first;
    if (count <= bit_sections) {
        const std::uint32_t bits = left_bits(ray, xs, ys, count) ^ ray.zero_mask;
        const std::uint32_t all = ~0u >> (bit_sections - count);
        const std::uint32_t next_bits = (bits & all) >> 1 | (bits & 1u) << (count - 1);
        const std::uint32_t accepting = ~bits & next_bits;
        return accepting != 0 && (accepting & (accepting - 1)) == 0 ? lowest_bit(accepting) : no_section;
    }
    std::uint32_t found = no_section, found_count = 0;
    std::uint32_t first_bit = 0, bit_before = 1;  // nothing ends before the first section
    for (std::uint32_t begin = 0; begin < count; begin += bit_sections) {
        const std::uint32_t size = count - begin < bit_sections ? count - begin : bit_sections;
        const std::uint32_t bits = left_bits(ray, xs + begin, ys + begin, size) ^ ray.zero_mask;
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

/// Step 1: the exit section, by one side test a vertical line; consecutive sections share theirs.
template <class T, class Events>
ENFILADE_HD SectionExit<T> find_section(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t first,
                                        std::uint32_t count, std::uint32_t entry, std::uint32_t entry_next,
                                        Events& events) {
    const std::uint32_t i = only_accepting(scene, ray, first, count);
    if (i == no_section) return resolve_exit(scene, ray, first, count, entry, entry_next, events);
    return section_exit(scene, ray, first + i, i + 1 == count ? first : first + i + 1);
}

/// Step 2: the face in the exit section's stack, bottom-up, without division. Equality counts as above: every level is
/// shifted down by a vanishing amount, the same for both directions of the ray.
template <class T, class Stop>
ENFILADE_HD void find_face(const accel::SceneView& scene, const Ray<T>& ray, const accel::Cell& cell,
                           const SectionExit<T>& exit, const Stop& stop, WalkEnd<T>& end) {
    const T scaled_dz = exit.num * ray.direction.z;
    const T floor_rise = T(cell.z_floor) - ray.origin.z;
    end.section = exit.section;
    end.next_section = exit.next;
    end.num = exit.num;
    end.den = exit.den;
    if (exit.section == no_section ? ray.direction.z < T(0) : scaled_dz < floor_rise * exit.den) {
        end.exit = Exit::Floor;
        end.target = cell.floor;
        end.status = stop.before_level(floor_rise, ray.direction.z) ? WalkStatus::Reached : WalkStatus::Hit;
        return;
    }
    if (exit.section != no_section) {
        const std::uint32_t face_end = scene.section_tails[exit.section + 1].first_face;
        for (std::uint32_t face = scene.section_tails[exit.section].first_face; face < face_end; ++face) {
            if (scaled_dz < (T(scene.side_faces[face].z_top) - ray.origin.z) * exit.den) {
                end.exit = Exit::Side;
                end.face = face;
                end.target = scene.side_faces[face].target;
                end.status = stop.before_side(exit.num, exit.den) ? WalkStatus::Reached : WalkStatus::Hit;
                return;
            }
        }
    }
    end.exit = Exit::Ceiling;
    end.target = cell.ceiling;
    const T rise = T(cell.z_ceiling) - ray.origin.z;
    end.status = stop.before_level(rise, ray.direction.z) ? WalkStatus::Reached : WalkStatus::Hit;
}

/// Glass on the way multiplies the throughput by its tint. Out of line: windows are rare.
ENFILADE_HD_COLD inline void cross_glass(const accel::SceneView& scene, std::uint32_t cell, Exit exit,
                                         std::uint32_t face, Vec3f& throughput) {
    const accel::PortalId portal = exit == Exit::Side    ? scene.side_face_portals[face]
                                   : exit == Exit::Floor ? scene.cell_portals[cell].floor
                                                         : scene.cell_portals[cell].ceiling;
    const accel::Vertex tint = scene.tints[scene.portals[static_cast<std::uint32_t>(portal)].kind_and_tint >> 2];
    throughput = throughput * Vec3f{tint.x, tint.y, tint.z};
}

/// Follows the ray from `cell`, which holds its origin, through portals until a source face stops it or `stop` does.
/// Ends after at most as many steps as there are cells (plus a few): a straight line enters no convex cell twice.
template <class T, class Stop, class Events>
ENFILADE_HD WalkEnd<T> walk(const accel::SceneView& scene, const Ray<T>& ray, std::uint32_t cell, const Stop& stop,
                            Vec3f& throughput, Events& events) {
    WalkEnd<T> end;
    std::uint32_t entry = no_section, entry_next = no_section;
    for (std::uint64_t steps = scene.cells.count + 16; steps > 0; --steps) {
        events.entered_cell();
        const accel::Cell& c = scene.cells[cell];
        const SectionExit<T> exit =
            find_section(scene, ray, c.first_section, c.section_count, entry, entry_next, events);
        find_face(scene, ray, c, exit, stop, end);
        end.cell = cell;
        if (end.status == WalkStatus::Reached || !end.target.is_portal()) return end;
        if (end.target.is_glass()) {
            cross_glass(scene, cell, end.exit, end.face, throughput);
            events.crossed_glass();
        }
        // Through a floor or ceiling the prism stays the same: its exit section is no entry of the next cell.
        entry = end.exit == Exit::Side ? exit.section : no_section;
        entry_next = exit.next;
        cell = static_cast<std::uint32_t>(end.target.neighbour());
        events.crossed(cell);
    }
    end.status = WalkStatus::Leak;
    events.leaked();
    return end;
}

/// The ray's parameter where the walk ended, in units of its (scaled) direction. Computed once, at the end.
template <class T>
ENFILADE_HD T parameter(const accel::SceneView& scene, const Ray<T>& ray, const WalkEnd<T>& end) {
    const T dz = ray.direction.z;
    if (end.exit == Exit::Side) return end.num / end.den;
    const accel::Cell& cell = scene.cells[end.cell];
    const T t = ((end.exit == Exit::Floor ? T(cell.z_floor) : T(cell.z_ceiling)) - ray.origin.z) / dz;
    // A level grazed within rounding may lie behind or beside the ray: the prism's exit is where it is met.
    const bool is_ahead = t >= T(0) && t < T(1e30);
    return is_ahead || !(end.den > T(0)) ? t : end.num / end.den;
}

}  // namespace ENFILADE_ISA
}  // namespace enfilade::render
