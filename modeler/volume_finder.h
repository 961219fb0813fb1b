#pragma once
// Which volume of a building holds a place: rooms and solids alike.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "modeler/building.h"
#include "plans/box_index.h"

namespace enfilade::modeler {

/// Decides as the scene does (`accel::locate`): a place on the border of two volumes belongs to one of them.
class VolumeFinder {
public:
    /// `building` must outlive it. Cost: linear
    explicit VolumeFinder(const Building& building);

    /// The volume that holds a place (metres of the plan, z as storeys' elevations), before others one that carries
    /// light; none<> off the site.
    [[nodiscard]] std::uint32_t at(const std::array<double, 3>& place) const;

    /// Whether a volume of that space holds the place.
    [[nodiscard]] bool holds(std::uint32_t space, const std::array<double, 3>& place) const;

private:
    template <class Visit>
    void visit_holding(const std::array<double, 3>& place, const Visit& visit) const;

    const Building& building_;
    std::vector<std::uint32_t> first_volume_;  ///< [piece + 1]
    std::vector<std::uint32_t> volumes_;       ///< by piece
    std::optional<plans::BoxIndex> index_;     ///< of pieces, in grid units
};

}  // namespace enfilade::modeler
