#pragma once
// Pieces of furniture, walls and the sweeps of doors as upright prisms, and how far two of them reach into each other.

#include <cstdint>
#include <vector>

#include "plans/box_index.h"
#include "plans/plan.h"

namespace enfilade::modeler {

/// A convex polygon, counter-clockwise. Metres.
using Footprint = std::vector<plans::Point>;

/// What stands over a footprint, between two heights above the storey's floor.
struct UprightBody {
    Footprint footprint;
    double z_low = 0;
    double z_high = 0;
};

/// The turned box of a piece.
[[nodiscard]] UprightBody body_of(const plans::Furniture& piece);

/// The strip from a to b, `half` to both sides.
[[nodiscard]] Footprint strip(plans::Point a, plans::Point b, double half);

/// How far one of the two has to be moved to come free of the other: 0 where they are disjoint or touch.
/// (Separating axes; Gottschalk, Lin, Manocha 1996, in two dimensions.)
[[nodiscard]] double depth_in(const Footprint& a, const Footprint& b);

/// Metres of height that both share; 0 or less where one is above the other.
[[nodiscard]] double shared_height(const UprightBody& a, const UprightBody& b);

/// The part of `a` that lies in `b`; empty where they are disjoint. `a` may be any simple polygon.
[[nodiscard]] Footprint shared(const Footprint& a, const Footprint& b);

[[nodiscard]] double area_of(const Footprint& polygon);
[[nodiscard]] plans::Point middle_of(const Footprint& polygon);
[[nodiscard]] plans::PlanBox box_around(const Footprint& polygon);

/// How far inside the footprint a point lies; negative outside.
[[nodiscard]] double depth_of(plans::Point p, const Footprint& footprint);

}  // namespace enfilade::modeler
