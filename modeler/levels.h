#pragma once
// The horizontal layers of a site, from the storeys' elevations.

#include <cstdint>
#include <vector>

#include "base/finding.h"
#include "plans/layout.h"
#include "plans/plan.h"

namespace enfilade::modeler {

enum class LevelKind : std::uint8_t {
    Open,  ///< ground or air over the whole site
    Slab,  ///< between two storeys, under the lowest or over the highest
    Storey,
};

struct Level {
    LevelKind kind = LevelKind::Open;
    std::int32_t z_low = 0;
    std::int32_t z_high = 0;
    std::uint32_t storey = UINT32_MAX;        ///< storey or, of slabs, the storey above; into Layout::storeys
    std::uint32_t storey_below = UINT32_MAX;  ///< of slabs
};

struct Levels {
    std::vector<Level> bands;           ///< bottom to top, without gaps
    std::vector<std::int32_t> floor;    ///< [storey]
    std::vector<std::int32_t> ceiling;  ///< [storey]
    std::int32_t ground = 0;            ///< exterior above, ground below
};

/// Storeys leave out of the plan what cannot be stacked: a storey without room for people over the one below it.
/// Returns the indices of the storeys to keep, by ascending elevation; each one left out gives an Error (P401).
[[nodiscard]] std::vector<std::uint32_t> stackable(const plans::Plan& plan, const std::vector<std::uint32_t>& chosen,
                                                   std::vector<Finding>& findings);

/// The ceiling of a storey is the lower of its own height and the underside of the next floor's slab. \pre the layout's
/// storeys are `stackable`.
[[nodiscard]] Levels find_levels(const plans::Plan& plan, const plans::Layout& layout, std::vector<Finding>& findings);

}  // namespace enfilade::modeler
