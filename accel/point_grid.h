#pragma once
// Which cell each of many points lies in.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/locate.h"

namespace enfilade::accel {

/// A grid over a scene, each place with the cells that reach into it. It answers what `locate` answers, exactly: for
/// scattered points four times as fast (README.md), after it was built (0.1 us a cell) with some 100 bytes a cell.
class PointGrid {
public:
    /// `view` must live as long.
    explicit PointGrid(const SceneView& view);

    /// The cell that holds the point, none<CellId> where there is none. `near` is asked first: any cell, or none.
    [[nodiscard]] CellId find(const std::array<double, 3>& point, CellId near = none<CellId>) const;

    /// cells[i] is that of points[i]. cells: [points.size()]
    void find(std::span<const std::array<double, 3>> points, std::span<CellId> cells,
              const Executor* executor = nullptr) const;

private:
    /// What a point has to lie in for the cell to be asked, by `locate` too where it tolerates rounding.
    struct Box {
        std::array<double, 3> low, high;
        [[nodiscard]] bool holds(const std::array<double, 3>& p) const {
            return p[0] >= low[0] && p[0] <= high[0] && p[1] >= low[1] && p[1] <= high[1] && p[2] >= low[2] &&
                   p[2] <= high[2];
        }
    };
    static Box box_of(const SceneView& view, const Cell& cell);

    /// Along one axis, of any number, NaN and infinities included: those get a place, too.
    [[nodiscard]] std::uint32_t place(int axis, double metres) const;

    SceneView view_;
    std::array<double, 3> low_ = {}, per_metre_ = {};
    std::array<std::uint32_t, 3> counts_ = {1, 1, 1};
    std::vector<std::uint32_t> first_;  ///< [places + 1] into cells_
    std::vector<CellId> cells_;         ///< ascending in each place
    std::vector<Box> boxes_;            ///< [cell_count]
};

}  // namespace enfilade::accel
