#pragma once
// Which cell holds a point (locate.h), for host and device.

#include <cstddef>
#include <cstdint>

#include "accel/scene.h"

namespace enfilade::accel {

/// No cell holds the point.
inline constexpr std::uint32_t no_cell_at_point = 0xffffffffu;

/// A side of a cell on the plan.
struct PlanEdge {
    double ax, ay, bx, by;
};

/// Twice the signed area of (a, b, p): positive inside, i.e. left of the edge. The edge is always evaluated from its
/// lexicographically smaller end, so that the cells on both sides see the same number negated. p: [3]
ENFILADE_HD double side_of_edge(const PlanEdge& e, const double* p) {
    const bool flipped = e.bx < e.ax || (e.bx == e.ax && e.by < e.ay);
    const double ax = flipped ? e.bx : e.ax;
    const double ay = flipped ? e.by : e.ay;
    const double bx = flipped ? e.ax : e.bx;
    const double by = flipped ? e.ay : e.by;
    const double area = (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax);
    return flipped ? -area : area;
}

/// Whether a half-line from p + (-e^2, -e^3) towards +x crosses the edge. Counting crossings instead of asking every
/// half-plane: rounding to the grid may have bent a side inwards by a unit.
ENFILADE_HD bool is_edge_crossed(const PlanEdge& e, const double* p) {
    const bool upwards = e.by >= p[1];
    if ((e.ay >= p[1]) == upwards) return false;
    const double s = side_of_edge(e, p);
    return upwards ? s >= 0 : s <= 0;
}

/// Whether that cell holds the point, by the rule of `locate`.
ENFILADE_HD bool cell_holds_point(const SceneView& view, std::uint32_t id, const double* point) {
    const Cell& cell = view.cells[id];
    if (!(point[2] >= double{cell.z_floor}) || !(point[2] < double{cell.z_ceiling})) return false;
    // Of the cell's sides only the two that the point's y lies between (or a few of them) are looked at closely.
    const float* ys = view.section_y.data() + cell.first_section;
    const std::uint32_t last = cell.first_section + cell.section_count - 1;
    bool inside = false;
    std::uint32_t a = last;
    bool is_a_above = view.section_y[last] >= point[1];
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const bool is_b_above = ys[i] >= point[1];
        const std::uint32_t b = cell.first_section + i;
        if (is_a_above != is_b_above)
            inside ^=
                is_edge_crossed({view.section_x[a], view.section_y[a], view.section_x[b], view.section_y[b]}, point);
        a = b;
        is_a_above = is_b_above;
    }
    return inside;
}

/// Least distance (metres, about) from the point to the cell's planes, positive inside.
ENFILADE_HD double depth_in_cell(const SceneView& view, std::uint32_t id, const double* p) {
    const Cell& cell = view.cells[id];
    const double above = p[2] - double{cell.z_floor}, below = double{cell.z_ceiling} - p[2];
    double least = below < above ? below : above;
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t a = cell.first_section + i;
        const std::uint32_t b = i + 1 == cell.section_count ? cell.first_section : a + 1;
        const PlanEdge e = {view.section_x[a], view.section_y[a], view.section_x[b], view.section_y[b]};
        const double dx = e.bx < e.ax ? e.ax - e.bx : e.bx - e.ax, dy = e.by < e.ay ? e.ay - e.by : e.by - e.ay;
        const double length = dx < dy ? dy : dx;
        if (!(length > 0)) continue;
        const double depth = side_of_edge(e, p) / length;
        least = depth < least ? depth : least;
    }
    return least;
}

/// Calls visit(cell) for the cells in whose boxes, enlarged by `margin`, the point lies.
template <class Visit>
ENFILADE_HD void visit_boxes_at(const SceneView& view, const double* p, double margin, const Visit& visit) {
    std::uint32_t i = 0;
    while (i < view.locator_nodes.count) {
        const LocatorNode& node = view.locator_nodes[i];
        const auto *low = reinterpret_cast<const float*>(&node.low), *high = reinterpret_cast<const float*>(&node.high);
        bool inside = true;
        for (int k = 0; k < 3; ++k)
            inside = inside && p[k] >= double{low[k]} - margin && p[k] <= double{high[k]} + margin;
        if (!inside) {
            i = node.skip;
            continue;
        }
        const std::uint32_t first = node.first_and_count >> 3;
        for (std::uint32_t k = 0; k < (node.first_and_count & 7u); ++k)
            visit(static_cast<std::uint32_t>(view.locator_cells[first + k]));
        ++i;
    }
}

/// The cell that `locate` tells, or no_cell_at_point. point: [3], metres, scene frame
ENFILADE_HD std::uint32_t cell_at_point(const SceneView& view, const double* point) {
    std::uint32_t found = no_cell_at_point;
    visit_boxes_at(view, point, 0, [&](std::uint32_t id) {
        if (id < found && cell_holds_point(view, id, point)) found = id;
    });
    if (found != no_cell_at_point) return found;
    // Off the grid, rounding may leave a point at a corner to none of its cells: the one it is deepest in takes it.
    const double tolerance = view.unit / 1024;
    double deepest = -tolerance;
    visit_boxes_at(view, point, tolerance, [&](std::uint32_t id) {
        const double at = depth_in_cell(view, id, point);
        if (at > deepest || (found != no_cell_at_point && at == deepest && id < found)) {
            deepest = at;
            found = id;
        }
    });
    return found;
}

}  // namespace enfilade::accel
