#pragma once
// Judges light trees by walks in double precision from places to lamps.

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "accel/lights/light_trees.h"
#include "accel/locate.h"
#include "render/executor.h"
#include "render/oracle.h"
#include "tests/render/walk_paths.h"

namespace enfilade::test {

/// A scene's view with lamps of a test's own.
struct LitScene {
    accel::SceneView view;
    std::vector<accel::Light> lights;
    accel::LightTrees trees;

    LitScene(const accel::SceneView& scene, std::vector<accel::Light> lamps,
             const accel::LightTreeOptions& options = {})
        : view(scene), lights(std::move(lamps)) {
        view.lights = {lights.data(), lights.size()};
        trees = build_light_trees(view, options, accel::SerialExecutor());
    }
    LitScene(const LitScene&) = delete;
    LitScene& operator=(const LitScene&) = delete;
};

/// A lamp at the place, rounded to float.
inline accel::Light lamp_at(const accel::SceneView& scene, const render::Vec3d& p) {
    accel::Light lamp = {};
    lamp.position = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
    lamp.intensity = {100, 100, 100};
    lamp.cell = locate(scene, {lamp.position[0], lamp.position[1], lamp.position[2]}).value_or(none<accel::CellId>);
    lamp.carrier = none<accel::ObjectId>;
    return lamp;
}

inline render::Vec3d place_of(const accel::Light& lamp) {
    return {lamp.position[0], lamp.position[1], lamp.position[2]};
}

/// Whether the walk in double from p gets to the lamp.
inline bool walk_sees(const accel::SceneView& scene, const render::Vec3d& p, std::uint32_t cell,
                      const accel::Light& lamp, bool through_glass = true) {
    const auto lamp_cell = static_cast<std::uint32_t>(lamp.cell);
    if (cell == lamp_cell) return true;
    render::Ray<double> ray;
    const render::Vec3d way = place_of(lamp) - p;
    if (!render::make_ray(p, way, ray)) return true;
    const double t = render::largest_part(way) / render::largest_part(ray.direction);
    Path path;
    render::Vec3f throughput = {1, 1, 1};
    const auto end = render::walk(scene, ray, cell, render::ToPoint<double>{t, lamp_cell}, throughput, path);
    return end.status == render::WalkStatus::Reached && (through_glass || path.panes == 0);
}

/// Whether the cell's list has the lamp.
inline bool lists(const accel::LightTreesView& trees, std::uint32_t cell, std::uint32_t light) {
    for (std::uint32_t k = trees.cell_offsets[cell]; k < trees.cell_offsets[cell + 1]; ++k)
        if (static_cast<std::uint32_t>(trees.cell_lights[k].light) == light) return true;
    return false;
}

/// Whether planes answer for the lamp in this cell; else a walk does. \pre lists
inline bool has_beams(const accel::LightTreesView& trees, std::uint32_t cell, std::uint32_t light) {
    for (std::uint32_t k = trees.cell_offsets[cell]; k < trees.cell_offsets[cell + 1]; ++k)
        if (static_cast<std::uint32_t>(trees.cell_lights[k].light) == light)
            return trees.cell_lights[k].beam != accel::no_beam;
    return true;
}

/// The first beam of the lamp that holds the place, tested in float as tracers do; nothing where none does.
inline std::optional<std::uint32_t> beam_at(const accel::LightTreesView& trees, const accel::Light& lamp,
                                            std::uint32_t cell, std::uint32_t light, const render::Vec3d& p) {
    const float x = static_cast<float>(p.x) - lamp.position[0], y = static_cast<float>(p.y) - lamp.position[1],
                z = static_cast<float>(p.z) - lamp.position[2];
    for (std::uint32_t k = trees.cell_offsets[cell]; k < trees.cell_offsets[cell + 1]; ++k) {
        const accel::CellLight entry = trees.cell_lights[k];
        if (static_cast<std::uint32_t>(entry.light) != light || entry.beam == accel::no_beam) continue;
        bool is_held = true;
        for (const accel::BeamPlane& plane : trees.planes_of(entry.beam))
            is_held = is_held && plane.x * x + plane.y * y + plane.z * z >= 0;
        if (is_held) return entry.beam;
    }
    return std::nullopt;
}

/// What became of pairs of a place and a lamp.
struct LightVerdict {
    std::size_t pairs = 0;
    std::size_t seen = 0;
    std::size_t missed = 0;     ///< seen, and the cell does not list the lamp
    std::size_t walked = 0;     ///< the lamp has no tree, the walk itself decides
    std::size_t differing = 0;  ///< outside the error band the planes say otherwise than the walk
    std::size_t in_band = 0;    ///< differing inside it
    std::string first;
};

class LightJudge {
public:
    explicit LightJudge(const LitScene& lit) : lit_(lit), trees_(lit.trees.view()), oracle_(lit.view) {}

    /// p: as float holds it.
    void judge(const render::Vec3d& p, std::uint32_t cell, std::uint32_t light) {
        const accel::Light& lamp = lit_.lights[light];
        if (lamp.cell == none<accel::CellId>) return;
        ++verdict.pairs;
        const bool seen = walk_sees(lit_.view, p, cell, lamp);
        verdict.seen += seen ? 1 : 0;
        if (seen && !lists(trees_, cell, light)) {
            ++verdict.missed;
            note("missed", p, cell, light);
            return;
        }
        if (!has_beams(trees_, cell, light)) {
            ++verdict.walked;
            return;
        }
        if (beam_at(trees_, lamp, cell, light, p).has_value() == seen) return;
        const render::Vec3d way = p - place_of(lamp);
        const double band = 2 * render::error_band(lit_.view);
        // An edge right behind either end decides, too: at a grazing angle, from afar.
        const double metres = render::length(way);
        if (oracle_.edge_distance(place_of(lamp), way, metres + 0.1) <= band ||
            oracle_.edge_distance(p, -1.0 * way, metres + 0.1) <= band) {
            ++verdict.in_band;
            return;
        }
        ++verdict.differing;
        note(seen ? "dark though seen" : "lit though not seen", p, cell, light);
    }

    LightVerdict verdict;

private:
    void note(const char* what, const render::Vec3d& p, std::uint32_t cell, std::uint32_t light) {
        if (!verdict.first.empty()) return;
        const render::Vec3d q = place_of(lit_.lights[light]);
        char text[240];
        std::snprintf(text, sizeof text, "%s: (%.9g, %.9g, %.9g) in cell %u, lamp %u at (%.9g, %.9g, %.9g) in cell %u",
                      what, p.x, p.y, p.z, cell, light, q.x, q.y, q.z,
                      static_cast<std::uint32_t>(lit_.lights[light].cell));
        verdict.first = text;
    }

    const LitScene& lit_;
    accel::LightTreesView trees_;
    render::Oracle oracle_;
};

}  // namespace enfilade::test
