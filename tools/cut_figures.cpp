#include "tools/cut_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "accel/scene_file.h"
#include "accel/stats.h"

namespace enfilade::tools {

namespace {

struct Sizes {
    double floor = 0;      ///< m2
    double perimeter = 0;  ///< m
    double height = 0;     ///< m
    [[nodiscard]] double surface() const { return perimeter * height + 2 * floor; }
};

/// What a walk reads, and what finds the cell in which it begins; the others are read once, where it ends.
constexpr std::array<std::string_view, 11> walk_arrays = {
    "cells",   "cell_portals", "section_x",     "section_y",    "section_tails", "side_faces", "side_face_portals",
    "portals", "tints",        "locator_nodes", "locator_cells"};

std::uint32_t section_after(const accel::Cell& cell, std::uint32_t s) {
    return s + 1 == cell.first_section + cell.section_count ? cell.first_section : s + 1;
}

double section_length(const accel::SceneView& scene, const accel::Cell& cell, std::uint32_t s) {
    const std::uint32_t t = section_after(cell, s);
    return std::hypot(double(scene.section_x[t]) - scene.section_x[s], double(scene.section_y[t]) - scene.section_y[s]);
}

Sizes sizes_of(const accel::SceneView& scene, const accel::Cell& cell) {
    Sizes sizes;
    const double x0 = scene.section_x[cell.first_section], y0 = scene.section_y[cell.first_section];
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        const std::uint32_t t = section_after(cell, s);
        sizes.perimeter += section_length(scene, cell, s);
        sizes.floor += ((scene.section_x[s] - x0) * (scene.section_y[t] - y0) -
                        (scene.section_x[t] - x0) * (scene.section_y[s] - y0)) /
                       2;
    }
    sizes.height = double(cell.z_ceiling) - cell.z_floor;
    return sizes;
}

/// Portals as one of their cells sees them.
class PortalSides {
public:
    PortalSides(const modeler::Building& building, const accel::SceneView& scene, CutFigures& figures)
        : building_(building), scene_(scene), figures_(figures) {}

    void add(const accel::Cell& cell, accel::Target target, double area) {
        if (target.kind() != accel::TargetKind::Virtual) return;
        const accel::Cell& other = scene_.cells[index(target.neighbour())];
        // Both sides come by: half the portal each.
        if (other.space == cell.space) figures_.portal_area += area / 2;
        if (building_.volumes[other.volume].parent == building_.volumes[cell.volume].parent)
            figures_.parent_surface -= area;
    }

private:
    const modeler::Building& building_;
    const accel::SceneView& scene_;
    CutFigures& figures_;
};

void add_cell(const modeler::Building& building, const accel::SceneView& scene, const accel::Cell& cell,
              CutFigures& figures) {
    const Sizes sizes = sizes_of(scene, cell);
    const std::uint32_t end = cell.first_section + cell.section_count;
    const std::uint32_t faces =
        scene.section_tails[end].first_face - scene.section_tails[cell.first_section].first_face;
    figures.cell_surface += sizes.surface();
    figures.parent_surface += sizes.surface();
    figures.section_surface += sizes.surface() * cell.section_count;
    figures.face_surface += sizes.surface() * faces;
    PortalSides portals(building, scene, figures);
    portals.add(cell, cell.floor, sizes.floor);
    portals.add(cell, cell.ceiling, sizes.floor);
    for (std::uint32_t s = cell.first_section; s < end; ++s) {
        const double length = section_length(scene, cell, s);
        double z = cell.z_floor;
        for (std::uint32_t f = scene.section_tails[s].first_face; f < scene.section_tails[s + 1].first_face; ++f) {
            portals.add(cell, scene.side_faces[f].target, length * (scene.side_faces[f].z_top - z));
            z = scene.side_faces[f].z_top;
        }
    }
}

}  // namespace

CutFigures cut_figures(const modeler::Building& building, const accel::Scene& scene) {
    const accel::SceneView& view = scene.view();
    const accel::SceneStats stats = accel::stats(scene);
    CutFigures figures;
    figures.rooms = stats.rooms;
    figures.cells = stats.cells;
    figures.sections = stats.sections;
    figures.side_faces = stats.side_faces;
    for (const accel::SceneArray& array : scene.arrays()) {
        if (array.group != accel::Group::Trace) continue;
        constexpr std::uint64_t step = accel::scene_file_alignment;
        const std::uint64_t bytes = (array.bytes.size() + 2 * step - 1) / step * step;  // zeros follow each array
        figures.trace_bytes += bytes;
        if (std::find(walk_arrays.begin(), walk_arrays.end(), array.name) != walk_arrays.end())
            figures.walk_bytes += bytes;
    }
    for (const accel::Cell& cell : view.cells) add_cell(building, view, cell, figures);
    return figures;
}

}  // namespace enfilade::tools
