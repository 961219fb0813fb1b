#include "modeler/objects/object_cells.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {
namespace {

// Grid units. Cells deviate from convex prisms by one, and a tracer's placements are rounded.
constexpr double touching = 4;
// What reaches less into a doorway is no thing in it: a millimetre, at the usual grid.
constexpr double reaching = 8;

}  // namespace

/// A box in grid units.
struct ObjectCellFinder::GridBox {
    std::array<double, 4> x, y;  ///< corners, counter-clockwise
    std::array<double, 4> bounds;
    double z_low, z_high;
    double depth;  ///< by which it has to reach into a place to be in it

    GridBox(const ObjectBox& box, const plans::GridFrame& frame)
        : z_low((box.z_low - frame.origin_z) / frame.unit), z_high((box.z_high - frame.origin_z) / frame.unit) {
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = (box.footprint[k].x - frame.origin_x) / frame.unit;
            y[k] = (box.footprint[k].y - frame.origin_y) / frame.unit;
        }
        bounds = {*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()),
                  *std::min_element(y.begin(), y.end()), *std::max_element(y.begin(), y.end())};
        const double least =
            std::min({std::hypot(x[1] - x[0], y[1] - y[0]), std::hypot(x[2] - x[1], y[2] - y[1]), z_high - z_low});
        depth = std::min(reaching, least / 4);
    }

    /// Whether part of the line from a to b, longer than `depth`, lies inside the footprint.
    [[nodiscard]] bool goes_through(const accel::InputSection& a, const accel::InputSection& b) const {
        const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
        double enter = 0, leave = 1;
        for (std::size_t k = 0; k < 4; ++k) {
            const double nx = y[(k + 1) % 4] - y[k], ny = x[k] - x[(k + 1) % 4];
            const double outside = (a.x - x[k]) * nx + (a.y - y[k]) * ny, rate = dx * nx + dy * ny;
            if (rate == 0 && outside > 0) return false;
            if (rate < 0) enter = std::max(enter, -outside / rate);
            if (rate > 0) leave = std::min(leave, -outside / rate);
        }
        return (leave - enter) * std::hypot(dx, dy) > depth;
    }
};

std::size_t ObjectCellFinder::last_section(std::uint32_t cell) const {
    return cell + 1 < input_.cells.size() ? input_.cells[cell + 1].first_section : input_.sections.size();
}

ObjectCellFinder::ObjectCellFinder(const accel::SceneInput& input, const plans::GridFrame& frame)
    : input_(input), frame_(frame), bounds_(input.cells.size()), of_space_(input.spaces.size()) {
    for (std::uint32_t c = 0; c < input.cells.size(); ++c) {
        of_space_[input.cells[c].space].push_back(c);
        std::array<std::int32_t, 4>& bounds = bounds_[c];
        bounds = {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN};
        for (std::size_t s = input.cells[c].first_section; s < last_section(c); ++s) {
            const accel::InputSection& section = input.sections[s];
            bounds = {std::min(bounds[0], section.x), std::max(bounds[1], section.x), std::min(bounds[2], section.y),
                      std::max(bounds[3], section.y)};
        }
    }
}

/// No axis of box or cell parts them by more than the margin. Cells need not be quite convex: their hulls count.
bool ObjectCellFinder::meets(const GridBox& box, std::uint32_t cell, double margin) const {
    const accel::InputCell& prism = input_.cells[cell];
    if (box.z_low > prism.z_ceiling + margin || box.z_high < prism.z_floor - margin) return false;
    const std::array<std::int32_t, 4>& bounds = bounds_[cell];
    if (box.bounds[0] > bounds[1] + margin || box.bounds[1] < bounds[0] - margin ||
        box.bounds[2] > bounds[3] + margin || box.bounds[3] < bounds[2] - margin)
        return false;
    const std::size_t first = prism.first_section;
    const std::size_t end = last_section(cell);
    // Outward normals of the cell: a corner of the box has to lie within each.
    for (std::size_t s = first; s < end; ++s) {
        const accel::InputSection& a = input_.sections[s];
        const accel::InputSection& b = input_.sections[s + 1 < end ? s + 1 : first];
        const double nx = double(b.y) - a.y, ny = double(a.x) - b.x;
        double nearest = INFINITY;
        for (std::size_t k = 0; k < 4; ++k) nearest = std::min(nearest, (box.x[k] - a.x) * nx + (box.y[k] - a.y) * ny);
        if (nearest > margin * std::hypot(nx, ny)) return false;
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const double nx = box.y[(k + 1) % 4] - box.y[k], ny = box.x[k] - box.x[(k + 1) % 4];
        double nearest = INFINITY;
        for (std::size_t s = first; s < end; ++s)
            nearest =
                std::min(nearest, (input_.sections[s].x - box.x[k]) * nx + (input_.sections[s].y - box.y[k]) * ny);
        if (nearest > margin * std::hypot(nx, ny)) return false;
    }
    return true;
}

void ObjectCellFinder::add_neighbours(const GridBox& box, std::uint32_t cell, std::vector<std::uint32_t>& found) const {
    const accel::InputCell& prism = input_.cells[cell];
    const auto add = [&](const accel::InputTarget& target) {
        const accel::InputPortal& portal = input_.portals[target.index];
        if (portal.kind == accel::PortalKind::Glass) return;
        const std::uint32_t other = portal.front == cell ? portal.back : portal.front;
        if (meets(box, other, -box.depth) && std::find(found.begin(), found.end(), other) == found.end())
            found.push_back(other);
    };
    if (prism.floor.is_portal) add(prism.floor);
    if (prism.ceiling.is_portal) add(prism.ceiling);
    const std::size_t first = prism.first_section, end = last_section(cell);
    for (std::size_t s = first; s < end; ++s) {
        const accel::InputSection& a = input_.sections[s];
        if (!box.goes_through(a, input_.sections[s + 1 < end ? s + 1 : first])) continue;
        const std::size_t last =
            s + 1 < input_.sections.size() ? input_.sections[s + 1].first_face : input_.side_faces.size();
        std::int32_t z = prism.z_floor;
        for (std::size_t f = a.first_face; f < last; ++f) {
            const accel::InputSideFace& face = input_.side_faces[f];
            const bool is_at_height = box.z_low + box.depth <= face.z_top && box.z_high - box.depth >= z;
            if (face.target.is_portal && is_at_height) add(face.target);
            z = face.z_top;
        }
    }
}

std::vector<std::uint32_t> ObjectCellFinder::cells_of(const ObjectBox& box, std::uint32_t space) const {
    const GridBox grid(box, frame_);
    std::vector<std::uint32_t> found;
    if (space >= of_space_.size()) return found;
    for (const std::uint32_t cell : of_space_[space])
        if (meets(grid, cell, touching)) found.push_back(cell);
    for (std::size_t at = 0; at < found.size(); ++at) add_neighbours(grid, found[at], found);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace enfilade::modeler
