#include "modeler/objects/object_cells.h"

#include <algorithm>
#include <cmath>

namespace enfilade::modeler {
namespace {

// Grid units. Cells deviate from convex prisms by one, and a tracer's placements are rounded.
constexpr double touching = 4;
// What reaches less into a doorway is no thing in it: a millimetre, at the usual grid.
constexpr double reaching = -8;

}  // namespace

/// A box in grid units.
struct ObjectCellFinder::GridBox {
    std::array<double, 4> x, y;  ///< corners, counter-clockwise
    std::array<double, 4> bounds;
    double z_low, z_high;

    GridBox(const ObjectBox& box, const plans::GridFrame& frame)
        : z_low((box.z_low - frame.origin_z) / frame.unit), z_high((box.z_high - frame.origin_z) / frame.unit) {
        for (std::size_t k = 0; k < 4; ++k) {
            x[k] = (box.footprint[k].x - frame.origin_x) / frame.unit;
            y[k] = (box.footprint[k].y - frame.origin_y) / frame.unit;
        }
        bounds = {*std::min_element(x.begin(), x.end()), *std::max_element(x.begin(), x.end()),
                  *std::min_element(y.begin(), y.end()), *std::max_element(y.begin(), y.end())};
    }
};

ObjectCellFinder::ObjectCellFinder(const accel::SceneInput& input, const plans::GridFrame& frame)
    : input_(input),
      frame_(frame),
      bounds_(input.cells.size()),
      of_space_(input.spaces.size()),
      first_neighbour_(input.cells.size() + 1) {
    for (std::uint32_t c = 0; c < input.cells.size(); ++c) {
        of_space_[input.cells[c].space].push_back(c);
        std::array<std::int32_t, 4>& bounds = bounds_[c];
        bounds = {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MIN};
        const std::size_t end = c + 1 < input.cells.size() ? input.cells[c + 1].first_section : input.sections.size();
        for (std::size_t s = input.cells[c].first_section; s < end; ++s) {
            const accel::InputSection& section = input.sections[s];
            bounds = {std::min(bounds[0], section.x), std::max(bounds[1], section.x), std::min(bounds[2], section.y),
                      std::max(bounds[3], section.y)};
        }
    }
    const auto for_each_passage = [&](auto visit) {
        for (const accel::InputPortal& portal : input.portals)
            if (portal.kind != accel::PortalKind::Glass)
                visit(portal.front, portal.back), visit(portal.back, portal.front);
    };
    for_each_passage([&](std::uint32_t from, std::uint32_t) { ++first_neighbour_[from + 1]; });
    for (std::size_t c = 1; c < first_neighbour_.size(); ++c) first_neighbour_[c] += first_neighbour_[c - 1];
    neighbours_.resize(first_neighbour_.back());
    std::vector<std::uint32_t> next(first_neighbour_.begin(), first_neighbour_.end() - 1);
    for_each_passage([&](std::uint32_t from, std::uint32_t to) { neighbours_[next[from]++] = to; });
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
    const std::size_t end =
        cell + 1 < input_.cells.size() ? input_.cells[cell + 1].first_section : input_.sections.size();
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

std::vector<std::uint32_t> ObjectCellFinder::cells_of(const ObjectBox& box, std::uint32_t space) const {
    const GridBox grid(box, frame_);
    std::vector<std::uint32_t> found;
    if (space >= of_space_.size()) return found;
    for (const std::uint32_t cell : of_space_[space])
        if (meets(grid, cell, touching)) found.push_back(cell);
    for (std::size_t at = 0; at < found.size(); ++at)
        for (std::uint32_t k = first_neighbour_[found[at]]; k < first_neighbour_[found[at] + 1]; ++k) {
            const std::uint32_t cell = neighbours_[k];
            if (meets(grid, cell, reaching) && std::find(found.begin(), found.end(), cell) == found.end())
                found.push_back(cell);
        }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace enfilade::modeler
