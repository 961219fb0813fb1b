#pragma once
// Areas, volumes and middles of what a scene is made of.

#include <array>
#include <vector>

#include "accel/scene.h"

namespace enfilade::modeler {

/// Metres, in the frame of the scene.
struct CellMeasure {
    double floor_area = 0;
    double volume = 0;
    std::array<double, 3> centre = {};  ///< of mass: inside the cell, as cells are convex
};

[[nodiscard]] CellMeasure measure(const accel::SceneView& scene, accel::CellId cell);

/// Area of each portal, in square metres. [portal_count]
[[nodiscard]] std::vector<double> portal_areas(const accel::SceneView& scene);

}  // namespace enfilade::modeler
