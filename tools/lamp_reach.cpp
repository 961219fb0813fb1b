#include "tools/lamp_reach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "plans/random.h"
#include "render/walk.h"
#include "tools/spread_lamps.h"

namespace enfilade::tools {

namespace {

using render::Vec3d;

/// Remembers into which cells rays came.
struct EnteredCells : render::NoEvents {
    std::vector<std::uint32_t> cells;
    void crossed(std::uint32_t cell) { cells.push_back(cell); }
};

/// A place p lies inside where normal . (p - through) >= 0; the normal has length 1.
struct Side {
    Vec3d normal, through;
};

class Reach {
public:
    Reach(const accel::SceneView& scene, const accel::LightTreesView& trees)
        : scene_(scene), trees_(trees), is_reached_(trees.cell_lights.size()) {}

    void send(std::uint32_t lamp, Vec3d along, LampReach& reach) {
        const accel::Light& light = scene_.lights[lamp];
        const Vec3d from = {light.position[0], light.position[1], light.position[2]};
        render::Ray<double> ray;
        if (!make_ray(from, along, ray)) return;
        entered_.cells.clear();
        entered_.crossed(static_cast<std::uint32_t>(light.cell));
        render::Vec3f throughput = {1, 1, 1};
        (void)walk(scene_, ray, static_cast<std::uint32_t>(light.cell), render::NoLimit{}, throughput, entered_);
        for (const std::uint32_t cell : entered_.cells) note(cell, lamp, reach);
    }

    /// Aims into those beams of entry k of the lists; k is a lamp's first entry in its cell.
    void aim(std::uint32_t cell, std::uint32_t k, LampReach& reach) {
        constexpr int starts = 12;
        const auto lamp = static_cast<std::uint32_t>(trees_.cell_lights[k].light);
        for (std::uint32_t b = k; is_of(cell, b, lamp); ++b)
            for (int start = 0; start < starts && is_reached_[k] == 0; ++start) {
                const std::vector<Side> sides = sides_of(cell, trees_.cell_lights[b]);
                const Vec3d place = inside(sides, random_place(scene_, scene_.cells[cell], 0, random_),
                                           start % 3 == 0   ? 1e-3
                                           : start % 3 == 1 ? 1e-4
                                                            : 1e-6);
                const accel::Light& light = scene_.lights[lamp];
                send(lamp, place - Vec3d{light.position[0], light.position[1], light.position[2]}, reach);
            }
    }

    [[nodiscard]] bool is_of(std::uint32_t cell, std::uint32_t k, std::uint32_t lamp) const {
        return k < trees_.cell_offsets[cell + 1] && static_cast<std::uint32_t>(trees_.cell_lights[k].light) == lamp;
    }
    [[nodiscard]] bool is_reached(std::uint32_t k) const { return is_reached_[k] != 0; }

private:
    /// Marks a lamp's first entry in the cell.
    void note(std::uint32_t cell, std::uint32_t lamp, LampReach& reach) {
        const auto begin = trees_.cell_lights.begin() + trees_.cell_offsets[cell];
        const auto end = trees_.cell_lights.begin() + trees_.cell_offsets[cell + 1];
        const auto found = std::lower_bound(begin, end, lamp, [](const accel::CellLight& l, std::uint32_t wanted) {
            return static_cast<std::uint32_t>(l.light) < wanted;
        });
        if (found == end || static_cast<std::uint32_t>(found->light) != lamp) ++reach.missed;
        else is_reached_[static_cast<std::size_t>(found - trees_.cell_lights.begin())] = 1;
    }

    [[nodiscard]] std::vector<Side> sides_of(std::uint32_t id, const accel::CellLight& entry) const {
        const accel::Cell& cell = scene_.cells[id];
        const double x = scene_.section_x[cell.first_section], y = scene_.section_y[cell.first_section];
        std::vector<Side> sides = {{{0, 0, 1}, {x, y, cell.z_floor}}, {{0, 0, -1}, {x, y, cell.z_ceiling}}};
        const auto add = [&](Vec3d normal, Vec3d through) {
            const double size = length(normal);
            if (size > 0) sides.push_back({(1 / size) * normal, through});
        };
        for (std::uint32_t i = 0; i < cell.section_count; ++i) {
            const std::uint32_t p = cell.first_section + i;
            const std::uint32_t q = cell.first_section + (i + 1u == cell.section_count ? 0 : i + 1);
            add({double(scene_.section_y[p]) - scene_.section_y[q], double(scene_.section_x[q]) - scene_.section_x[p],
                 0},
                {scene_.section_x[p], scene_.section_y[p], cell.z_floor});
        }
        const accel::Light& light = scene_.lights[static_cast<std::uint32_t>(entry.light)];
        if (entry.beam != accel::no_beam)
            for (const accel::BeamPlane& plane : trees_.planes_of(entry.beam))
                add({plane.x, plane.y, plane.z}, {light.position[0], light.position[1], light.position[2]});
        return sides;
    }

    /// Moves a place to the inner side of all by `depth` metres, from one to the next, where there is such a place.
    static Vec3d inside(const std::vector<Side>& sides, Vec3d place, double depth) {
        for (int round = 0; round < 64; ++round) {
            bool was_moved = false;
            for (const Side& side : sides) {
                const double in = dot(side.normal, place - side.through);
                if (in >= depth) continue;
                place = place + (depth - in) * side.normal;
                was_moved = true;
            }
            if (!was_moved) break;
        }
        return place;
    }

    const accel::SceneView& scene_;
    const accel::LightTreesView& trees_;
    std::vector<std::uint8_t> is_reached_;  ///< [cell_lights]: of a lamp's first entry in its cell
    EnteredCells entered_;
    plans::Random random_{82};
};

/// Spread over the sphere along a spiral.
Vec3d direction(std::size_t k, std::size_t count) {
    const double z = 1 - (2 * double(k) + 1) / double(count);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * double(k), radius = std::sqrt(1 - z * z);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace

LampReach lamp_reach(const accel::SceneView& scene, const accel::LightTreesView& trees, std::size_t rays_a_lamp) {
    Reach rays(scene, trees);
    LampReach reach;
    for (std::uint32_t lamp = 0; lamp < scene.lights.size(); ++lamp)
        for (std::size_t k = 0; k < rays_a_lamp; ++k) rays.send(lamp, direction(k, rays_a_lamp), reach);
    for (std::uint32_t c = 0; c + 1 < trees.cell_offsets.size(); ++c)
        for (std::uint32_t k = trees.cell_offsets[c]; k < trees.cell_offsets[c + 1]; ++k) {
            if (k > trees.cell_offsets[c] && trees.cell_lights[k - 1].light == trees.cell_lights[k].light) continue;
            ++reach.listed;
            if (!rays.is_reached(k)) rays.aim(c, k, reach);
            reach.reached += rays.is_reached(k) ? 1 : 0;
        }
    return reach;
}

}  // namespace enfilade::tools
