#pragma once
// Footprints of boxes on the grid.

#include <span>
#include <vector>

#include "modeler/editing/box.h"
#include "plans/noding.h"

namespace enfilade::modeler {

/// A rectangle turned by any angle, rounded outward: the least of the rectangles around it whose corners, rounded to
/// the grid, hold it. Centre, width (along the angle) and depth in metres of the plan's frame, angle in radians.
[[nodiscard]] std::vector<plans::GridPoint> rectangle_footprint(const plans::GridFrame& frame, double centre_x,
                                                                double centre_y, double width, double depth,
                                                                double angle);

/// At least three points, turning left or straight on at each, once around.
[[nodiscard]] bool is_convex_ring(std::span<const plans::GridPoint> ring);

/// Area over half the perimeter: of a long strip its width.
[[nodiscard]] double thickness(std::span<const plans::GridPoint> ring);

/// The ring with corners that lie within `least_thickness` of an end of a wall's side, or else of the side itself, put
/// there: a box drawn against a wall shares its side, with no splinter of floor between. Rings hardly thicker than that
/// stay as they are.
[[nodiscard]] std::vector<plans::GridPoint> snapped(std::span<const plans::GridPoint> ring,
                                                    std::span<const plans::Segment> sides);

}  // namespace enfilade::modeler
