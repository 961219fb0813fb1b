#pragma once
// Picking a place for a fault, and saying where it was.

#include <cmath>
#include <optional>
#include <string>
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

/// A fault of a whole volume: anywhere inside its box will do.
inline InjectedFault fault_at(const modeler::Building& building, std::string code, std::uint32_t volume) {
    const modeler::Volume& row = building.volumes[volume];
    const modeler::Piece& piece = building.pieces[row.piece];
    double low[3] = {HUGE_VAL, HUGE_VAL, double(row.z_low)}, high[3] = {-HUGE_VAL, -HUGE_VAL, double(row.z_high)};
    for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
        const plans::GridPoint p = building.points[building.corners[piece.first_corner + k].vertex];
        low[0] = std::min(low[0], double(p.x)), high[0] = std::max(high[0], double(p.x));
        low[1] = std::min(low[1], double(p.y)), high[1] = std::max(high[1], double(p.y));
    }
    const double unit = building.frame.unit;
    InjectedFault fault{.code = std::move(code)};
    fault.point = {building.frame.origin_x + unit * (low[0] + high[0]) / 2,
                   building.frame.origin_y + unit * (low[1] + high[1]) / 2,
                   building.frame.origin_z + unit * (low[2] + high[2]) / 2};
    fault.reach = unit * std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2 + 0.001;
    return fault;
}

}  // namespace enfilade::testing
