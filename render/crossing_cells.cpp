#include "render/crossing_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "accel/locate.h"
#include "render/line_boxes.h"
#include "render/walk.h"

namespace enfilade::render::detail {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

[[nodiscard]] bool meets(const LineBoxes& line, const accel::SceneView& scene, const accel::LocatorNode& node,
                         double from, double to) {
    const double margin = scene.unit;
    return line.meets({node.low[0] - margin, node.low[1] - margin, node.low[2] - margin},
                      {node.high[0] + margin, node.high[1] + margin, node.high[2] + margin}, from, to);
}

/// The part of the line between the cell's sides. Grid rounding may bend a side, so that there are two ways in.
bool clip_by_sides(const accel::SceneView& scene, const Ray<double>& ray, const accel::Cell& cell,
                   CellStretch& stretch) {
    stretch.enter = infinite;
    stretch.leave = -infinite;
    const std::uint32_t last = cell.first_section + cell.section_count - 1;
    std::uint32_t p = last;
    const auto is_left = [&](double side) { return side > 0 || (side == 0 && ray.zero_mask != 0); };
    double p_side = line_side<double>(ray, scene.section_x[last], scene.section_y[last]);
    for (std::uint32_t q = cell.first_section; q <= last; p = q++) {
        const double q_side = line_side<double>(ray, scene.section_x[q], scene.section_y[q]);
        const bool enters = is_left(p_side) && !is_left(q_side), leaves = !is_left(p_side) && is_left(q_side);
        if (enters || leaves) {
            const double px = scene.section_x[p], py = scene.section_y[p];
            const double qx = scene.section_x[q], qy = scene.section_y[q];
            const Crossing<double> at =
                enters ? crossing(ray, qx, qy, q_side, px, py, p_side) : crossing(ray, px, py, p_side, qx, qy, q_side);
            const double t = at.num / at.den;
            if (enters && t < stretch.enter) {
                stretch.enter = t;
                stretch.section = p;
                stretch.next_section = q;
            }
            if (leaves) stretch.leave = std::max(stretch.leave, t);
        }
        p_side = q_side;
    }
    return stretch.enter < stretch.leave;
}

/// The part of the line between `from` and `to` that runs through the cell.
bool clip_by_cell(const accel::SceneView& scene, const Ray<double>& ray, std::uint32_t id, double from, double to,
                  CellStretch& stretch) {
    const accel::Cell& cell = scene.cells[id];
    const double dz = ray.direction.z, oz = ray.origin.z;
    double level_enter = -infinite, level_leave = infinite;
    if (dz == 0) {
        if (!(oz >= cell.z_floor && oz < cell.z_ceiling)) return false;
    } else {
        const double floor = (cell.z_floor - oz) / dz, ceiling = (cell.z_ceiling - oz) / dz;
        level_enter = dz > 0 ? floor : ceiling;
        level_leave = dz > 0 ? ceiling : floor;
        if (!(level_leave > from) || !(level_enter < to)) return false;
    }
    stretch = {-infinite, infinite, id, Exit::Side, no_section, no_section};
    if (ray.direction.x == 0 && ray.direction.y == 0) {
        if (!accel::contains(scene, accel::CellId(id), {ray.origin.x, ray.origin.y, cell.z_floor})) return false;
    } else if (!clip_by_sides(scene, ray, cell, stretch)) {
        return false;
    }
    // Levels are shifted down by a vanishing amount: what falls meets them later, what rises sooner.
    if (dz < 0 ? stretch.enter <= level_enter : stretch.enter < level_enter) {
        stretch.enter = level_enter;
        stretch.by = dz > 0 ? Exit::Floor : Exit::Ceiling;
    }
    stretch.leave = std::min(stretch.leave, level_leave);
    return stretch.enter < stretch.leave && stretch.leave > from && stretch.enter < to;
}

}  // namespace

void cells_along(const accel::SceneView& scene, const Ray<double>& ray, double from, double to,
                 std::vector<CellStretch>& found) {
    found.clear();
    const LineBoxes line(ray);
    for (std::size_t i = 0; i < scene.locator_nodes.size();) {
        const accel::LocatorNode& node = scene.locator_nodes[i];
        if (!meets(line, scene, node, from, to)) {
            i = node.skip;
            continue;
        }
        const std::uint32_t first = node.first_and_count >> 3;
        for (std::uint32_t k = 0; k < (node.first_and_count & 7u); ++k) {
            CellStretch stretch;
            const auto id = std::uint32_t(index(scene.locator_cells[first + k]));
            if (clip_by_cell(scene, ray, id, from, to, stretch)) found.push_back(stretch);
        }
        ++i;
    }
    std::sort(found.begin(), found.end(), [](const CellStretch& a, const CellStretch& b) {
        if (a.enter != b.enter) return a.enter < b.enter;
        return a.leave != b.leave ? a.leave < b.leave : a.cell < b.cell;
    });
}

accel::Target target_behind(const accel::SceneView& scene, const Ray<double>& ray, const CellStretch& stretch) {
    const accel::Cell& cell = scene.cells[stretch.cell];
    const accel::Target level = ray.direction.z < 0 ? cell.ceiling : cell.floor;
    if (stretch.by != Exit::Side || stretch.section == no_section) return level;
    const double z = ray.origin.z + stretch.enter * ray.direction.z;
    const std::uint32_t bottom = scene.section_tails[stretch.section].first_face;
    const std::uint32_t top = scene.section_tails[stretch.section + 1].first_face - 1;
    std::uint32_t face = bottom;
    while (face < top && !(z < scene.side_faces[face].z_top)) ++face;
    const accel::Target target = scene.side_faces[face].target;
    if (!target.is_portal()) return target;
    // Within rounding of an edge: behind a solid the line comes from the solid face beside it.
    const float z_bottom = face == bottom ? cell.z_floor : scene.side_faces[face - 1].z_top;
    const bool is_upper = scene.side_faces[face].z_top - z < z - z_bottom;
    if (is_upper) return face < top ? scene.side_faces[face + 1].target : cell.ceiling;
    return face > bottom ? scene.side_faces[face - 1].target : cell.floor;
}

double depth_behind(const accel::SceneView& scene, const Ray<double>& ray, const CellStretch& stretch) {
    const accel::Cell& cell = scene.cells[stretch.cell];
    if (stretch.by == Exit::Floor) return cell.z_floor - ray.origin.z;
    if (stretch.by == Exit::Ceiling) return ray.origin.z - cell.z_ceiling;
    if (stretch.section == no_section) return infinite;
    const double px = scene.section_x[stretch.section], py = scene.section_y[stretch.section];
    const double ex = scene.section_x[stretch.next_section] - px, ey = scene.section_y[stretch.next_section] - py;
    return (ex * (py - ray.origin.y) - ey * (px - ray.origin.x)) / std::hypot(ex, ey);
}

}  // namespace enfilade::render::detail
