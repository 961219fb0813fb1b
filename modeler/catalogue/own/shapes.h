#pragma once
// The shapes that pieces are put together from: all closed, outward, rounder with more detail.

#include <span>
#include <vector>

#include "modeler/catalogue/own/shaper.h"

namespace enfilade::modeler::own {

// Straight things.

/// A box with rounded edges (a bevel at detail 1); sharp where `radius` is 0.
void block(Shaper& shaper, Vec low, Vec high, const Paint& paint, double radius = 0.003);
/// A straight leg from `from` to `to`, cut level at both ends, tapering: half widths along x and y of the two ends.
void post(Shaper& shaper, Vec from, Vec to, Vec half_from, Vec half_to, const Paint& paint, double radius = 0.003);
/// A round bar with slightly rounded ends. `plain`: its sides at detail 1.
void rod(Shaper& shaper, Vec from, Vec to, double radius_from, double radius_to, const Paint& paint, int plain = 12);
/// An upright board from `left` to `right` (middles of its ends) that bows back, towards +y, by `bow` in its middle.
void slat(Shaper& shaper, Vec left, Vec right, double bow, double half_height, double half_thickness,
          const Paint& paint);
/// Corners (x, y) of an outline from z = low to z = high, its upper and lower edges bevelled where it is convex enough.
void plate(Shaper& shaper, std::span<const Vec> outline, double low, double high, const Paint& paint, double bevel = 0);

// Round things.

/// Turned about the z axis: (x: radius, z) from one end to the other, as it comes; no radius at an end closes it. A
/// profile may come back inside: then the thing is hollow. `plain`: sides at detail 1.
void lathe(Shaper& shaper, std::span<const Vec> profile, const Paint& paint, int plain = 24);
void ball(Shaper& shaper, Vec centre, Vec radii, const Paint& paint, int plain = 16);
/// A disc or drum on z with rounded edges.
void drum(Shaper& shaper, Vec bottom, double radius, double height, const Paint& paint, double edge = 0.003,
          int plain = 24);
/// Along `path` with a radius at each of its points (the last one holds for the rest).
void tube(Shaper& shaper, std::span<const Vec> path, std::span<const double> radii, const Paint& paint, int plain = 8,
          Ends ends = Ends::Capped);
void tube(Shaper& shaper, std::span<const Vec> path, double radius, const Paint& paint, int plain = 8,
          Ends ends = Ends::Capped);

// Soft things.

/// A seat cushion: a rounded rectangle in plan (corner radius), crowned above and below. `softness` from 0.2 (a firm
/// block) to 1 (an egg).
void cushion(Shaper& shaper, Vec centre, Vec half, double corner, double softness, const Paint& paint);
/// A pillow: full in the middle, drawn out to thin corners; it lies flat.
void pillow(Shaper& shaper, Vec centre, Vec half, const Paint& paint);

// Things with walls.

/// A vessel whose rim is a rounded rectangle: outer half sizes at the bottom and the rim, a wall, a hollow with a
/// rounded floor. It stands on z = bottom.
struct Vessel {
    Vec half_bottom;  ///< x, y
    Vec half_rim;
    double bottom = 0;
    double rim = 1;
    double floor = 0.1;  ///< of the hollow, above `bottom`
    double wall = 0.04;  ///< between the rims
    double slope = 0.6;  ///< hollow's floor over its rim
    double corner = 1;   ///< 0 ... 1: a box ... an ellipse
    int plain = 24;      ///< sides at detail 1
};
void vessel(Shaper& shaper, const Vessel& shape, const Paint& paint);

// Living things.

/// A leaf along its midrib: half width at the points of `rib`, folded up along the rib by `fold` (0: flat) with its
/// upper side towards `up`.
void leaf(Shaper& shaper, std::span<const Vec> rib, std::span<const double> half_widths, Vec up, double fold,
          double thickness, const Paint& paint);

// Rings and curves.

/// A rounded rectangle about `centre` in the plane z = centre.z, counter-clockwise.
[[nodiscard]] Ring rounded_rectangle(Vec centre, double half_x, double half_y, double radius, int corner_steps,
                                     int side_steps = 1);
/// An ellipse likewise.
[[nodiscard]] Ring ellipse(Vec centre, double radius_x, double radius_y, int sides);
/// A curve through `points` (Catmull-Rom), `steps` parts between two of them.
[[nodiscard]] std::vector<Vec> curve(std::span<const Vec> points, int steps);

}  // namespace enfilade::modeler::own
