#pragma once
// A building's furniture in its scene.

#include "accel/scene_input.h"
#include "modeler/building.h"

namespace enfilade::modeler {

/// Adds the meshes and objects of `building.furnishing` to its scene: their materials (equal ones once) behind those of
/// walls, their places in the scene's frame, and for each cell the objects that are seen in it (README.md).
/// \pre input: of this building, complete but for the objects. Cost: linear in the meshes; objects times the cells of
/// their rooms
void add_objects(const Building& building, accel::SceneInput& input);

}  // namespace enfilade::modeler
