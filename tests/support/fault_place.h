#pragma once
// Picking a place for a fault, and saying where it was.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modeler/building.h"
#include "plans/random.h"
#include "tests/support/injected_fault.h"

namespace enfilade::testing {

/// One of the volumes for which `fits(volume)`, or nothing.
template <class Fits>
std::optional<std::uint32_t> pick(const modeler::Building& building, plans::Random& random, Fits fits) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < building.volumes.size(); ++v)
        if (fits(v)) found.push_back(v);
    if (found.empty()) return std::nullopt;
    return found[random.below(std::uint32_t(found.size()))];
}

inline double site_diagonal(const modeler::Building& building) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += std::pow(building.frame.unit * (double(building.site_max[i]) - building.site_min[i]), 2);
    return std::sqrt(sum);
}

/// The box around a piece, in grid units.
inline std::pair<plans::GridPoint, plans::GridPoint> box_of(const modeler::Building& building, std::uint32_t piece) {
    const modeler::Piece& row = building.pieces[piece];
    plans::GridPoint low{INT32_MAX, INT32_MAX}, high{INT32_MIN, INT32_MIN};
    for (std::uint32_t k = 0; k < row.corner_count; ++k) {
        const plans::GridPoint p = building.points[building.corners[row.first_corner + k].vertex];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    return {low, high};
}

/// A fault of a whole volume: anywhere inside its box will do.
inline InjectedFault fault_at(const modeler::Building& building, std::string code, std::uint32_t volume) {
    const modeler::Volume& row = building.volumes[volume];
    const auto [low, high] = box_of(building, row.piece);
    const double unit = building.frame.unit;
    InjectedFault fault{.code = std::move(code)};
    fault.point = {building.frame.origin_x + unit * (double(low.x) + high.x) / 2,
                   building.frame.origin_y + unit * (double(low.y) + high.y) / 2,
                   building.frame.origin_z + unit * (double(row.z_low) + row.z_high) / 2};
    fault.reach =
        unit * std::hypot(double(high.x) - low.x, double(high.y) - low.y, double(row.z_high) - row.z_low) / 2 + 0.001;
    return fault;
}

}  // namespace enfilade::testing
