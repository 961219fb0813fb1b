#pragma once
// Rooms with lamps and surfaces of known reflectance, without plans.

#include <array>
#include <vector>

#include "accel/scene.h"
#include "accel/scene_input.h"

namespace enfilade::test {

/// Closed: 6 x 4 x 3 m from the origin on; no light gets out.
[[nodiscard]] accel::SceneInput closed_room();

/// Closed: three rooms of different size and height, doors between them, all walls of the grid turned by `turn`.
[[nodiscard]] accel::SceneInput closed_rooms(double turn = 0);

/// All surfaces of that reflectance, by linear RGB.
void paint(accel::SceneInput& input, std::array<float, 3> colour);

/// Adds a lamp of that many candela. radius: metres; 0: a point
void hang(accel::SceneInput& input, std::array<double, 3> position, std::array<float, 3> candela, double radius = 0);

}  // namespace enfilade::test
