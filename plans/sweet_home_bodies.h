#pragma once
// Walls of one storey as bodies that a door's box is laid over.

#include <cstdint>
#include <vector>

#include "plans/outline.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// A rectangle in the plan by its middle, the direction of its width, and its size.
struct PlanRectangle {
    Point middle;
    Point along{1, 0};  ///< unit vector
    double width = 0;
    double depth = 0;

    [[nodiscard]] std::vector<Point> corners() const;
    /// Coordinates of a place: x along the width, y to its left, from the middle.
    [[nodiscard]] Point local(Point p) const;
};

/// The part of the convex polygon inside the rectangle; empty where they do not meet.
[[nodiscard]] std::vector<Point> clipped(const std::vector<Point>& convex, const PlanRectangle& rectangle);

/// A wall with its axis and its body as convex pieces: one for a straight wall, one per chord of an arc.
struct WallBody {
    explicit WallBody(const Wall& wall);

    WallAxis axis;
    double half = 0;  ///< of the thickness
    double height = 0;
    Point min;  ///< box around the body
    Point max;
    std::vector<std::vector<Point>> pieces;
    bool usable = false;  ///< it has a length

    /// Unit vector of the axis at the share t.
    [[nodiscard]] Point along(double t) const;
    [[nodiscard]] double overlap(const PlanRectangle& rectangle) const;
    /// Distance along the axis of the place on it nearest to p; beyond the ends of straight walls it goes on.
    [[nodiscard]] double offset_of(Point p) const;
    [[nodiscard]] bool meets(Point low, Point high) const {
        return usable && min.x <= high.x && max.x >= low.x && min.y <= high.y && max.y >= low.y;
    }
};

}  // namespace enfilade::plans
