#pragma once
// Lamps and places to try light trees with.

#include <array>
#include <random>
#include <vector>

#include "tests/accel/light_judge.h"

namespace enfilade::test {

inline std::uint32_t random_cell(const accel::SceneView& view, std::mt19937_64& random) {
    return static_cast<std::uint32_t>(random() % view.cells.size());
}

inline std::vector<accel::Light> random_lamps(const accel::SceneView& view, std::size_t count,
                                              std::mt19937_64& random) {
    std::vector<accel::Light> lamps;
    for (std::size_t k = 0; k < count; ++k)
        lamps.push_back(lamp_at(view, random_point(view, random_cell(view, random), random)));
    return lamps;
}

/// Where ties are: corners of cells, the middles of their sides, floors, ceilings, vertical edges and gates.
inline std::vector<accel::Light> awkward_lamps(const accel::SceneView& view, std::size_t count,
                                               std::mt19937_64& random) {
    std::vector<accel::Light> lamps;
    while (lamps.size() < count) {
        const std::uint32_t c = random_cell(view, random);
        const accel::Cell& cell = view.cells[c];
        const std::uint32_t i = static_cast<std::uint32_t>(random() % cell.section_count);
        const std::uint32_t s = cell.first_section + i, t = cell.first_section + (i + 1) % cell.section_count;
        const std::uint32_t f = view.section_tails[s].first_face;
        const double share = double(random() % 3) / 2;
        const render::Vec3d middle = centre_of(view, c);
        const double levels[] = {cell.z_floor, cell.z_ceiling, view.side_faces[f].z_top, middle.z};
        const auto at = [&](float a, float b) { return double{a} + share * (double{b} - double{a}); };
        render::Vec3d p = {at(view.section_x[s], view.section_x[t]), at(view.section_y[s], view.section_y[t]),
                           levels[random() % 4]};
        if (random() % 4 == 0) p = {middle.x, middle.y, p.z};
        // A hair beside them, too, by less and by more than what float tells apart there.
        const double hair = std::array{0.0, 1e-6, 1e-5, 3e-4}[random() % 4];
        p = p + hair * random_direction(random);
        const accel::Light lamp = lamp_at(view, p);
        if (lamp.cell != none<accel::CellId>) lamps.push_back(lamp);
    }
    return lamps;
}

/// Places in the cells that list each lamp, where the light's borders are; and where rays from each lamp come along.
inline void judge_places(const LitScene& lit, LightJudge& judge, std::size_t places, std::mt19937_64& random) {
    const accel::SceneView& view = lit.view;
    const accel::LightTreesView trees = lit.trees.view();
    for (std::size_t k = 0; k < places; ++k) {
        const std::uint32_t c = random_cell(view, random);
        const render::Vec3d p = random_point(view, c, random);
        for (std::uint32_t e = trees.cell_offsets[c]; e < trees.cell_offsets[c + 1]; ++e)
            judge.judge(p, c, static_cast<std::uint32_t>(trees.cell_lights[e].light));
        judge.judge(p, c, static_cast<std::uint32_t>(random() % lit.lights.size()));
    }
    for (std::uint32_t l = 0; l < lit.lights.size(); ++l) {
        if (lit.lights[l].cell == none<accel::CellId>) continue;
        const render::Vec3d from = place_of(lit.lights[l]);
        for (std::size_t k = 0; k < places / lit.lights.size() + 1; ++k) {
            render::Vec3d d = random_direction(random);
            if (k % 2 == 0) d.z *= 0.05;
            render::Ray<double> ray;
            if (!render::make_ray(from, d, ray)) continue;
            const auto walked = follow(view, ray, static_cast<std::uint32_t>(lit.lights[l].cell));
            const std::uint32_t c = walked.path.cells[random() % walked.path.cells.size()];
            // Somewhere on the ray in that cell: between where it comes and goes, found by halves.
            const double end = parameter(view, ray, walked.end);
            for (int tries = 0; tries < 16; ++tries) {
                const render::Vec3d p =
                    rounded_to_float(from + (end * double(random() >> 11) * 0x1p-53) * ray.direction);
                if (!contains(view, accel::CellId{c}, {p.x, p.y, p.z})) continue;
                judge.judge(p, c, l);
                break;
            }
        }
    }
}

}  // namespace enfilade::test
