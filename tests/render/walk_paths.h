#pragma once
// Walks that remember which cells they crossed, and rays to try them with.

#include <cstdint>
#include <random>
#include <vector>

#include "accel/scene.h"
#include "render/walk.h"
#include "tests/support/rounded_to_float.h"

namespace enfilade::test {

struct Path : render::NoEvents {
    std::vector<std::uint32_t> cells;
    int several = 0;
    int none = 0;
    int panes = 0;
    ENFILADE_HD void several_exits() { ++several; }
    ENFILADE_HD void no_exit() { ++none; }
    ENFILADE_HD void crossed_glass() { ++panes; }
    void crossed(std::uint32_t cell) { cells.push_back(cell); }
};

template <class T>
struct WalkedPath {
    Path path;
    render::WalkEnd<T> end;
};

/// Walks from `cell` until something stops the ray; the path begins with `cell`.
template <class T>
WalkedPath<T> follow(const accel::SceneView& scene, const render::Ray<T>& ray, std::uint32_t cell) {
    WalkedPath<T> walked;
    walked.path.cells.push_back(cell);
    render::Vec3f throughput = {1, 1, 1};
    walked.end = render::walk(scene, ray, cell, render::NoLimit{}, throughput, walked.path);
    return walked;
}

/// The centre of a cell, as floats.
inline render::Vec3d centre_of(const accel::SceneView& scene, std::uint32_t c) {
    const accel::Cell& cell = scene.cells[c];
    float x = 0, y = 0;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        x += scene.section_x[s] / static_cast<float>(cell.section_count);
        y += scene.section_y[s] / static_cast<float>(cell.section_count);
    }
    return {x, y, 0.5f * (cell.z_floor + cell.z_ceiling)};
}

/// A unit vector, evenly distributed.
inline render::Vec3d random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    for (;;) {
        const render::Vec3d d = {normal(random), normal(random), normal(random)};
        if (render::length(d) > 1e-3) return render::normalized(d);
    }
}

/// A point inside cell c, drawn between its centre and a random point of its hull; rounded to float.
inline render::Vec3d random_point(const accel::SceneView& scene, std::uint32_t c, std::mt19937_64& random) {
    const accel::Cell& cell = scene.cells[c];
    std::uniform_real_distribution<double> unit(0.02, 0.98);
    const render::Vec3d centre = centre_of(scene, c);
    const std::uint32_t i = static_cast<std::uint32_t>(random() % cell.section_count);
    const std::uint32_t a = cell.first_section + i, b = cell.first_section + (i + 1) % cell.section_count;
    const double s = unit(random), t = unit(random);
    const double x = double{scene.section_x[a]} + s * (double{scene.section_x[b]} - double{scene.section_x[a]});
    const double y = double{scene.section_y[a]} + s * (double{scene.section_y[b]} - double{scene.section_y[a]});
    const double z = double{cell.z_floor} + unit(random) * (double{cell.z_ceiling} - double{cell.z_floor});
    return rounded_to_float(render::Vec3d{centre.x + t * (x - centre.x), centre.y + t * (y - centre.y), z});
}

}  // namespace enfilade::test
