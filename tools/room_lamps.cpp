#include "tools/room_lamps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/walk.h"

namespace enfilade::tools {

namespace {

/// Remembers in which cells a lamp shines.
struct LitCells : render::NoEvents {
    std::uint32_t lamp;
    std::vector<std::vector<std::uint32_t>>* seen_from;

    LitCells(std::uint32_t lamp_, std::vector<std::vector<std::uint32_t>>& seen) : lamp(lamp_), seen_from(&seen) {}
    void crossed(std::uint32_t cell) {
        std::vector<std::uint32_t>& lamps = (*seen_from)[cell];
        if (lamps.empty() || lamps.back() != lamp) lamps.push_back(lamp);
    }
};

double floor_area(const accel::SceneView& scene, const accel::Cell& cell) {
    double twice = 0;
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t p = cell.first_section + i;
        const std::uint32_t q = cell.first_section + (i + 1u == cell.section_count ? 0 : i + 1);
        twice += double(scene.section_x[p]) * scene.section_y[q] - double(scene.section_x[q]) * scene.section_y[p];
    }
    return twice / 2;
}

/// The largest cell of every room. [space]; none<CellId> where it is no room
std::vector<accel::CellId> largest_cells(const accel::SceneView& scene) {
    std::vector<accel::CellId> largest(scene.spaces.size(), none<accel::CellId>);
    std::vector<double> area(scene.spaces.size());
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        const accel::Cell& cell = scene.cells[c];
        if (cell.label != accel::Label::Room || cell.space == none<accel::SpaceId>) continue;
        const double own = floor_area(scene, cell);
        if (own <= area[index(cell.space)]) continue;
        area[index(cell.space)] = own;
        largest[index(cell.space)] = static_cast<accel::CellId>(c);
    }
    return largest;
}

void add_lamp(PointColumns& places, const accel::SceneView& scene, accel::CellId id) {
    const accel::Cell& cell = scene.cells[index(id)];
    double x = 0, y = 0;
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        x += double(scene.section_x[s]) / cell.section_count;
        y += double(scene.section_y[s]) / cell.section_count;
    }
    const float height = cell.z_ceiling - cell.z_floor;
    places.x.push_back(float(x));
    places.y.push_back(float(y));
    places.z.push_back(cell.z_ceiling - std::min(0.1f, height / 2));
    places.cell.push_back(id);
}

/// Spread over the sphere along a spiral.
render::Vec3f direction(std::size_t k, std::size_t count) {
    const double z = 1 - (2 * double(k) + 1) / double(count);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * double(k), radius = std::sqrt(1 - z * z);
    return {float(radius * std::cos(angle)), float(radius * std::sin(angle)), float(z)};
}

}  // namespace

RoomLamps room_lamps(const accel::SceneView& scene, std::size_t rays_a_lamp) {
    RoomLamps lamps;
    for (const accel::CellId cell : largest_cells(scene))
        if (cell != none<accel::CellId>) add_lamp(lamps.places, scene, cell);
    lamps.seen_from.resize(scene.cells.size());
    std::vector<render::Vec3f> directions;
    for (std::size_t k = 0; k < rays_a_lamp; ++k) directions.push_back(direction(k, rays_a_lamp));
    for (std::uint32_t lamp = 0; lamp < lamps.places.x.size(); ++lamp) {
        LitCells lit(lamp, lamps.seen_from);
        const auto start = static_cast<std::uint32_t>(lamps.places.cell[lamp]);
        lit.crossed(start);
        for (const render::Vec3f& along : directions) {
            render::Ray<float> ray;
            if (!make_ray({lamps.places.x[lamp], lamps.places.y[lamp], lamps.places.z[lamp]}, along, ray)) continue;
            render::Vec3f throughput = {1, 1, 1};
            (void)walk(scene, ray, start, render::NoLimit{}, throughput, lit);
        }
    }
    return lamps;
}

OwnedSegments shadow_rays(const PointColumns& points, const RoomLamps& lamps) {
    constexpr std::size_t group = 16;
    OwnedSegments segments;
    const auto append = [](PointColumns& to, const PointColumns& from, std::size_t i) {
        to.x.push_back(from.x[i]);
        to.y.push_back(from.y[i]);
        to.z.push_back(from.z[i]);
        to.cell.push_back(from.cell[i]);
    };
    std::vector<std::uint32_t> all;
    for (std::size_t begin = 0; begin < points.x.size(); begin += group) {
        const std::size_t end = std::min(points.x.size(), begin + group);
        const auto seen = [&](std::size_t i) -> const auto& { return lamps.seen_from[index(points.cell[i])]; };
        all.clear();
        for (std::size_t i = begin; i < end; ++i) all.insert(all.end(), seen(i).begin(), seen(i).end());
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        for (const std::uint32_t lamp : all)
            for (std::size_t i = begin; i < end; ++i) {
                if (!std::binary_search(seen(i).begin(), seen(i).end(), lamp)) continue;
                append(segments.from, points, i);
                append(segments.to, lamps.places, lamp);
            }
    }
    return segments;
}

}  // namespace enfilade::tools
