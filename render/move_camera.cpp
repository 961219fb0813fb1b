#include "render/move_camera.h"

#include <algorithm>

#include "render/walk.h"

namespace enfilade::render {
namespace {

struct Stretch {
    double free;  ///< metres
    std::uint32_t cell;
};

/// How far one can go along `direction` (length 1), at most `limit` metres, and the cell there.
Stretch free_stretch(const accel::SceneView& scene, const Ray<double>& ray, double metres, std::uint32_t cell,
                     double limit) {
    const Limit<double> stop{limit / metres};
    std::uint32_t entry = no_section, entry_next = no_section;
    NoEvents events;
    for (std::uint64_t steps = scene.cells.count + 16; steps > 0; --steps) {
        WalkEnd<double> end;
        leave_cell(scene, ray, cell, entry, entry_next, true, stop, events, end);
        if (end.status == WalkStatus::Reached) return {limit, cell};
        if (!end.target.is_portal() || end.target.is_glass())
            return {std::clamp(parameter(scene, ray, end) * metres, 0.0, limit), cell};
        entry = end.exit == Exit::Side ? end.section : no_section;
        entry_next = end.next_section;
        cell = static_cast<std::uint32_t>(end.target.neighbour());
    }
    return {0, cell};
}

}  // namespace

Place move_camera(const accel::SceneView& scene, const Place& from, Vec3d step, double clearance) {
    Ray<double> ray;
    const double wanted = length(step);
    if (!make_ray(from.point, step, ray) || !(wanted > 0)) return from;
    const double metres = length(ray.direction);
    const auto start = static_cast<std::uint32_t>(from.cell);
    const Stretch ahead = free_stretch(scene, ray, metres, start, wanted + clearance);
    const double distance = std::min(wanted, ahead.free - clearance);
    if (!(distance > 0)) return from;
    const Stretch there = free_stretch(scene, ray, metres, start, distance);
    return {from.point + (distance / wanted) * step, static_cast<accel::CellId>(there.cell)};
}

}  // namespace enfilade::render
