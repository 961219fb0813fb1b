#include "modeler/exports/scene_measure.h"

#include <cmath>

namespace enfilade::modeler {

namespace {

struct Corner {
    double x;
    double y;
};

/// Corner `k` of the cell's floor, after the last one the first again.
Corner corner(const accel::SceneView& scene, const accel::Cell& cell, std::uint32_t k) {
    const std::uint32_t section = cell.first_section + (k == cell.section_count ? 0 : k);
    return {scene.section_x[section], scene.section_y[section]};
}

}  // namespace

CellMeasure measure(const accel::SceneView& scene, accel::CellId id) {
    const accel::Cell& cell = scene.cells[index(id)];
    const Corner origin = corner(scene, cell, 0);
    double area2 = 0;
    double x = 0;
    double y = 0;
    for (std::uint32_t k = 1; k + 1 < cell.section_count; ++k) {
        const Corner p = corner(scene, cell, k);
        const Corner q = corner(scene, cell, k + 1);
        const double part = (p.x - origin.x) * (q.y - origin.y) - (p.y - origin.y) * (q.x - origin.x);
        area2 += part;
        x += part * (origin.x + p.x + q.x) / 3;
        y += part * (origin.y + p.y + q.y) / 3;
    }
    const double height = double(cell.z_ceiling) - cell.z_floor;
    return {area2 / 2, area2 / 2 * height, {x / area2, y / area2, (double(cell.z_floor) + cell.z_ceiling) / 2}};
}

std::vector<double> portal_areas(const accel::SceneView& scene) {
    std::vector<double> areas(scene.portals.size());
    for (std::size_t c = 0; c < scene.cells.size(); ++c) {
        const accel::Cell& cell = scene.cells[c];
        // Each portal is seen from both its cells: counted from the one in front.
        const auto add = [&](accel::PortalId portal, double area) {
            if (portal != none<accel::PortalId> && index(scene.portals[index(portal)].front) == c)
                areas[index(portal)] += area;
        };
        const double floor = measure(scene, accel::CellId(c)).floor_area;
        add(scene.cell_portals[c].floor, floor);
        add(scene.cell_portals[c].ceiling, floor);
        for (std::uint32_t k = 0; k < cell.section_count; ++k) {
            const Corner p = corner(scene, cell, k);
            const Corner q = corner(scene, cell, k + 1);
            const double width = std::hypot(q.x - p.x, q.y - p.y);
            double low = cell.z_floor;
            const std::uint32_t section = cell.first_section + k;
            for (std::uint32_t f = scene.section_tails[section].first_face;
                 f < scene.section_tails[section + 1].first_face; ++f) {
                add(scene.side_face_portals[f], width * (scene.side_faces[f].z_top - low));
                low = scene.side_faces[f].z_top;
            }
        }
    }
    return areas;
}

}  // namespace enfilade::modeler
