#include "accel/locate.h"

#include <algorithm>
#include <cmath>

namespace enfilade::accel {
namespace {

using Point = std::array<double, 3>;

struct Edge {
    double ax, ay, bx, by;
};

/// Twice the signed area of (a, b, p): positive inside, i.e. left of the edge. The edge is always evaluated from its
/// lexicographically smaller end, so that the cells on both sides see the same number negated.
double side(const Edge& e, const Point& p) {
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
bool is_crossed(const Edge& e, const Point& p) {
    const bool upwards = e.by >= p[1];
    if ((e.ay >= p[1]) == upwards) return false;
    const double s = side(e, p);
    return upwards ? s >= 0 : s <= 0;
}

template <class Visit>
void for_each_edge(const SceneView& view, const Cell& cell, const Visit& visit) {
    for (std::uint32_t i = 0; i < cell.section_count; ++i) {
        const std::uint32_t a = cell.first_section + i;
        const std::uint32_t b = i + 1 == cell.section_count ? cell.first_section : a + 1;
        visit(Edge{view.section_x[a], view.section_y[a], view.section_x[b], view.section_y[b]});
    }
}

/// Calls visit(cell) for the cells in whose boxes, enlarged by `margin`, the point lies.
template <class Visit>
void visit_candidates(const SceneView& view, const Point& p, double margin, const Visit& visit) {
    std::size_t i = 0;
    while (i < view.locator_nodes.size()) {
        const LocatorNode& node = view.locator_nodes[i];
        bool inside = true;
        for (int k = 0; k < 3; ++k)
            inside = inside && p[k] >= double{node.low[k]} - margin && p[k] <= double{node.high[k]} + margin;
        if (!inside) {
            i = node.skip;
            continue;
        }
        const std::uint32_t first = node.first_and_count >> 3;
        for (std::uint32_t k = 0; k < (node.first_and_count & 7u); ++k) visit(view.locator_cells[first + k]);
        ++i;
    }
}

}  // namespace

double depth(const SceneView& view, CellId id, const std::array<double, 3>& p) {
    const Cell& cell = view.cells[index(id)];
    double least = std::min(p[2] - double{cell.z_floor}, double{cell.z_ceiling} - p[2]);
    for_each_edge(view, cell, [&](const Edge& e) {
        const double length = std::max(std::abs(e.bx - e.ax), std::abs(e.by - e.ay));
        if (length > 0) least = std::min(least, side(e, p) / length);
    });
    return least;
}

bool contains(const SceneView& view, CellId id, const std::array<double, 3>& point) {
    const Cell& cell = view.cells[index(id)];
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
            inside ^= is_crossed({view.section_x[a], view.section_y[a], view.section_x[b], view.section_y[b]}, point);
        a = b;
        is_a_above = is_b_above;
    }
    return inside;
}

std::optional<CellId> locate(const SceneView& view, const std::array<double, 3>& point) {
    std::optional<CellId> found;
    visit_candidates(view, point, 0, [&](CellId id) {
        if ((!found || id < *found) && contains(view, id, point)) found = id;
    });
    if (found) return found;
    // Off the grid, rounding may leave a point at a corner to none of its cells: the one it is deepest in takes it.
    const double tolerance = view.unit / 1024;
    double deepest = -tolerance;
    visit_candidates(view, point, tolerance, [&](CellId id) {
        const double at = depth(view, id, point);
        if (at > deepest || (found && at == deepest && id < *found)) {
            deepest = at;
            found = id;
        }
    });
    return found;
}

}  // namespace enfilade::accel
