#pragma once
// Walls of one storey as bodies that a door's box is laid over.

#include <cstdint>
#include <optional>
#include <vector>

#include "plans/box_index.h"
#include "plans/outline.h"
#include "plans/plan.h"

namespace enfilade::plans {

/// A rectangle in the plan by its middle, the direction of its width, and its size.
struct PlanRectangle {
    Point middle;
    Point along{1, 0};  ///< unit vector
    double width = 0;
    double depth = 0;

    /// Coordinates of a place: x along the width, y to its left, from the middle.
    [[nodiscard]] Point local(Point p) const;
};

/// The smallest box in the rectangle's coordinates around what it has in common with something.
using LocalBox = PlanBox;

/// A wall with its axis and its body as convex pieces: one for a straight wall, one per chord of an arc.
struct WallBody {
    explicit WallBody(const Wall& wall);

    WallAxis axis;
    double half = 0;    ///< of the thickness
    double height = 0;  ///< of its higher end
    PlanBox box;
    std::vector<std::vector<Point>> pieces;  ///< none where the wall has no length

    [[nodiscard]] bool usable() const { return !pieces.empty(); }
    /// Unit vector of the axis at the share t.
    [[nodiscard]] Point along(double t) const;
    /// Area in common with the rectangle.
    [[nodiscard]] double overlap(const PlanRectangle& rectangle) const;
    /// Extent of what is in common with the rectangle; empty where nothing is.
    [[nodiscard]] LocalBox extent_in(const PlanRectangle& rectangle) const;
    /// Distance along the axis of the place on it nearest to p; beyond the ends of straight walls it goes on.
    [[nodiscard]] double offset_of(Point p) const;
    /// Distance of p from the axis between its ends.
    [[nodiscard]] double distance_of(Point p) const;
    /// Whether p lies beside the axis, not beyond its ends.
    [[nodiscard]] bool beside(Point p, double tolerance) const;
};

/// All walls of a storey, and which of them are near a place.
class StoreyBodies {
public:
    /// `reach`: how far from a place a wall may be to count as near.
    StoreyBodies(const Storey& storey, double reach);

    [[nodiscard]] const WallBody& operator[](std::size_t wall) const { return bodies_[wall]; }
    /// Indices of the usable walls near p, ascending; walls added later are always near.
    [[nodiscard]] std::vector<std::size_t> near(Point p) const;
    void add(const Wall& wall) { bodies_.emplace_back(wall); }

private:
    std::vector<WallBody> bodies_;
    std::size_t indexed_;
    BoxIndex index_;
};

}  // namespace enfilade::plans
