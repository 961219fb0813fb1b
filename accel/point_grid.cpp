#include "accel/point_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace enfilade::accel {
namespace {

using Point = std::array<double, 3>;

constexpr std::size_t points_a_chunk = 4096;
constexpr double places_a_cell = 32;
constexpr double most_places = 1 << 22;
constexpr double most_places_along = 2048;

}  // namespace

PointGrid::Box PointGrid::box_of(const SceneView& view, const Cell& cell) {
    Box box = {{INFINITY, INFINITY, cell.z_floor}, {-INFINITY, -INFINITY, cell.z_ceiling}};
    for (std::uint32_t s = cell.first_section; s < cell.first_section + cell.section_count; ++s) {
        box.low = {std::min(box.low[0], double{view.section_x[s]}), std::min(box.low[1], double{view.section_y[s]}),
                   box.low[2]};
        box.high = {std::max(box.high[0], double{view.section_x[s]}), std::max(box.high[1], double{view.section_y[s]}),
                    box.high[2]};
    }
    for (int k = 0; k < 3; ++k) {
        box.low[k] -= view.unit;
        box.high[k] += view.unit;
    }
    return box;
}

PointGrid::PointGrid(const SceneView& view) : view_(view) {
    if (view.locator_nodes.size() > 0) {
        const LocatorNode& all = view.locator_nodes[0];
        Point size;
        for (int k = 0; k < 3; ++k) {
            low_[k] = all.low[k];
            size[k] = std::max(double{all.high[k]} - double{all.low[k]}, view.unit);
        }
        const double wanted = std::min(places_a_cell * double(view.cells.size()), most_places);
        const double edge = std::cbrt(size[0] * size[1] * size[2] / wanted);
        for (int k = 0; k < 3; ++k) {
            counts_[k] = std::uint32_t(std::clamp(std::floor(size[k] / edge), 1.0, most_places_along));
            per_metre_[k] = counts_[k] / size[k];
        }
    }
    boxes_.reserve(view.cells.size());
    for (const Cell& cell : view.cells) boxes_.push_back(box_of(view, cell));
    first_.assign(std::size_t(counts_[0]) * counts_[1] * counts_[2] + 1, 0);
    const auto for_each_place = [&](const Cell& cell, const auto& visit) {
        const Box& box = boxes_[std::size_t(&cell - view.cells.data())];
        for (std::uint32_t z = place(2, box.low[2]); z <= place(2, box.high[2]); ++z)
            for (std::uint32_t y = place(1, box.low[1]); y <= place(1, box.high[1]); ++y)
                for (std::uint32_t x = place(0, box.low[0]); x <= place(0, box.high[0]); ++x)
                    visit((std::size_t(z) * counts_[1] + y) * counts_[0] + x);
    };
    for (const Cell& cell : view.cells) for_each_place(cell, [&](std::size_t at) { ++first_[at + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    cells_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t c = 0; c < view.cells.size(); ++c)
        for_each_place(view.cells[c], [&](std::size_t at) { cells_[next[at]++] = static_cast<CellId>(c); });
}

std::uint32_t PointGrid::place(int axis, double metres) const {
    const double step = (metres - low_[axis]) * per_metre_[axis];
    return step > 0 ? std::uint32_t(std::min(step, double(counts_[axis] - 1))) : 0;
}

CellId PointGrid::find(const Point& p, CellId near) const {
    if (near != none<CellId> && boxes_[index(near)].holds(p) && contains(view_, near, p)) return near;
    const std::size_t at = (std::size_t(place(2, p[2])) * counts_[1] + place(1, p[1])) * counts_[0] + place(0, p[0]);
    bool is_near = false;
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k) {
        if (!boxes_[index(cells_[k])].holds(p)) continue;
        if (contains(view_, cells_[k], p)) return cells_[k];
        is_near = true;
    }
    if (!is_near) return none<CellId>;
    // Within rounding of a corner `locate` decides.
    const double tolerance = view_.unit / 1024;
    for (std::uint32_t k = first_[at]; k < first_[at + 1]; ++k)
        if (boxes_[index(cells_[k])].holds(p) && depth(view_, cells_[k], p) > -tolerance)
            return locate(view_, p).value_or(none<CellId>);
    return none<CellId>;
}

void PointGrid::find(std::span<const Point> points, std::span<CellId> cells, const Executor* executor) const {
    const SerialExecutor serial;
    parallel_for(executor != nullptr ? *executor : serial, points.size(), points_a_chunk,
                 [&](std::size_t begin, std::size_t end) {
                     CellId near = none<CellId>;
                     for (std::size_t i = begin; i < end; ++i) {
                         cells[i] = find(points[i], near);
                         if (cells[i] != none<CellId>) near = cells[i];
                     }
                 });
}

void locate(const SceneView& view, std::span<const Point> points, std::span<CellId> cells, const Executor* executor) {
    if (points.size() > view.cells.size()) return PointGrid(view).find(points, cells, executor);
    CellId near = none<CellId>;
    for (std::size_t i = 0; i < points.size(); ++i) {
        cells[i] = near != none<CellId> && contains(view, near, points[i])
                       ? near
                       : locate(view, points[i]).value_or(none<CellId>);
        if (cells[i] != none<CellId>) near = cells[i];
    }
}

}  // namespace enfilade::accel
