#include "accel/locate.h"

#include "accel/cell_at_point.h"

namespace enfilade::accel {

double depth(const SceneView& view, CellId id, const std::array<double, 3>& p) {
    return depth_in_cell(view, static_cast<std::uint32_t>(id), p.data());
}

bool contains(const SceneView& view, CellId id, const std::array<double, 3>& point) {
    return cell_holds_point(view, static_cast<std::uint32_t>(id), point.data());
}

std::optional<CellId> locate(const SceneView& view, const std::array<double, 3>& point) {
    const std::uint32_t cell = cell_at_point(view, point.data());
    if (cell == no_cell_at_point) return std::nullopt;
    return static_cast<CellId>(cell);
}

}  // namespace enfilade::accel
