#pragma once
// Buildings without plans: a partition of a rectangle into rectangles, each with a stack of solid and light layers,
// turned into a SceneInput. Independent of plans and modeler, so that accel and render are tested alone.

#include <cstdint>
#include <vector>

#include "accel/scene_input.h"

namespace enfilade::test {

/// A horizontal slice of a plot. What is between two layers, below the first and above the last is solid.
struct Layer {
    std::int32_t z_floor = 0;
    std::int32_t z_ceiling = 0;
    accel::Label label = accel::Label::Room;
    std::uint32_t space = 0;
};

/// A convex piece of the site, corners counter-clockwise; touching plots may have corners on each other's sides.
struct Plot {
    std::int32_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    std::vector<Layer> layers;  ///< ascending
};

struct SyntheticOptions {
    int rooms_per_row = 5;
    int rows = 2;  ///< of rooms; rows face each other across corridors, two by two
    int storeys = 1;
    bool doors = true;  ///< else every room is closed
    double turn = 0;  ///< radians by which the whole building is turned before rounding to the grid: walls become bent
};

/// Metres to grid units of 2^-13 m.
[[nodiscard]] std::int32_t grid(double metres);

/// Rooms of 4 m x 5 m with doors to corridors and windows outside, a stairwell if there are storeys, in an exterior
/// box.
[[nodiscard]] std::vector<Plot> office_plots(const SyntheticOptions& options);

/// One cell per light layer of each plot; cells in plot order. Sides are cut where neighbours begin and end. All solid
/// faces of one space on one level are merged into rings where they form discs, sides of one plot's edge are one face
/// per stretch of solid. `turn` in radians.
[[nodiscard]] accel::SceneInput scene_from_plots(const std::vector<Plot>& plots, double turn = 0);

/// `scene_from_plots(office_plots(options), options.turn)`.
[[nodiscard]] accel::SceneInput synthetic_office(const SyntheticOptions& options);

/// `count` rooms of 0.3 m x 2 m, 0.4 m apart along x, joined by doors 1 m wide and 2 m high: one sees through them all.
[[nodiscard]] accel::SceneInput synthetic_corridor(int count);

}  // namespace enfilade::test
