#include "tools/cut_summary.h"

#include <cmath>
#include <functional>

namespace enfilade::tools {
namespace {

using accel::Cell;
using accel::SceneView;
using accel::TargetKind;
using modeler::PolygonSide;

std::uint32_t next_section(const Cell& cell, std::uint32_t s) {
    return s + 1 < cell.first_section + cell.section_count ? s + 1 : cell.first_section;
}

double side_length(const SceneView& scene, std::uint32_t s, std::uint32_t next) {
    return std::hypot(double(scene.section_x[next]) - double(scene.section_x[s]),
                      double(scene.section_y[next]) - double(scene.section_y[s]));
}

double floor_area(const SceneView& scene, const Cell& cell) {
    double twice = 0;
    const double x0 = double(scene.section_x[cell.first_section]), y0 = double(scene.section_y[cell.first_section]);
    for (std::uint32_t k = 1; k + 1 < cell.section_count; ++k) {
        const std::uint32_t s = cell.first_section + k;
        twice += (double(scene.section_x[s]) - x0) * (double(scene.section_y[s + 1]) - y0) -
                 (double(scene.section_x[s + 1]) - x0) * (double(scene.section_y[s]) - y0);
    }
    return twice / 2;
}

/// Calls `seen(cell, neighbour, area)` for every virtual portal, once.
void for_virtual_portals(const SceneView& scene,
                         const std::function<void(std::uint32_t, std::uint32_t, double)>& seen) {
    const auto is_first = [](accel::Target target, std::uint32_t cell) {
        return target.kind() == TargetKind::Virtual && cell < index(target.neighbour());
    };
    for (std::uint32_t c = 0; c < scene.cells.size(); ++c) {
        const Cell& cell = scene.cells[c];
        for (const accel::Target target : {cell.floor, cell.ceiling})
            if (is_first(target, c)) seen(c, std::uint32_t(index(target.neighbour())), floor_area(scene, cell));
        for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
            double z = double(cell.z_floor);
            for (std::uint32_t f = scene.section_tails[s].first_face; f < scene.section_tails[s + 1].first_face; ++f) {
                const accel::SideFace& face = scene.side_faces[f];
                if (is_first(face.target, c))
                    seen(c, std::uint32_t(index(face.target.neighbour())),
                         side_length(scene, s, next_section(cell, s)) * (double(face.z_top) - z));
                z = double(face.z_top);
            }
        }
    }
}

/// The cells of a room as the partition that `sah_sum` judges: points in grid units.
struct RoomPartition {
    std::vector<plans::GridPoint> points;
    modeler::Partition pieces;
    double height = 0;

    void add(const SceneView& scene, const Cell& cell) {
        const auto first = std::uint32_t(points.size());
        for (std::uint32_t k = 0; k < cell.section_count; ++k) {
            const std::uint32_t s = cell.first_section + k;
            points.push_back({std::int32_t(std::lround(double(scene.section_x[s]) / scene.unit)),
                              std::int32_t(std::lround(double(scene.section_y[s]) / scene.unit))});
            const std::uint32_t face = scene.section_tails[s].first_face;
            const accel::Target target = scene.side_faces[face].target;
            const bool is_cut =
                target.kind() == TargetKind::Virtual && scene.cells[index(target.neighbour())].space == cell.space;
            // Sections are whole already: no two of them go on along one line.
            pieces.sides.push_back({.from = first + k,
                                    .to = first + (k + 1) % cell.section_count,
                                    .line = first + k,
                                    .tag = is_cut ? modeler::cut_tag : 0,
                                    .look = 0,
                                    .faces = scene.section_tails[s + 1].first_face - face});
        }
        pieces.first_side.push_back(std::uint32_t(pieces.sides.size()));
        height = double(cell.z_ceiling) - double(cell.z_floor);
    }
};

}  // namespace

std::vector<SpaceCuts> cuts_per_space(const SceneView& scene, const modeler::CutCost& cost) {
    std::vector<SpaceCuts> spaces(scene.spaces.size());
    std::vector<RoomPartition> rooms(scene.spaces.size());
    for (const Cell& cell : scene.cells) {
        SpaceCuts& space = spaces[index(cell.space)];
        ++space.cells;
        space.sections += cell.section_count;
        space.faces += scene.section_tails[cell.first_section + cell.section_count].first_face -
                       scene.section_tails[cell.first_section].first_face;
        if (cell.label == accel::Label::Room) rooms[index(cell.space)].add(scene, cell);
    }
    for_virtual_portals(scene, [&](std::uint32_t a, std::uint32_t b, double area) {
        if (scene.cells[a].space == scene.cells[b].space) spaces[index(scene.cells[a].space)].cut_area_m2 += area;
    });
    for (std::size_t s = 0; s < spaces.size(); ++s)
        if (rooms[s].pieces.piece_count() > 0)
            spaces[s].sah_sum = modeler::sah_sum(rooms[s].points, rooms[s].pieces, scene.unit, rooms[s].height, cost);
    return spaces;
}

double virtual_area(const SceneView& scene) {
    double sum = 0;
    for_virtual_portals(scene, [&](std::uint32_t, std::uint32_t, double area) { sum += area; });
    return sum;
}

}  // namespace enfilade::tools
