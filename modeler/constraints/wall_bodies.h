#pragma once
// Where the plan has solid walls, by their axes and thickness alone: what a doubtful place of the model is held
// against.

#include <cstdint>
#include <optional>
#include <vector>

#include "plans/box_index.h"
#include "plans/outline.h"
#include "plans/plan.h"

namespace enfilade::modeler {

[[nodiscard]] plans::WallAxis axis_of(const plans::Wall& wall);

/// Named, so that a length and an index are not taken for each other.
struct BodySearch {
    double grown = 0;                   ///< metres by which walls are thicker on both sides: 0.01 at most, or negative
    std::uint32_t except = UINT32_MAX;  ///< a wall that is left out
};

/// The walls and columns of one storey. Lengths in metres.
class WallBodies {
public:
    explicit WallBodies(const plans::Storey& storey);

    /// The wall whose body holds a point; walls.size() + k for column k; nothing where it is free.
    [[nodiscard]] std::optional<std::uint32_t> at(plans::Point point, const BodySearch& search = {}) const;
    /// Whether a wall, no column, holds a point.
    [[nodiscard]] bool wall_at(plans::Point point, std::uint32_t except) const {
        const auto found = at(point, {.except = except});
        return found && *found < axes_.size();
    }

private:
    const plans::Storey& storey_;
    std::vector<plans::WallAxis> axes_;
    plans::BoxIndex index_;  ///< walls, then columns
};

/// Signed distances of a point from the middle of an opening, in metres: along the wall's axis, and to its left.
struct OpeningOffset {
    double along = 0;
    double left = 0;
};
[[nodiscard]] OpeningOffset offset_from(const plans::WallAxis& axis, const plans::Opening& opening, plans::Point point);

/// Whether p lies inside the polygon.
[[nodiscard]] bool holds(const std::vector<plans::Point>& polygon, plans::Point p);

}  // namespace enfilade::modeler
