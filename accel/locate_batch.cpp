// Many points: what was found for one is where the next one is looked for.

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

#include "accel/locate.h"

namespace enfilade::accel {
namespace {

using Point = std::array<double, 3>;

constexpr std::size_t points_a_chunk = 4096;
constexpr std::size_t least_places = 64;
constexpr std::size_t most_places = std::size_t(1) << 20;

/// The cell that was found last for each place of a grid over the scene, shared by all threads. Whoever reads it asks
/// the cell itself, so what stands there decides how long a search takes, and nothing else.
class Hints {
public:
    Hints(const SceneView& view, std::size_t point_count) {
        const LocatorNode& all = view.locator_nodes[0];
        std::array<double, 3> size;
        double volume = 1;
        for (int k = 0; k < 3; ++k) {
            low_[k] = all.low[k];
            size[k] = std::max(double{all.high[k]} - double{all.low[k]}, view.unit);
            volume *= size[k];
        }
        const std::size_t wanted =
            std::clamp(std::min(8 * view.cells.size(), point_count / 4), least_places, most_places);
        const double edge = std::cbrt(volume / double(wanted));
        std::size_t count = 1;
        for (int k = 0; k < 3; ++k) {
            counts_[k] = std::clamp(std::floor(size[k] / edge), 1.0, 1024.0);
            per_metre_[k] = counts_[k] / size[k];
            count *= std::size_t(counts_[k]);
        }
        cells_ = std::make_unique<std::atomic<std::uint32_t>[]>(count);
        for (std::size_t i = 0; i < count; ++i) cells_[i].store(no_cell, std::memory_order_relaxed);
    }

    /// Of a point anywhere, NaN and infinity included.
    [[nodiscard]] std::atomic<std::uint32_t>& at(const Point& p) const {
        std::size_t place = 0;
        for (int k = 2; k >= 0; --k) {
            const double step = (p[k] - low_[k]) * per_metre_[k];
            const double inside = step > 0 ? std::min(step, counts_[k] - 1) : 0;
            place = place * std::size_t(counts_[k]) + std::size_t(inside);
        }
        return cells_[place];
    }

    static constexpr auto no_cell = static_cast<std::uint32_t>(none<CellId>);

private:
    std::array<double, 3> low_, per_metre_, counts_;
    std::unique_ptr<std::atomic<std::uint32_t>[]> cells_;
};

/// The cell beyond a portal of `id` that holds the point; none<CellId> if there is none.
CellId neighbour_with(const SceneView& view, CellId id, const Point& p) {
    const Cell& cell = view.cells[index(id)];
    const auto holds = [&](Target target) { return target.is_portal() && contains(view, target.neighbour(), p); };
    if (p[2] < double{cell.z_floor}) return holds(cell.floor) ? cell.floor.neighbour() : none<CellId>;
    if (p[2] >= double{cell.z_ceiling}) return holds(cell.ceiling) ? cell.ceiling.neighbour() : none<CellId>;
    const std::uint32_t end = view.section_tails[cell.first_section + cell.section_count].first_face;
    for (std::uint32_t face = view.section_tails[cell.first_section].first_face; face < end; ++face)
        if (holds(view.side_faces[face].target)) return view.side_faces[face].target.neighbour();
    return none<CellId>;
}

void locate_chunk(const SceneView& view, const Hints& hints, std::span<const Point> points, std::span<CellId> cells) {
    CellId last = none<CellId>;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& p = points[i];
        if (last != none<CellId> && contains(view, last, p)) {
            cells[i] = last;
            continue;
        }
        std::atomic<std::uint32_t>& hint = hints.at(p);
        const auto near = static_cast<CellId>(hint.load(std::memory_order_relaxed));
        CellId found = none<CellId>;
        if (near != none<CellId> && near != last) {
            if (contains(view, near, p)) found = near;
            else found = neighbour_with(view, near, p);
        }
        if (found == none<CellId>) found = locate(view, p).value_or(none<CellId>);
        cells[i] = found;
        if (found == none<CellId>) continue;
        last = found;
        if (found != near) hint.store(static_cast<std::uint32_t>(found), std::memory_order_relaxed);
    }
}

}  // namespace

void locate(const SceneView& view, std::span<const std::array<double, 3>> points, std::span<CellId> cells,
            const Executor* executor) {
    const SerialExecutor serial;
    if (points.empty()) return;
    if (view.locator_nodes.size() == 0) {
        std::fill(cells.begin(), cells.end(), none<CellId>);
        return;
    }
    const Hints hints(view, points.size());
    parallel_for(executor != nullptr ? *executor : serial, points.size(), points_a_chunk,
                 [&](std::size_t begin, std::size_t end) {
                     locate_chunk(view, hints, points.subspan(begin, end - begin), cells.subspan(begin, end - begin));
                 });
}

}  // namespace enfilade::accel
